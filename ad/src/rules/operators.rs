//! Pullbacks of the arithmetic operators.

use core::ops::{Add, Div, Mul, Neg, Rem, Sub};

use glam::{DMat2, DMat3, DMat4, DQuat, DVec2, DVec3, DVec4};
use glam::{Mat2, Mat3, Mat4, Quat, Vec2, Vec3, Vec4};

use super::{scale, scale_elements, scale_vector};
use crate::tape::Var;
use crate::vector::{Vector, Xyz};
use crate::{Differentiable, Dual, Mask, Real, Tangent};

/// The pullback of unary minus.
#[diagnostic::on_unimplemented(
    message = "no derivative rule for unary minus on `{Self}`",
    note = "rules exist for f32, f64 and glam's float vectors, by value: dereference a reference with `*`"
)]
pub trait NegPullback: Differentiable + Neg<Output: Differentiable> + Sized {
    /// The cotangent of the operand.
    fn neg_pullback(cotangent: Tangent<<Self as Neg>::Output>) -> Tangent<Self>;

    /// The negative and its tangent.
    fn neg_jvp(
        self,
        tangent: Tangent<Self>,
    ) -> (<Self as Neg>::Output, Tangent<<Self as Neg>::Output>);
}

/// The pullbacks of operators whose partial derivatives are constants: they need no operand, so
/// nothing is saved for them.
macro_rules! linear_operator {
    ($name:ident, $method:ident, $jvp:ident, $operator:ident, $symbol:literal) => {
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

            /// The result and its tangent, from the operands and theirs.
            #[allow(clippy::type_complexity)]
            fn $jvp(
                self,
                rhs: Rhs,
                tangent: Tangent<Self>,
                rhs_tangent: Tangent<Rhs>,
            ) -> (<Self as $operator<Rhs>>::Output, Tangent<<Self as $operator<Rhs>>::Output>);
        }
    };
}

/// The pullbacks of operators whose partial derivatives are the operands.
macro_rules! bilinear_operator {
    ($name:ident, $method:ident, $jvp:ident, $operator:ident, $symbol:literal $(, $more:item)?) => {
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

            /// The result and its tangent, from the operands and theirs.
            #[allow(clippy::type_complexity)]
            fn $jvp(
                self,
                rhs: Rhs,
                tangent: Tangent<Self>,
                rhs_tangent: Tangent<Rhs>,
            ) -> (<Self as $operator<Rhs>>::Output, Tangent<<Self as $operator<Rhs>>::Output>);

            $($more)?
        }
    };
}

linear_operator!(AddPullback, add_pullback, add_jvp, Add, "+");
linear_operator!(SubPullback, sub_pullback, sub_jvp, Sub, "-");
bilinear_operator!(
    MulPullback,
    mul_pullback,
    mul_jvp,
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
bilinear_operator!(DivPullback, div_pullback, div_jvp, Div, "/");
bilinear_operator!(RemPullback, rem_pullback, rem_jvp, Rem, "%");

/// Sums of two values of the same kind, and negation.
macro_rules! linear_operators {
    ($([$($generics:tt)*] $type:ty),* $(,)?) => {$(
        impl<$($generics)*> NegPullback for $type {
            #[inline(always)]
            fn neg_pullback(cotangent: Self) -> Self {
                -cotangent
            }

            #[inline(always)]
            fn neg_jvp(self, tangent: Self) -> (Self, Self) {
                (-self, -tangent)
            }
        }

        impl<$($generics)*> AddPullback for $type {
            #[inline(always)]
            fn add_pullback(cotangent: Self) -> (Self, Self) {
                (cotangent, cotangent)
            }

            #[inline(always)]
            fn add_jvp(self, rhs: Self, tangent: Self, rhs_tangent: Self) -> (Self, Self) {
                (self + rhs, tangent + rhs_tangent)
            }
        }

        impl<$($generics)*> SubPullback for $type {
            #[inline(always)]
            fn sub_pullback(cotangent: Self) -> (Self, Self) {
                (cotangent, -cotangent)
            }

            #[inline(always)]
            fn sub_jvp(self, rhs: Self, tangent: Self, rhs_tangent: Self) -> (Self, Self) {
                (self - rhs, tangent - rhs_tangent)
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
    [] Mat2,
    [] Mat3,
    [] Mat4,
    [] DMat2,
    [] DMat3,
    [] DMat4,
    [] Quat,
    [] DQuat,
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

/// The tangent of `a * b`.
///
/// Where a tangent of zero meets a factor that is infinite or NaN the plain formula gives NaN, so a
/// look at its result spares the comparisons of both tangents with zero.
#[inline(always)]
fn product_tangent<S: Real>(a: S, b: S, a_tangent: S, b_tangent: S) -> S {
    let tangent = a_tangent * b + b_tangent * a;
    match tangent.is_finite().all() {
        true => tangent,
        false => rare_product_tangent(a, b, a_tangent, b_tangent),
    }
}

/// The same, with the comparisons.
#[cold]
#[inline(never)]
fn rare_product_tangent<S: Real>(a: S, b: S, a_tangent: S, b_tangent: S) -> S {
    scale(a_tangent, b) + scale(b_tangent, a)
}

/// The tangent of `quotient = numerator / denominator`, with the same look at the result.
#[inline(always)]
fn quotient_tangent<S: Real>(quotient: S, denominator: S, tangent: S, denominator_tangent: S) -> S {
    let slope = (tangent - quotient * denominator_tangent) / denominator;
    match slope.is_finite().all() {
        true => slope,
        false => rare_quotient_tangent(quotient, denominator, tangent, denominator_tangent),
    }
}

/// The same, with every case told apart.
#[cold]
#[inline(never)]
fn rare_quotient_tangent<S: Real>(
    quotient: S,
    denominator: S,
    tangent: S,
    denominator_tangent: S,
) -> S {
    let by_denominator =
        S::select(quotient.vanishes(), S::zero(), scale(denominator_tangent, quotient));
    let numerator = tangent - by_denominator;
    let singular = denominator.cmpeq(S::ZERO) | numerator.vanishes();
    S::select(singular, S::zero(), numerator / denominator)
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

            #[inline(always)]
            fn mul_jvp(self, rhs: Self, tangent: Self, rhs_tangent: Self) -> (Self, Self) {
                (self * rhs, product_tangent(self, rhs, tangent, rhs_tangent))
            }
        }

        impl<$($generics)*> DivPullback for $type {
            #[inline(always)]
            fn div_pullback(self, rhs: Self, cotangent: Self) -> (Self, Self) {
                quotient_pullback(self, rhs, cotangent)
            }

            #[inline(always)]
            fn div_jvp(self, rhs: Self, tangent: Self, rhs_tangent: Self) -> (Self, Self) {
                let quotient = self / rhs;
                (quotient, quotient_tangent(quotient, rhs, tangent, rhs_tangent))
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

            #[inline(always)]
            fn rem_jvp(self, rhs: Self, tangent: Self, rhs_tangent: Self) -> (Self, Self) {
                (self % rhs, tangent - scale(rhs_tangent, (self / rhs).trunc()))
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

            #[inline(always)]
            fn mul_jvp(self, rhs: Self, tangent: Self, rhs_tangent: Self) -> (Self, Self) {
                (self * rhs, scale_elements(tangent, rhs) + scale_elements(rhs_tangent, self))
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
                let along_vector = tangent.map_elements(|tangent| scale(tangent, rhs));
                (self * rhs, along_vector + scale_vector(rhs_tangent, self))
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
            #[inline(always)]
            fn add_pullback(cotangent: $type) -> ($type, $scalar) {
                (cotangent, cotangent.element_sum())
            }

            #[inline(always)]
            fn add_jvp(self, rhs: $scalar, tangent: $type, rhs_tangent: $scalar) -> ($type, $type) {
                (self + rhs, tangent + rhs_tangent)
            }
        }

        impl SubPullback<$scalar> for $type {
            #[inline(always)]
            fn sub_pullback(cotangent: $type) -> ($type, $scalar) {
                (cotangent, -cotangent.element_sum())
            }

            #[inline(always)]
            fn sub_jvp(self, rhs: $scalar, tangent: $type, rhs_tangent: $scalar) -> ($type, $type) {
                (self - rhs, tangent - rhs_tangent)
            }
        }

        impl AddPullback<$type> for $scalar {
            #[inline(always)]
            fn add_pullback(cotangent: $type) -> ($scalar, $type) {
                (cotangent.element_sum(), cotangent)
            }

            #[inline(always)]
            fn add_jvp(self, rhs: $type, tangent: $scalar, rhs_tangent: $type) -> ($type, $type) {
                (self + rhs, tangent + rhs_tangent)
            }
        }

        impl SubPullback<$type> for $scalar {
            #[inline(always)]
            fn sub_pullback(cotangent: $type) -> ($scalar, $type) {
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

/// Integers compute without a derivative, in differentiable functions too.
macro_rules! integer_operators {
    ($($type:ty),* $(,)?) => {$(
        integer_operators!(@linear $type: AddPullback add_pullback add_jvp +, SubPullback sub_pullback sub_jvp -);
        integer_operators!(@binary $type:
            MulPullback mul_pullback mul_jvp *, DivPullback div_pullback div_jvp /,
            RemPullback rem_pullback rem_jvp %);
    )*};
    (@linear $type:ty: $($name:ident $method:ident $jvp:ident $operator:tt),*) => {$(
        impl $name for $type {
            #[inline(always)]
            fn $method((): ()) -> ((), ()) {
                ((), ())
            }

            #[inline(always)]
            fn $jvp(self, rhs: Self, (): (), (): ()) -> (Self, ()) {
                (self $operator rhs, ())
            }
        }
    )*};
    (@binary $type:ty: $($name:ident $method:ident $jvp:ident $operator:tt),*) => {$(
        impl $name for $type {
            #[inline(always)]
            fn $method(self, _: Self, (): ()) -> ((), ()) {
                ((), ())
            }

            #[inline(always)]
            fn $jvp(self, rhs: Self, (): (), (): ()) -> (Self, ()) {
                (self $operator rhs, ())
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

            #[inline(always)]
            fn neg_jvp(self, (): ()) -> (Self, ()) {
                (-self, ())
            }
        }
    )*};
}

signed_integers!(i8, i16, i32, i64, i128, isize);
