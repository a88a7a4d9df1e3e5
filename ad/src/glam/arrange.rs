//! The rules of what arranges the elements of glam's vectors and matrices: conversions from and to
//! arrays and tuples, functions that make vectors. All of it is linear.

use glam::{Affine2, Affine3, DAffine2, DAffine3, DMat2, DMat3, DMat4, Mat2, Mat3, Mat4};
use glam::{DQuat, DVec2, DVec3, DVec4, Quat, Vec2, Vec3, Vec3A, Vec4};

use super::kin::Kin;
use super::vector::{Vec2Rules, Vec4Rules};
use crate::Tangent;
use crate::rules::conversion::conversions;
use crate::rules::linear::{Linear, Maps};
use crate::rules::row::rules;
use crate::rules::{FromRules, Vector3Rules};

rules! {
    /// The rules of the methods of vectors of two elements that replace one.
    With2Rules: Kin for Vec2 DVec2 {
        with_x(v, x: Self::S) -> Self: |g| (g.with_x(-0.0), g.x);
        with_y(v, y: Self::S) -> Self: |g| (g.with_y(-0.0), g.y);
    }
}

rules! {
    /// The rules of the methods of vectors of three elements that replace one.
    With3Rules: Kin for Vec3 Vec3A DVec3 {
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
    ArrayRules: Kin for Vec2 Vec3 Vec3A Vec4 Quat DVec2 DVec3 DVec4 DQuat {
        to_array(&v) -> Self::Array: Self::from_array;
        from_array(array: Self::Array) -> Self: |g| g.to_array();
    }
}

rules! {
    /// The rule of what aligns a vector.
    AlignRules: Kin for Vec3 {
        to_vec3a(v) -> Vec3A: Vec3::from;
    }
}

rules! {
    /// The rules of what makes other vectors of aligned ones.
    AlignedRules: Kin for Vec3A {
        to_vec3(v) -> Vec3: Vec3A::from;
        from_vec4(v: Vec4) -> Self: |g| g.extend(-0.0);
        as_dvec3(v) -> DVec3: |g| g.as_vec3a();
    }
}

rules! {
    /// The rule of what makes an aligned vector of single precision.
    AsAlignedRules: Kin for DVec3 {
        as_vec3a(v) -> Vec3A: |g| g.as_dvec3();
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
    Vec3A, [f32; 3];
    Vec3, Vec3A;
    Vec4, [f32; 4];
    DVec2, [f64; 2];
    DVec3, [f64; 3];
    DVec4, [f64; 4];
    Vec2, (f32, f32);
    Vec3, (f32, f32, f32);
    Vec3A, (f32, f32, f32);
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

/// Traits of the rules of what reads the first numbers of a slice, each by the function and the one that gives
/// the numbers again.
macro_rules! read_from_slices {
    ($($rules:ident $read:ident $to_array:ident: $($type:ident)*;)*) => { pastey::paste! {$(
        #[doc = concat!("The rules of `", stringify!($read), "`.")]
        pub trait $rules: Kin {
            /// The cotangents of the numbers that are read.
            fn [<$read _vjp>](slice: &[Self::S]) -> (Self, impl FnOnce(Self) -> Vec<Self::S> + use<Self>);

            /// What the tangents make.
            fn [<$read _jvp>](slice: &[Self::S], tangent: &[Self::S]) -> (Self, Self);
        }

        read_from_slices!(@each $rules $read [<$read _vjp>] [<$read _jvp>] $to_array $($type)*);
    )*}};
    (@each $rules:ident $read:ident $vjp:ident $jvp:ident $to_array:ident $($type:ident)*) => {$(
        impl $rules for $type {
            #[inline(always)]
            #[track_caller]
            fn $vjp(slice: &[Self::S]) -> (Self, impl FnOnce(Self) -> Vec<Self::S> + use<>) {
                (Self::$read(slice), |cotangent: Self| cotangent.$to_array().into())
            }

            #[inline(always)]
            #[track_caller]
            fn $jvp(slice: &[Self::S], tangent: &[Self::S]) -> (Self, Self) {
                (Self::$read(slice), Self::$read(tangent))
            }
        }
    )*};
}

read_from_slices! {
    SliceRules from_slice to_array: Vec2 Vec3 Vec3A Vec4 Quat DVec2 DVec3 DVec4 DQuat;
    ColumnSliceRules from_cols_slice to_cols_array:
        Mat2 Mat3 Mat4 Affine2 Affine3 DMat2 DMat3 DMat4 DAffine2 DAffine3;
    RowSliceRules from_rows_slice to_rows_array: Mat2 Mat3 Mat4 DMat2 DMat3 DMat4;
}

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
