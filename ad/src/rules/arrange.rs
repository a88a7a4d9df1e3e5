//! Derivatives of the methods of glam's vectors and matrices that arrange their elements: swizzles, and
//! conversions from and to arrays. They are linear, so that a tangent goes through them as the value does.

use glam::{
    DMat2, DMat3, DMat4, DVec2, DVec3, DVec4, Mat2, Mat3, Mat4, Vec2, Vec2Swizzles, Vec3,
    Vec3Swizzles, Vec4, Vec4Swizzles,
};

use super::FromRules;
use crate::Additive;

/// The `_vjp` and `_jvp` siblings of the swizzles of one vector: each a method, the vector that it makes,
/// and the elements that this is made of.
macro_rules! swizzles {
    ($(#[$doc:meta])* $trait:ident: $($type:ident $two:ident $three:ident),*;
        $($vjp:ident $jvp:ident = $method:ident $made:ident($($element:ident)*);)*) => {
        $(#[$doc])*
        pub trait $trait: Copy {
            /// The vector of two elements.
            type Two;
            /// The vector of three elements.
            type Three;

            $(
                /// Each cotangent to the element that it is one of.
                fn $vjp(self) -> (Self::$made, impl FnOnce(Self::$made) -> Self);
                /// The tangents in the order of the elements.
                fn $jvp(self, tangent: Self) -> (Self::$made, Self::$made);
            )*
        }

        swizzles!(@each $trait [$($type $two $three),*] {
            $($vjp $jvp = $method $made($($element)*);)*
        });
    };
    (@each $trait:ident [$($type:ident $two:ident $three:ident),*] $rows:tt) => {$(
        impl $trait for $type {
            type Two = $two;
            type Three = $three;

            swizzles!(@rows $rows);
        }
    )*};
    (@rows { $($vjp:ident $jvp:ident = $method:ident $made:ident($($element:ident)*);)* }) => {$(
        #[inline(always)]
        fn $vjp(self) -> (Self::$made, impl FnOnce(Self::$made) -> Self) {
            (self.$method(), |cotangent: Self::$made| {
                let mut parts = cotangent.to_array().into_iter();
                let mut to_vector = Self::zero();
                $(to_vector.$element += parts.next().expect("has as many elements");)*
                to_vector
            })
        }

        #[inline(always)]
        fn $jvp(self, tangent: Self) -> (Self::$made, Self::$made) {
            (self.$method(), tangent.$method())
        }
    )*};
}

swizzles! {
    /// Swizzles of vectors of two elements.
    Swizzle2Rules: Vec2 Vec2 Vec3, DVec2 DVec2 DVec3;
    xx_vjp xx_jvp = xx Two(x x);
    xy_vjp xy_jvp = xy Two(x y);
    yx_vjp yx_jvp = yx Two(y x);
    yy_vjp yy_jvp = yy Two(y y);
}

swizzles! {
    /// Swizzles of vectors of three elements.
    Swizzle3Rules: Vec3 Vec2 Vec3, DVec3 DVec2 DVec3;
    xx_vjp xx_jvp = xx Two(x x);
    xy_vjp xy_jvp = xy Two(x y);
    xz_vjp xz_jvp = xz Two(x z);
    yx_vjp yx_jvp = yx Two(y x);
    yy_vjp yy_jvp = yy Two(y y);
    yz_vjp yz_jvp = yz Two(y z);
    zx_vjp zx_jvp = zx Two(z x);
    zy_vjp zy_jvp = zy Two(z y);
    zz_vjp zz_jvp = zz Two(z z);
    xyz_vjp xyz_jvp = xyz Three(x y z);
    xzy_vjp xzy_jvp = xzy Three(x z y);
    yxz_vjp yxz_jvp = yxz Three(y x z);
    yzx_vjp yzx_jvp = yzx Three(y z x);
    zxy_vjp zxy_jvp = zxy Three(z x y);
    zyx_vjp zyx_jvp = zyx Three(z y x);
}

swizzles! {
    /// Swizzles of vectors of four elements.
    Swizzle4Rules: Vec4 Vec2 Vec3, DVec4 DVec2 DVec3;
    xx_vjp xx_jvp = xx Two(x x);
    xy_vjp xy_jvp = xy Two(x y);
    xz_vjp xz_jvp = xz Two(x z);
    xw_vjp xw_jvp = xw Two(x w);
    yx_vjp yx_jvp = yx Two(y x);
    yy_vjp yy_jvp = yy Two(y y);
    yz_vjp yz_jvp = yz Two(y z);
    yw_vjp yw_jvp = yw Two(y w);
    zx_vjp zx_jvp = zx Two(z x);
    zy_vjp zy_jvp = zy Two(z y);
    zz_vjp zz_jvp = zz Two(z z);
    zw_vjp zw_jvp = zw Two(z w);
    wx_vjp wx_jvp = wx Two(w x);
    wy_vjp wy_jvp = wy Two(w y);
    wz_vjp wz_jvp = wz Two(w z);
    ww_vjp ww_jvp = ww Two(w w);
    xyz_vjp xyz_jvp = xyz Three(x y z);
    xyw_vjp xyw_jvp = xyw Three(x y w);
    xzw_vjp xzw_jvp = xzw Three(x z w);
    yzw_vjp yzw_jvp = yzw Three(y z w);
}

/// The `_vjp` and `_jvp` siblings of conversions of vectors from and to arrays.
pub trait ArrayRules: Copy {
    /// The array of its elements.
    type Array;

    /// A vector of the cotangents.
    fn to_array_vjp(&self) -> (Self::Array, impl FnOnce(Self::Array) -> Self + use<Self>);
    /// The tangents as an array.
    fn to_array_jvp(&self, tangent: Self) -> (Self::Array, Self::Array);
    /// The cotangents as an array.
    fn from_array_vjp(array: Self::Array) -> (Self, impl FnOnce(Self) -> Self::Array);
    /// A vector of the tangents.
    fn from_array_jvp(array: Self::Array, tangent: Self::Array) -> (Self, Self);
}

/// The rules of functions that arrange columns of matrices.
pub trait ColumnsRules: Copy {
    /// The array of its numbers.
    type Array;

    /// A matrix of the cotangents.
    fn to_cols_array_vjp(&self) -> (Self::Array, impl FnOnce(Self::Array) -> Self + use<Self>);
    /// The tangents as an array.
    fn to_cols_array_jvp(&self, tangent: Self) -> (Self::Array, Self::Array);
    /// The cotangents as an array.
    fn from_cols_array_vjp(
        array: &Self::Array,
    ) -> (Self, impl FnOnce(Self) -> Self::Array + use<Self>);
    /// A matrix of the tangents.
    fn from_cols_array_jvp(array: &Self::Array, tangent: &Self::Array) -> (Self, Self);
}

macro_rules! arrays {
    ($($type:ident [$scalar:ident; $len:literal]),*) => {$(
        impl ArrayRules for $type {
            type Array = [$scalar; $len];

            #[inline(always)]
            fn to_array_vjp(&self) -> (Self::Array, impl FnOnce(Self::Array) -> Self + use<>) {
                (self.to_array(), Self::from_array)
            }

            #[inline(always)]
            fn to_array_jvp(&self, tangent: Self) -> (Self::Array, Self::Array) {
                (self.to_array(), tangent.to_array())
            }

            #[inline(always)]
            fn from_array_vjp(array: Self::Array) -> (Self, impl FnOnce(Self) -> Self::Array) {
                (Self::from_array(array), |cotangent| cotangent.to_array())
            }

            #[inline(always)]
            fn from_array_jvp(array: Self::Array, tangent: Self::Array) -> (Self, Self) {
                (Self::from_array(array), Self::from_array(tangent))
            }
        }

        impl FromRules<[$scalar; $len]> for $type {
            #[inline(always)]
            fn from_vjp(array: [$scalar; $len]) -> (Self, impl FnOnce(Self) -> [$scalar; $len]) {
                Self::from_array_vjp(array)
            }

            #[inline(always)]
            fn from_jvp(array: [$scalar; $len], tangent: [$scalar; $len]) -> (Self, Self) {
                Self::from_array_jvp(array, tangent)
            }
        }

        impl FromRules<$type> for [$scalar; $len] {
            #[inline(always)]
            fn from_vjp(vector: $type) -> (Self, impl FnOnce(Self) -> $type) {
                (vector.to_array(), $type::from_array)
            }

            #[inline(always)]
            fn from_jvp(vector: $type, tangent: $type) -> (Self, Self) {
                (vector.to_array(), tangent.to_array())
            }
        }
    )*};
}

arrays!(Vec2 [f32; 2], Vec3 [f32; 3], Vec4 [f32; 4], DVec2 [f64; 2], DVec3 [f64; 3], DVec4 [f64; 4]);

macro_rules! columns {
    ($($type:ident [$scalar:ident; $len:literal]),*) => {$(
        impl ColumnsRules for $type {
            type Array = [$scalar; $len];

            #[inline(always)]
            fn to_cols_array_vjp(&self) -> (Self::Array, impl FnOnce(Self::Array) -> Self + use<>) {
                (self.to_cols_array(), |cotangent: Self::Array| Self::from_cols_array(&cotangent))
            }

            #[inline(always)]
            fn to_cols_array_jvp(&self, tangent: Self) -> (Self::Array, Self::Array) {
                (self.to_cols_array(), tangent.to_cols_array())
            }

            #[inline(always)]
            fn from_cols_array_vjp(
                array: &Self::Array,
            ) -> (Self, impl FnOnce(Self) -> Self::Array + use<>) {
                (Self::from_cols_array(array), |cotangent: Self| cotangent.to_cols_array())
            }

            #[inline(always)]
            fn from_cols_array_jvp(array: &Self::Array, tangent: &Self::Array) -> (Self, Self) {
                (Self::from_cols_array(array), Self::from_cols_array(tangent))
            }
        }
    )*};
}

columns!(
    Mat2 [f32; 4], Mat3 [f32; 9], Mat4 [f32; 16], DMat2 [f64; 4], DMat3 [f64; 9], DMat4 [f64; 16]
);

/// The `_vjp` and `_jvp` siblings of methods that replace one element.
macro_rules! replacing {
    ($(#[$doc:meta])* $trait:ident: $($type:ident $scalar:ident),*;
        $($vjp:ident $jvp:ident = $method:ident $element:ident;)*) => {
        $(#[$doc])*
        pub trait $trait: Copy {
            /// An element.
            type Scalar;

            $(
                /// The cotangents of the others, and that of the new element.
                fn $vjp(self, value: Self::Scalar) -> (Self, impl FnOnce(Self) -> (Self, Self::Scalar));
                /// The tangent of the element, too.
                fn $jvp(self, value: Self::Scalar, tangent: Self, to: Self::Scalar) -> (Self, Self);
            )*
        }

        replacing!(@each $trait [$($type $scalar),*] { $($vjp $jvp = $method $element;)* });
    };
    (@each $trait:ident [$($type:ident $scalar:ident),*] $rows:tt) => {$(
        impl $trait for $type {
            type Scalar = $scalar;

            replacing!(@rows $rows);
        }
    )*};
    (@rows { $($vjp:ident $jvp:ident = $method:ident $element:ident;)* }) => {$(
        #[inline(always)]
        fn $vjp(self, value: Self::Scalar) -> (Self, impl FnOnce(Self) -> (Self, Self::Scalar)) {
            (self.$method(value), |mut cotangent: Self| {
                let to_value = core::mem::replace(&mut cotangent.$element, Additive::zero());
                (cotangent, to_value)
            })
        }

        #[inline(always)]
        fn $jvp(self, value: Self::Scalar, tangent: Self, to: Self::Scalar) -> (Self, Self) {
            (self.$method(value), tangent.$method(to))
        }
    )*};
}

replacing! {
    /// Those of vectors of two elements.
    With2Rules: Vec2 f32, DVec2 f64;
    with_x_vjp with_x_jvp = with_x x;
    with_y_vjp with_y_jvp = with_y y;
}

replacing! {
    /// Those of vectors of three elements.
    With3Rules: Vec3 f32, DVec3 f64;
    with_x_vjp with_x_jvp = with_x x;
    with_y_vjp with_y_jvp = with_y y;
    with_z_vjp with_z_jvp = with_z z;
}

replacing! {
    /// Those of vectors of four elements.
    With4Rules: Vec4 f32, DVec4 f64;
    with_x_vjp with_x_jvp = with_x x;
    with_y_vjp with_y_jvp = with_y y;
    with_z_vjp with_z_jvp = with_z z;
    with_w_vjp with_w_jvp = with_w w;
}

/// The derivatives of glam's functions that make vectors.
macro_rules! functions {
    ($($function:ident $type:ident $scalar:ident($($element:ident $tangent:ident)*);)*) => {$(
        #[doc = concat!("The derivative of `glam::", stringify!($function), "`.")]
        #[doc(hidden)]
        #[allow(non_camel_case_types)]
        pub enum $function {}

        impl $function {
            /// The pullback: each argument gets the cotangent of its element.
            #[inline(always)]
            #[allow(clippy::type_complexity)]
            pub fn vjp(
                $($element: $scalar),*
            ) -> ($type, impl FnOnce($type) -> ($(functions!(@each $scalar $element)),*)) {
                ($type::new($($element),*), |cotangent: $type| ($(cotangent.$element),*))
            }

            /// A vector of the tangents.
            #[inline(always)]
            #[allow(clippy::too_many_arguments)]
            pub fn jvp($($element: $scalar,)* $($tangent: $scalar),*) -> ($type, $type) {
                ($type::new($($element),*), $type::new($($tangent),*))
            }

            /// The path of the function.
            pub fn named() -> &'static str {
                core::any::type_name_of_val(&glam::$function)
            }
        }
    )*};
    (@each $scalar:ident $element:ident) => { $scalar };
}

functions! {
    vec2 Vec2 f32(x x_tangent y y_tangent);
    vec3 Vec3 f32(x x_tangent y y_tangent z z_tangent);
    vec4 Vec4 f32(x x_tangent y y_tangent z z_tangent w w_tangent);
    dvec2 DVec2 f64(x x_tangent y y_tangent);
    dvec3 DVec3 f64(x x_tangent y y_tangent z z_tangent);
    dvec4 DVec4 f64(x x_tangent y y_tangent z z_tangent w w_tangent);
}

macro_rules! tuples {
    ($($type:ident ($($scalar:ident $element:ident),*);)*) => {$(
        impl FromRules<($($scalar,)*)> for $type {
            #[inline(always)]
            fn from_vjp(tuple: ($($scalar,)*)) -> (Self, impl FnOnce(Self) -> ($($scalar,)*)) {
                (Self::from(tuple), |cotangent: Self| ($(cotangent.$element,)*))
            }

            #[inline(always)]
            fn from_jvp(tuple: ($($scalar,)*), tangent: ($($scalar,)*)) -> (Self, Self) {
                (Self::from(tuple), Self::from(tangent))
            }
        }

        impl FromRules<$type> for ($($scalar,)*) {
            #[inline(always)]
            fn from_vjp(vector: $type) -> (Self, impl FnOnce(Self) -> $type) {
                (Self::from(vector), $type::from)
            }

            #[inline(always)]
            fn from_jvp(vector: $type, tangent: $type) -> (Self, Self) {
                (Self::from(vector), Self::from(tangent))
            }
        }

    )*};
}

tuples! {
    Vec2 (f32 x, f32 y);
    Vec3 (f32 x, f32 y, f32 z);
    Vec4 (f32 x, f32 y, f32 z, f32 w);
    DVec2 (f64 x, f64 y);
    DVec3 (f64 x, f64 y, f64 z);
    DVec4 (f64 x, f64 y, f64 z, f64 w);
}
