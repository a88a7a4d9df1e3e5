//! The operators of vectors, among each other and with numbers.

use glam::{DVec2, DVec3, DVec4, Vec2, Vec3, Vec4};

use super::numbers::{denominator_cotangent, quotient_pullback, quotient_tangent};
use super::{AddPullback, DivPullback, MulPullback, Nothing, SubPullback};
use crate::Real;
use crate::rules::{chain, scale, scale_elements};
use crate::vector::{Vector, Xyz};

macro_rules! vector_operators {
    ($([$($generics:tt)*] $type:ty, $scalar:ty),* $(,)?) => {$(
        impl<$($generics)*> MulPullback for $type {
            #[inline(always)]
            fn mul_pullback(self, rhs: Self, cotangent: Self) -> (Self, Self) {
                (scale_elements(cotangent, rhs), scale_elements(cotangent, self))
            }

            #[inline(always)]
            fn mul_pullback_of_finite(self, rhs: Self, cotangent: Self) -> (Self, Self) {
                (cotangent * rhs, cotangent * self)
            }

            #[inline(always)]
            fn mul_jvp(self, rhs: Self, tangent: Self, rhs_tangent: Self) -> (Self, Self) {
                let along_self = tangent.zip_elements(rhs, chain);
                (self * rhs, along_self + rhs_tangent.zip_elements(self, chain))
            }
        }

        impl<$($generics)*> MulPullback<$scalar> for $type {
            #[inline(always)]
            fn mul_pullback(self, rhs: $scalar, cotangent: Self) -> (Self, $scalar) {
                (
                    cotangent.map_elements(|g| scale(g, rhs)),
                    scale_elements(cotangent, self).element_sum(),
                )
            }

            #[inline(always)]
            fn mul_pullback_of_finite(self, rhs: $scalar, cotangent: Self) -> (Self, $scalar) {
                (cotangent * rhs, (cotangent * self).element_sum())
            }

            #[inline(always)]
            fn mul_jvp(self, rhs: $scalar, tangent: Self, rhs_tangent: $scalar) -> (Self, Self) {
                let along_vector = tangent.map_elements(|tangent| chain(tangent, rhs));
                (self * rhs, along_vector + self.map_elements(|x| chain(rhs_tangent, x)))
            }
        }

        impl<$($generics)*> DivPullback<$scalar> for $type {
            #[inline(always)]
            fn div_pullback(self, rhs: $scalar, cotangent: Self) -> (Self, $scalar) {
                let to_vector = cotangent.map_elements(|g| quotient_pullback(g, rhs, g).0);
                let quotient = self.map_elements(|numerator| numerator / rhs);
                (to_vector, to_vector.zip_elements(quotient, denominator_cotangent).element_sum())
            }

            #[inline(always)]
            fn div_jvp(self, rhs: $scalar, tangent: Self, rhs_tangent: $scalar) -> (Self, Self) {
                let quotient = self / rhs;
                let along = |quotient, tangent| quotient_tangent(quotient, rhs, tangent, rhs_tangent);
                (quotient, quotient.zip_elements(tangent, along))
            }
        }
    )*};
}

vector_operators!(
    [] Vec2, f32,
    [] Vec3, f32,
    [] Vec4, f32,
    [] DVec2, f64,
    [] DVec3, f64,
    [] DVec4, f64,
    [S: Real] Xyz<S>, S,
);

/// The operators between vectors and scalars that glam has beyond [`Vector`].
macro_rules! glam_operators {
    ($($type:ty, $scalar:ty);* $(;)?) => {$(
        impl MulPullback<$type> for $scalar {
            #[inline(always)]
            fn mul_pullback(self, rhs: $type, cotangent: $type) -> ($scalar, $type) {
                let (to_vector, to_scalar) = rhs.mul_pullback(self, cotangent);
                (to_scalar, to_vector)
            }

            #[inline(always)]
            fn mul_pullback_of_finite(self, rhs: $type, cotangent: $type) -> ($scalar, $type) {
                let (to_vector, to_scalar) = rhs.mul_pullback_of_finite(self, cotangent);
                (to_scalar, to_vector)
            }

            #[inline(always)]
            fn mul_jvp(self, rhs: $type, tangent: $scalar, rhs_tangent: $type) -> ($type, $type) {
                rhs.mul_jvp(self, rhs_tangent, tangent)
            }
        }

        impl DivPullback for $type {
            #[inline(always)]
            fn div_pullback(self, rhs: Self, cotangent: Self) -> (Self, Self) {
                let to_numerator = cotangent.zip_elements(rhs, |g, b| quotient_pullback(g, b, g).0);
                (to_numerator, to_numerator.zip_elements(self / rhs, denominator_cotangent))
            }

            #[inline(always)]
            fn div_jvp(self, rhs: Self, tangent: Self, rhs_tangent: Self) -> (Self, Self) {
                let quotient = self / rhs;
                let along = core::array::from_fn(|i| {
                    quotient_tangent(quotient[i], rhs[i], tangent[i], rhs_tangent[i])
                });
                (quotient, <$type>::from_array(along))
            }
        }

        impl DivPullback<$type> for $scalar {
            #[inline(always)]
            fn div_pullback(self, rhs: $type, cotangent: $type) -> ($scalar, $type) {
                let (to_numerator, to_denominator) =
                    <$type>::splat(self).div_pullback(rhs, cotangent);
                (to_numerator.element_sum(), to_denominator)
            }

            #[inline(always)]
            fn div_jvp(self, rhs: $type, tangent: $scalar, rhs_tangent: $type) -> ($type, $type) {
                <$type>::splat(self).div_jvp(rhs, <$type>::splat(tangent), rhs_tangent)
            }
        }

        impl AddPullback<$scalar> for $type {
            type Kept = Nothing;

            #[inline(always)]
            fn add_pullback(_: &Nothing, cotangent: $type) -> ($type, $scalar) {
                (cotangent, cotangent.element_sum())
            }

            #[inline(always)]
            fn add_jvp(self, rhs: $scalar, tangent: $type, rhs_tangent: $scalar) -> ($type, $type) {
                (self + rhs, tangent + rhs_tangent)
            }
        }

        impl SubPullback<$scalar> for $type {
            type Kept = Nothing;

            #[inline(always)]
            fn sub_pullback(_: &Nothing, cotangent: $type) -> ($type, $scalar) {
                (cotangent, -cotangent.element_sum())
            }

            #[inline(always)]
            fn sub_jvp(self, rhs: $scalar, tangent: $type, rhs_tangent: $scalar) -> ($type, $type) {
                (self - rhs, tangent - rhs_tangent)
            }
        }

        impl AddPullback<$type> for $scalar {
            type Kept = Nothing;

            #[inline(always)]
            fn add_pullback(_: &Nothing, cotangent: $type) -> ($scalar, $type) {
                (cotangent.element_sum(), cotangent)
            }

            #[inline(always)]
            fn add_jvp(self, rhs: $type, tangent: $scalar, rhs_tangent: $type) -> ($type, $type) {
                (self + rhs, tangent + rhs_tangent)
            }
        }

        impl SubPullback<$type> for $scalar {
            type Kept = Nothing;

            #[inline(always)]
            fn sub_pullback(_: &Nothing, cotangent: $type) -> ($scalar, $type) {
                (cotangent.element_sum(), -cotangent)
            }

            #[inline(always)]
            fn sub_jvp(self, rhs: $type, tangent: $scalar, rhs_tangent: $type) -> ($type, $type) {
                (self - rhs, tangent - rhs_tangent)
            }
        }
    )*};
}

glam_operators! {
    Vec2, f32;
    Vec3, f32;
    Vec4, f32;
    DVec2, f64;
    DVec3, f64;
    DVec4, f64;
}
