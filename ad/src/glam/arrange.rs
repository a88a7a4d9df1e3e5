//! The rules of what arranges the elements of glam's vectors and matrices: swizzles, conversions from and
//! to arrays and tuples, functions that make vectors. All of it is linear.

use glam::{
    DQuat, DVec2, DVec3, DVec4, Quat, Vec2, Vec2Swizzles, Vec3, Vec3Swizzles, Vec4, Vec4Swizzles,
};

use super::kin::Kin;
use super::vector::{Vec2Rules, Vec4Rules};
use crate::rules::conversion::conversions;
use crate::rules::linear::{Linear, Maps};
use crate::rules::row::rules;
use crate::rules::{FromRules, Vector3Rules};
use crate::{Additive, Tangent};

/// The rules of swizzles, each by the elements of what it makes. The adjoint adds each number to the element
/// that it is one of.
macro_rules! swizzles {
    ($(#[$doc:meta])* $rules:ident: $($type:ident)*; $($made:ident: $($($element:ident)+),*;)*) => {
        pastey::paste! {
            rules! {
                $(#[$doc])*
                $rules: Kin for $($type)* {$($(
                    [<$($element)+>](v) -> Self::$made: |cotangent| {
                        let mut parts = cotangent.to_array().into_iter();
                        let mut to_vector = Self::zero();
                        $(to_vector.$element += parts.next().expect("has as many elements");)+
                        to_vector
                    };
                )*)*}
            }
        }
    };
}

swizzles! {
    /// The rules of swizzles of vectors of two elements.
    Swizzle2Rules: Vec2 DVec2;
    V2: x x, x y, y x, y y;
}

swizzles! {
    /// The rules of swizzles of vectors of three elements.
    Swizzle3Rules: Vec3 DVec3;
    V2: x x, x y, x z, y x, y y, y z, z x, z y, z z;
    V3: x y z, x z y, y x z, y z x, z x y, z y x;
}

swizzles! {
    /// The rules of swizzles of vectors of four elements.
    Swizzle4Rules: Vec4 DVec4;
    V2: x x, x y, x z, x w, y x, y y, y z, y w, z x, z y, z z, z w, w x, w y, w z, w w;
    V3: x y z, x y w, x z w, y z w;
}

rules! {
    /// The rules of the methods of vectors of two elements that replace one.
    With2Rules: Kin for Vec2 DVec2 {
        with_x(v, x: Self::S) -> Self: |g| (g.with_x(-0.0), g.x);
        with_y(v, y: Self::S) -> Self: |g| (g.with_y(-0.0), g.y);
    }
}

rules! {
    /// The rules of the methods of vectors of three elements that replace one.
    With3Rules: Kin for Vec3 DVec3 {
        with_x(v, x: Self::S) -> Self: |g| (g.with_x(-0.0), g.x);
        with_y(v, y: Self::S) -> Self: |g| (g.with_y(-0.0), g.y);
        with_z(v, z: Self::S) -> Self: |g| (g.with_z(-0.0), g.z);
    }
}

rules! {
    /// The rules of the methods of vectors of four elements that replace one.
    With4Rules: Kin for Vec4 DVec4 {
        with_x(v, x: Self::S) -> Self: |g| (g.with_x(-0.0), g.x);
        with_y(v, y: Self::S) -> Self: |g| (g.with_y(-0.0), g.y);
        with_z(v, z: Self::S) -> Self: |g| (g.with_z(-0.0), g.z);
        with_w(v, w: Self::S) -> Self: |g| (g.with_w(-0.0), g.w);
    }
}

rules! {
    /// The rules of conversions of vectors and quaternions from and to arrays.
    ArrayRules: Kin for Vec2 Vec3 Vec4 Quat DVec2 DVec3 DVec4 DQuat {
        to_array(&v) -> Self::Array: Self::from_array;
        from_array(array: Self::Array) -> Self: |g| g.to_array();
    }
}

/// Conversions between two types in both directions, each the adjoint of the other.
macro_rules! both_ways {
    ($($one:ty, $other:ty;)*) => {
        conversions! {$(
            $one => $other: Maps(From::from, From::from);
            $other => $one: Maps(From::from, From::from);
        )*}
    };
}

both_ways! {
    Vec2, [f32; 2];
    Vec3, [f32; 3];
    Vec4, [f32; 4];
    DVec2, [f64; 2];
    DVec3, [f64; 3];
    DVec4, [f64; 4];
    Vec2, (f32, f32);
    Vec3, (f32, f32, f32);
    Vec4, (f32, f32, f32, f32);
    DVec2, (f64, f64);
    DVec3, (f64, f64, f64);
    DVec4, (f64, f64, f64, f64);
}

conversions! {
    Quat => Vec4: Maps(Vec4::from, Quat::from_vec4);
    DQuat => DVec4: Maps(DVec4::from, DQuat::from_vec4);
    Vec2 => DVec2: Maps(DVec2::from, |g: DVec2| g.as_vec2());
    Vec3 => DVec3: Maps(DVec3::from, |g: DVec3| g.as_vec3());
    Vec4 => DVec4: Maps(DVec4::from, |g: DVec4| g.as_vec4());
}

/// The rules of what reads the first numbers of a slice.
pub trait SliceRules: Kin {
    /// The cotangents of the numbers that are read.
    fn from_slice_vjp(slice: &[Self::S]) -> (Self, impl FnOnce(Self) -> Vec<Self::S> + use<Self>);

    /// What the tangents make.
    fn from_slice_jvp(slice: &[Self::S], tangent: &[Self::S]) -> (Self, Self);
}

macro_rules! read_from_slices {
    ($($type:ident)*) => {$(
        impl SliceRules for $type {
            #[inline(always)]
            #[track_caller]
            fn from_slice_vjp(
                slice: &[Self::S],
            ) -> (Self, impl FnOnce(Self) -> Vec<Self::S> + use<>) {
                (Self::from_slice(slice), |cotangent: Self| cotangent.to_array().into())
            }

            #[inline(always)]
            #[track_caller]
            fn from_slice_jvp(slice: &[Self::S], tangent: &[Self::S]) -> (Self, Self) {
                (Self::from_slice(slice), Self::from_slice(tangent))
            }
        }
    )*};
}

read_from_slices!(Vec2 Vec3 Vec4 Quat DVec2 DVec3 DVec4 DQuat);

/// The derivatives of glam's functions that make vectors, which are those of `new`.
macro_rules! functions {
    ($($function:ident $type:ident($($element:ident $tangent:ident: $scalar:ident),*);)*) => {$(
        #[doc = concat!("The derivative of `glam::", stringify!($function), "`.")]
        #[doc(hidden)]
        #[allow(non_camel_case_types)]
        pub enum $function {}

        impl $function {
            /// The pullback: each argument gets the cotangent of its element.
            #[inline(always)]
            pub fn vjp($($element: $scalar),*) -> ($type, impl FnOnce($type) -> ($($scalar),*)) {
                $type::new_vjp($($element),*)
            }

            /// A vector of the tangents.
            #[inline(always)]
            pub fn jvp($($element: $scalar,)* $($tangent: $scalar),*) -> ($type, $type) {
                $type::new_jvp($($element,)* $($tangent),*)
            }

            /// The path of the function.
            pub fn named() -> &'static str {
                core::any::type_name_of_val(&glam::$function)
            }
        }
    )*};
}

functions! {
    vec2 Vec2(x u: f32, y v: f32);
    vec3 Vec3(x u: f32, y v: f32, z w: f32);
    vec4 Vec4(x u: f32, y v: f32, z s: f32, w t: f32);
    dvec2 DVec2(x u: f64, y v: f64);
    dvec3 DVec3(x u: f64, y v: f64, z w: f64);
    dvec4 DVec4(x u: f64, y v: f64, z s: f64, w t: f64);
}

/// glam's functions that make vectors, with their derivatives.
pub mod construct {
    pub use super::{dvec2, dvec3, dvec4, vec2, vec3, vec4};
    pub use glam::{dvec2, dvec3, dvec4, vec2, vec3, vec4};
}
