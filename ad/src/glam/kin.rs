//! The types of glam: the numbers that they are made of, and which belong together.

use glam::{Affine2, Affine3, Mat2, Mat3, Mat4, Quat, Vec2, Vec3, Vec3A, Vec4};
use glam::{DAffine2, DAffine3, DMat2, DMat3, DMat4, DQuat, DVec2, DVec3, DVec4};

use crate::{Additive, Differentiable, Real};

/// What formulas compute with: the numbers of a value.
pub trait Numbers: Sized {
    /// Arrays, and tuples of such.
    type Array: Differentiable;
    /// The numbers.
    fn numbers(self) -> Self::Array;
    /// What has these numbers.
    fn of_numbers(numbers: Self::Array) -> Self;
}

macro_rules! numbers {
    ($([$($type:ident)*] $array:ty: $to:ident, |$numbers:ident| $of:expr;)*) => {$($(
        impl Numbers for $type {
            type Array = $array;

            #[inline(always)]
            fn numbers(self) -> $array {
                self.$to()
            }

            #[inline(always)]
            fn of_numbers($numbers: $array) -> Self {
                $of
            }
        }
    )*)*};
}

macro_rules! tuples {
    ($(($($name:ident $index:tt),*))*) => {$(
        impl<$($name: Numbers),*> Numbers for ($($name,)*)
        where
            ($($name::Array,)*): Differentiable,
        {
            type Array = ($($name::Array,)*);

            #[inline(always)]
            fn numbers(self) -> Self::Array {
                ($(self.$index.numbers(),)*)
            }

            #[inline(always)]
            fn of_numbers(numbers: Self::Array) -> Self {
                ($($name::of_numbers(numbers.$index),)*)
            }
        }
    )*};
}

tuples!((A 0, B 1) (A 0, B 1, C 2) (A 0, B 1, C 2, D 3));

/// A type of glam, and those of its precision.
pub trait Kin: Numbers + Differentiable<Tangent = Self> {
    /// A number.
    type S: Real;
    /// A vector of the plane.
    type V2: Differentiable;
    /// A vector of space.
    type V3: Differentiable;
    /// A vector of four numbers.
    type V4: Differentiable;
    /// A quaternion.
    type Q: Differentiable;
    /// A matrix of two columns.
    type M2: Differentiable;
    /// A matrix of three columns.
    type M3: Differentiable;
    /// A matrix of four columns.
    type M4: Differentiable;
    /// An affine motion of space.
    type A3: Differentiable;
}

macro_rules! kin {
    ($($scalar:ident $v2:ident $v3:ident $v4:ident $q:ident $m2:ident $m3:ident $m4:ident $a2:ident $a3:ident;)*) => {$(
        numbers! {
            [$scalar] $scalar: into, |number| number;
            [$v2] [$scalar; 2]: to_array, |numbers| Self::from_array(numbers);
            [$v3] [$scalar; 3]: to_array, |numbers| Self::from_array(numbers);
            [$v4 $q] [$scalar; 4]: to_array, |numbers| Self::from_array(numbers);
            [$m2] [[$scalar; 2]; 2]: to_cols_array_2d, |columns| Self::from_cols_array_2d(&columns);
            [$m3] [[$scalar; 3]; 3]: to_cols_array_2d, |columns| Self::from_cols_array_2d(&columns);
            [$m4] [[$scalar; 4]; 4]: to_cols_array_2d, |columns| Self::from_cols_array_2d(&columns);
            [$a2] [[$scalar; 2]; 3]: to_cols_array_2d, |columns| Self::from_cols_array_2d(&columns);
            [$a3] [[$scalar; 3]; 4]: to_cols_array_2d, |columns| Self::from_cols_array_2d(&columns);
        }

        kin!(@each [$scalar $v2 $v3 $v4 $q $m2 $m3 $m4 $a3] $v2 $v3 $v4 $q $m2 $m3 $m4 $a2 $a3);
        kin!(@own_tangent $q $m2 $m3 $m4 $a2 $a3);
    )*};
    (@each $kin:tt $($type:ident)*) => { $(kin!(@one $type $kin);)* };
    (@one $type:ident [$scalar:ident $v2:ident $v3:ident $v4:ident $q:ident $m2:ident $m3:ident $m4:ident
        $a3:ident]) => {
        impl Kin for $type {
            type S = $scalar;
            type V2 = $v2;
            type V3 = $v3;
            type V4 = $v4;
            type Q = $q;
            type M2 = $m2;
            type M3 = $m3;
            type M4 = $m4;
            type A3 = $a3;
        }
    };
    (@own_tangent $($type:ident)*) => {$(
        impl Differentiable for $type {
            type Tangent = Self;
            type Shape = ();

            #[inline(always)]
            fn shape(&self) {}

            #[inline(always)]
            fn irregularity(&self) -> f64 {
                if self.is_finite() { 0.0 } else { f64::NAN }
            }
        }

        impl Additive for $type {
            #[inline(always)]
            fn zero() -> Self {
                Self::of_numbers(Additive::zero())
            }

            #[inline(always)]
            fn accumulate(&mut self, other: Self) {
                let mut numbers = self.numbers();
                numbers.accumulate(other.numbers());
                *self = Self::of_numbers(numbers);
            }
        }
    )*};
}

kin! {
    f32 Vec2 Vec3 Vec4 Quat Mat2 Mat3 Mat4 Affine2 Affine3;
    f64 DVec2 DVec3 DVec4 DQuat DMat2 DMat3 DMat4 DAffine2 DAffine3;
}

// Aligned vectors: their swizzles are aligned, too.
numbers! { [Vec3A] [f32; 3]: to_array, |numbers| Self::from_array(numbers); }
kin!(@one Vec3A [f32 Vec2 Vec3A Vec4 Quat Mat2 Mat3 Mat4 Affine3]);
