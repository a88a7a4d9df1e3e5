//! The products and quotients of numbers.

use super::{DivPullback, MulPullback, RemPullback};
use crate::dual::Along;
use crate::rules::scalar::multiples;
use crate::rules::{chain, is_infinite, scale};
use crate::tape::Var;
use crate::{Dual, Mask, Real};

/// The cotangents of numerator and denominator of `quotient = numerator / denominator`.
#[inline(always)]
pub fn quotient_pullback<S: Real>(numerator: S, denominator: S, cotangent: S) -> (S, S) {
    let singular = denominator.cmpeq(S::ZERO) | cotangent.vanishes();
    let to_numerator = S::select(singular, S::zero(), cotangent / denominator);
    (to_numerator, denominator_cotangent(to_numerator, numerator / denominator))
}

/// The pullback of a quotient that is finite and whose denominator is not zero.
#[inline(always)]
pub fn quotient_pullback_of_finite<S: Real>(numerator: S, denominator: S, cotangent: S) -> (S, S) {
    let quotient = numerator / denominator;
    let to_numerator = cotangent / denominator;
    let to_denominator = S::select(quotient.vanishes(), S::zero(), -(to_numerator * quotient));
    (to_numerator, to_denominator)
}

/// The cotangent of a denominator. That of the numerator overflows where the denominator is tiny:
/// a quotient of zero annihilates it.
#[inline(always)]
pub fn denominator_cotangent<S: Real>(to_numerator: S, quotient: S) -> S {
    S::select(quotient.vanishes(), S::zero(), -scale(to_numerator, quotient))
}

/// The tangent of `a * b`.
///
/// Where zero meets what is infinite or NaN the plain formula gives NaN, so a look at its result spares the
/// comparisons of both tangents with zero.
#[inline(always)]
pub fn product_tangent<S: Real>(a: S, b: S, a_tangent: S, b_tangent: S) -> S {
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
    chain(a_tangent, b) + chain(b_tangent, a)
}

/// The tangent of `quotient = numerator / denominator`, with the same look at the result.
#[inline(always)]
pub(super) fn quotient_tangent<S: Real>(
    quotient: S,
    denominator: S,
    tangent: S,
    denominator_tangent: S,
) -> S {
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
    let numerator = tangent - chain(denominator_tangent, quotient);
    let singular = denominator.cmpeq(S::ZERO) | is_infinite(denominator) | numerator.vanishes();
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

scalar_operators!([] f32, [] f64, [S: Real, D: Along<S>] Dual<S, D>, [] Var);

macro_rules! remainder {
    ($($type:ty),*) => {$(
        impl RemPullback for $type {
            /// `a % b` is `a` less a multiple of `b`; its jumps carry no derivative.
            #[inline(always)]
            fn rem_pullback(self, rhs: Self, cotangent: Self) -> (Self, Self) {
                (cotangent, -scale(cotangent, multiples(self, self % rhs, rhs)))
            }

            #[inline(always)]
            fn rem_jvp(self, rhs: Self, tangent: Self, rhs_tangent: Self) -> (Self, Self) {
                let rest = self % rhs;
                (rest, tangent - chain(rhs_tangent, multiples(self, rest, rhs)))
            }
        }
    )*};
}

remainder!(f32, f64);
