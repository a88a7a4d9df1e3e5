//! Pullbacks of the arithmetic operators.

use core::ops::{Add, Div, Mul, Neg, Rem, Sub};

use glam::{DVec2, DVec3, DVec4, Vec2, Vec3, Vec4};

use super::{scale, scale_elements};
use crate::tape::Var;
use crate::vector::{Vector, Xyz};
use crate::{Differentiable, Dual, Real, Tangent};

/// The pullback of unary minus.
#[diagnostic::on_unimplemented(
    message = "no derivative rule for unary minus on `{Self}`",
    note = "rules exist for f32, f64 and glam's float vectors, by value: dereference a reference with `*`"
)]
pub trait NegPullback: Differentiable + Neg<Output: Differentiable> + Sized {
    /// The cotangent of the operand.
    fn neg_pullback(cotangent: Tangent<<Self as Neg>::Output>) -> Tangent<Self>;
}

/// The pullbacks of operators whose partial derivatives are constants: they need no operand, so
/// nothing is saved for them.
macro_rules! linear_operator {
    ($name:ident, $method:ident, $operator:ident, $symbol:literal) => {
        #[doc = concat!("The pullback of `", $symbol, "`.")]
        #[diagnostic::on_unimplemented(
            message = "no derivative rule for an operator between `{Self}` and `{Rhs}`",
            note = "rules exist for f32, f64 and glam's float vectors, by value: dereference a reference with `*`",
            note = "operators of your own type: put the computation into a method under `#[differentiable]`, and call that"
        )]
        pub trait $name<Rhs: Differentiable = Self>:
            Differentiable + $operator<Rhs, Output: Differentiable> + Sized
        {
            /// The cotangents of the left and the right operand.
            fn $method(
                cotangent: Tangent<<Self as $operator<Rhs>>::Output>,
            ) -> (Tangent<Self>, Tangent<Rhs>);
        }
    };
}

/// The pullbacks of operators whose partial derivatives are the operands.
macro_rules! bilinear_operator {
    ($name:ident, $method:ident, $operator:ident, $symbol:literal $(, $more:item)?) => {
        #[doc = concat!("The pullback of `", $symbol, "`.")]
        #[diagnostic::on_unimplemented(
            message = "no derivative rule for an operator between `{Self}` and `{Rhs}`",
            note = "rules exist for f32, f64 and glam's float vectors, by value: dereference a reference with `*`",
            note = "operators of your own type: put the computation into a method under `#[differentiable]`, and call that"
        )]
        pub trait $name<Rhs: Differentiable = Self>:
            Differentiable + $operator<Rhs, Output: Differentiable> + Sized
        {
            /// The cotangents of the left and the right operand.
            fn $method(
                self,
                rhs: Rhs,
                cotangent: Tangent<<Self as $operator<Rhs>>::Output>,
            ) -> (Tangent<Self>, Tangent<Rhs>);

            $($more)?
        }
    };
}

linear_operator!(AddPullback, add_pullback, Add, "+");
linear_operator!(SubPullback, sub_pullback, Sub, "-");
bilinear_operator!(
    MulPullback,
    mul_pullback,
    Mul,
    "*",
    /// As [`mul_pullback`](Self::mul_pullback), where both operands are finite: then no cotangent
    /// of zero can meet an infinite partial derivative.
    #[inline(always)]
    fn mul_pullback_of_finite(
        self,
        rhs: Rhs,
        cotangent: Tangent<<Self as Mul<Rhs>>::Output>,
    ) -> (Tangent<Self>, Tangent<Rhs>) {
        self.mul_pullback(rhs, cotangent)
    }
);
bilinear_operator!(DivPullback, div_pullback, Div, "/");
bilinear_operator!(RemPullback, rem_pullback, Rem, "%");

/// Sums of two values of the same kind, and negation.
macro_rules! linear_operators {
    ($([$($generics:tt)*] $type:ty),* $(,)?) => {$(
        impl<$($generics)*> NegPullback for $type {
            #[inline(always)]
            fn neg_pullback(cotangent: Self) -> Self {
                -cotangent
            }
        }

        impl<$($generics)*> AddPullback for $type {
            #[inline(always)]
            fn add_pullback(cotangent: Self) -> (Self, Self) {
                (cotangent, cotangent)
            }
        }

        impl<$($generics)*> SubPullback for $type {
            #[inline(always)]
            fn sub_pullback(cotangent: Self) -> (Self, Self) {
                (cotangent, -cotangent)
            }
        }
    )*};
}

#[cfg(feature = "lanes")]
linear_operators!([] wide::f32x8, [] wide::f32x16, [] wide::f64x8);

linear_operators!(
    [] f32,
    [] f64,
    [S: Real] Dual<S>,
    [] Var,
    [] Vec2,
    [] Vec3,
    [] Vec4,
    [] DVec2,
    [] DVec3,
    [] DVec4,
    [S: Real] Xyz<S>,
);

/// The cotangents of numerator and denominator of `quotient = numerator / denominator`.
#[inline(always)]
fn quotient_pullback<S: Real>(numerator: S, denominator: S, cotangent: S) -> (S, S) {
    let singular = denominator.cmpeq(S::ZERO) | cotangent.vanishes();
    let to_numerator = S::select(singular, S::zero(), cotangent / denominator);
    (to_numerator, denominator_cotangent(to_numerator, numerator / denominator))
}

/// The cotangent of a denominator. That of the numerator overflows where the denominator is tiny:
/// a quotient of zero annihilates it.
#[inline(always)]
fn denominator_cotangent<S: Real>(to_numerator: S, quotient: S) -> S {
    S::select(quotient.vanishes(), S::zero(), -scale(to_numerator, quotient))
}

macro_rules! scalar_operators {
    ($([$($generics:tt)*] $type:ty),* $(,)?) => {$(
        impl<$($generics)*> MulPullback for $type {
            #[inline(always)]
            fn mul_pullback(self, rhs: Self, cotangent: Self) -> (Self, Self) {
                (scale(cotangent, rhs), scale(cotangent, self))
            }

            #[inline(always)]
            fn mul_pullback_of_finite(self, rhs: Self, cotangent: Self) -> (Self, Self) {
                (cotangent * rhs, cotangent * self)
            }
        }

        impl<$($generics)*> DivPullback for $type {
            #[inline(always)]
            fn div_pullback(self, rhs: Self, cotangent: Self) -> (Self, Self) {
                quotient_pullback(self, rhs, cotangent)
            }
        }
    )*};
}

#[cfg(feature = "lanes")]
scalar_operators!([] wide::f32x8, [] wide::f32x16, [] wide::f64x8);

scalar_operators!([] f32, [] f64, [S: Real] Dual<S>, [] Var);

macro_rules! remainder {
    ($($type:ty),*) => {$(
        impl RemPullback for $type {
            /// `a % b` is `a - b * trunc(a / b)`; its jumps carry no derivative.
            #[inline(always)]
            fn rem_pullback(self, rhs: Self, cotangent: Self) -> (Self, Self) {
                (cotangent, -scale(cotangent, (self / rhs).trunc()))
            }
        }
    )*};
}

remainder!(f32, f64);

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
        }

        impl<$($generics)*> DivPullback<$scalar> for $type {
            #[inline(always)]
            fn div_pullback(self, rhs: $scalar, cotangent: Self) -> (Self, $scalar) {
                let to_vector = cotangent.map_elements(|g| quotient_pullback(g, rhs, g).0);
                let quotient = self.map_elements(|numerator| numerator / rhs);
                (to_vector, to_vector.zip_elements(quotient, denominator_cotangent).element_sum())
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
        }

        impl DivPullback for $type {
            #[inline(always)]
            fn div_pullback(self, rhs: Self, cotangent: Self) -> (Self, Self) {
                let to_numerator = cotangent.zip_elements(rhs, |g, b| quotient_pullback(g, b, g).0);
                (to_numerator, to_numerator.zip_elements(self / rhs, denominator_cotangent))
            }
        }

        impl DivPullback<$type> for $scalar {
            #[inline(always)]
            fn div_pullback(self, rhs: $type, cotangent: $type) -> ($scalar, $type) {
                let (to_numerator, to_denominator) =
                    <$type>::splat(self).div_pullback(rhs, cotangent);
                (to_numerator.element_sum(), to_denominator)
            }
        }

        impl AddPullback<$scalar> for $type {
            #[inline(always)]
            fn add_pullback(cotangent: $type) -> ($type, $scalar) {
                (cotangent, cotangent.element_sum())
            }
        }

        impl SubPullback<$scalar> for $type {
            #[inline(always)]
            fn sub_pullback(cotangent: $type) -> ($type, $scalar) {
                (cotangent, -cotangent.element_sum())
            }
        }

        impl AddPullback<$type> for $scalar {
            #[inline(always)]
            fn add_pullback(cotangent: $type) -> ($scalar, $type) {
                (cotangent.element_sum(), cotangent)
            }
        }

        impl SubPullback<$type> for $scalar {
            #[inline(always)]
            fn sub_pullback(cotangent: $type) -> ($scalar, $type) {
                (cotangent.element_sum(), -cotangent)
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

/// Integers compute without a derivative, in differentiable functions too.
macro_rules! integer_operators {
    ($($type:ty),* $(,)?) => {$(
        integer_operators!(@linear $type: AddPullback add_pullback, SubPullback sub_pullback);
        integer_operators!(@binary $type:
            MulPullback mul_pullback, DivPullback div_pullback, RemPullback rem_pullback);
    )*};
    (@linear $type:ty: $($name:ident $method:ident),*) => {$(
        impl $name for $type {
            #[inline(always)]
            fn $method((): ()) -> ((), ()) {
                ((), ())
            }
        }
    )*};
    (@binary $type:ty: $($name:ident $method:ident),*) => {$(
        impl $name for $type {
            #[inline(always)]
            fn $method(self, _: Self, (): ()) -> ((), ()) {
                ((), ())
            }
        }
    )*};
}

integer_operators!(i8, i16, i32, i64, i128, isize, u8, u16, u32, u64, u128, usize);

macro_rules! signed_integers {
    ($($type:ty),*) => {$(
        impl NegPullback for $type {
            #[inline(always)]
            fn neg_pullback((): ()) {}
        }
    )*};
}

signed_integers!(i8, i16, i32, i64, i128, isize);
