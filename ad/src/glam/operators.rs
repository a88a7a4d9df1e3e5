//! The operators of vectors, matrices, quaternions and affine motions.

use glam::{Affine2, Affine3, Mat2, Mat3, Mat4, Quat, Vec2, Vec3, Vec3A, Vec4};
use glam::{DAffine2, DAffine3, DMat2, DMat3, DMat4, DQuat, DVec2, DVec3, DVec4};

use super::geometry::{matrix, motion, rotation, vector};
use super::kin::Numbers;
use crate::rt::{ByValue, by_value};
use crate::rules::linear::{Linear, Same, Splat};
use crate::rules::operators::elementwise::{divided, negatives, operators, sums};
use crate::rules::operators::numbers::{denominator_cotangent, quotient_pullback};
use crate::rules::scalar::multiples;
use crate::rules::scale_vector::scale_elements;
use crate::rules::{
    AddPullback, Arithmetic, DivPullback, MulPullback, NegPullback, Nothing, RemPullback,
    SubPullback, chain,
};
use crate::vector::Vector;

by_value!(Vec2 Vec3 Vec3A Vec4 DVec2 DVec3 DVec4);
by_value!(Mat2 Mat3 Mat4 DMat2 DMat3 DMat4 Quat DQuat Affine2 Affine3 DAffine2 DAffine3);

negatives!([] Vec2, [] Vec3, [] Vec3A, [] Vec4, [] DVec2, [] DVec3, [] DVec4);
sums!([] Mat2, [] Mat3, [] Mat4, [] DMat2, [] DMat3, [] DMat4, [] Quat, [] DQuat);

operators! {
    (+ - * / %)
    [] Vec2, Vec2 => Vec2: Same(), Same();
    [] Vec3, Vec3 => Vec3: Same(), Same();
    [] Vec3A, Vec3A => Vec3A: Same(), Same();
    [] Vec4, Vec4 => Vec4: Same(), Same();
    [] DVec2, DVec2 => DVec2: Same(), Same();
    [] DVec3, DVec3 => DVec3: Same(), Same();
    [] DVec4, DVec4 => DVec4: Same(), Same();
    [] Vec2, f32 => Vec2: Same(), Splat();
    [] Vec3, f32 => Vec3: Same(), Splat();
    [] Vec3A, f32 => Vec3A: Same(), Splat();
    [] Vec4, f32 => Vec4: Same(), Splat();
    [] DVec2, f64 => DVec2: Same(), Splat();
    [] DVec3, f64 => DVec3: Same(), Splat();
    [] DVec4, f64 => DVec4: Same(), Splat();
    [] f32, Vec2 => Vec2: Splat(), Same();
    [] f32, Vec3 => Vec3: Splat(), Same();
    [] f32, Vec3A => Vec3A: Splat(), Same();
    [] f32, Vec4 => Vec4: Splat(), Same();
    [] f64, DVec2 => DVec2: Splat(), Same();
    [] f64, DVec3 => DVec3: Splat(), Same();
    [] f64, DVec4 => DVec4: Splat(), Same();
}

/// Operators by formulas. The value is that of the operator.
macro_rules! by_formula {
    ($($left:ident $operator:tt $right:ident -> $result:ident as $formula:path;)*) => {$(
        by_formula!(@$operator $left $right $result $formula);
    )*};
    (@* $($operands:tt)*) => { by_formula!(@one MulPullback mul_pullback mul_jvp * $($operands)*); };
    (@/ $($operands:tt)*) => { by_formula!(@one DivPullback div_pullback div_jvp / $($operands)*); };
    (@one $rule:ident $pullback:ident $jvp:ident $operator:tt
        $left:ident $right:ident $result:ident $formula:path) => {
        impl $rule<$right> for $left {
            #[inline(always)]
            fn $pullback(self, rhs: $right, cotangent: $result) -> (Self, $right) {
                use $formula as formula;
                let (_, pullback) = formula::vjp(self.numbers(), rhs.numbers());
                Numbers::of_numbers(pullback(cotangent.numbers()))
            }

            #[inline(always)]
            fn $jvp(
                self,
                rhs: $right,
                tangent: Self,
                rhs_tangent: $right,
            ) -> ($result, $result) {
                use $formula as formula;
                let (_, along) = formula::jvp(
                    self.numbers(),
                    rhs.numbers(),
                    tangent.numbers(),
                    rhs_tangent.numbers(),
                );
                (self $operator rhs, Numbers::of_numbers(along))
            }
        }
    };
}

by_formula! {
    Quat * Vec3A -> Vec3A as rotation::rotated;
    Mat3 * Vec3A -> Vec3A as matrix::transformed;
}

/// The same for both precisions.
macro_rules! both_precisions {
    ($($scalar:ident [$($matrix:ident $vector:ident),*] $quat:ident $v3:ident $a2:ident $a3:ident;)*) => {$(
        by_formula! {
            $(
                $matrix * $matrix -> $matrix as matrix::product;
                $matrix * $vector -> $vector as matrix::transformed;
                $matrix * $scalar -> $matrix as matrix::scaled;
                $scalar * $matrix -> $matrix as matrix::scaling;
                $matrix / $scalar -> $matrix as matrix::divided;
            )*
            $quat * $quat -> $quat as rotation::product;
            $quat * $v3 -> $v3 as rotation::rotated;
            $quat * $scalar -> $quat as vector::times;
            $quat / $scalar -> $quat as vector::quotient;
            $a2 * $a2 -> $a2 as motion::product2;
            $a3 * $a3 -> $a3 as motion::product3;
        }
    )*};
}

both_precisions! {
    f32 [Mat2 Vec2, Mat3 Vec3, Mat4 Vec4] Quat Vec3 Affine2 Affine3;
    f64 [DMat2 DVec2, DMat3 DVec3, DMat4 DVec4] DQuat DVec3 DAffine2 DAffine3;
}
