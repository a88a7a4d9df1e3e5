//! The operators that work element by element, between vectors and between vectors and numbers, and the sums
//! of everything else.
//!
//! A number beside a vector is the vector with that number in each element. So a row names both operands, the
//! vector that the operator makes, and the linear map that makes it of each operand.

use super::numbers::{denominator_cotangent, quotient_pullback};
use super::{AddPullback, Arithmetic, DivPullback, MulPullback, NegPullback, Nothing, SubPullback};
use crate::dual::Along;
use crate::rules::linear::{Linear, Same, Splat};
use crate::rules::scale_vector::scale_elements;
use crate::rules::{chain, is_infinite};
use crate::tape::Var;
use crate::vector::{Vector, Xyz};
use crate::{Dual, Real};

macro_rules! operators {
    (@each ($($symbol:tt)*) $row:tt) => { $(operators!(@$symbol $row);)* };
    (@+ ([$($generics:tt)*] $left:ty, $right:ty, $made:ty, $of_left:expr, $of_right:expr)) => {
        impl<$($generics)*> AddPullback<$right> for $left {
            type Kept = Nothing;

            #[inline(always)]
            fn add_pullback(_: &Nothing, cotangent: $made) -> ($left, $right) {
                ($of_left.pull(cotangent), $of_right.pull(cotangent))
            }

            #[inline(always)]
            fn add_jvp(self, rhs: $right, tangent: $left, rhs_tangent: $right) -> ($made, $made) {
                (self + rhs, tangent + rhs_tangent)
            }
        }
    };
    (@- ([$($generics:tt)*] $left:ty, $right:ty, $made:ty, $of_left:expr, $of_right:expr)) => {
        impl<$($generics)*> SubPullback<$right> for $left {
            type Kept = Nothing;

            #[inline(always)]
            fn sub_pullback(_: &Nothing, cotangent: $made) -> ($left, $right) {
                ($of_left.pull(cotangent), $of_right.pull(-cotangent))
            }

            #[inline(always)]
            fn sub_jvp(self, rhs: $right, tangent: $left, rhs_tangent: $right) -> ($made, $made) {
                (self - rhs, tangent - rhs_tangent)
            }
        }
    };
    (@* ([$($generics:tt)*] $left:ty, $right:ty, $made:ty, $of_left:expr, $of_right:expr)) => {
        impl<$($generics)*> MulPullback<$right> for $left {
            #[inline(always)]
            fn mul_pullback(self, rhs: $right, cotangent: $made) -> ($left, $right) {
                let (a, b): ($made, $made) = ($of_left.push(self), $of_right.push(rhs));
                let to_right = scale_elements(cotangent, a);
                ($of_left.pull(scale_elements(cotangent, b)), $of_right.pull(to_right))
            }

            #[inline(always)]
            fn mul_pullback_of_finite(self, rhs: $right, cotangent: $made) -> ($left, $right) {
                let (a, b): ($made, $made) = ($of_left.push(self), $of_right.push(rhs));
                ($of_left.pull(cotangent * b), $of_right.pull(cotangent * a))
            }

            #[inline(always)]
            fn mul_jvp(self, rhs: $right, tangent: $left, rhs_tangent: $right) -> ($made, $made) {
                let (a, b): ($made, $made) = ($of_left.push(self), $of_right.push(rhs));
                let (a_dot, b_dot): ($made, $made) = ($of_left.push(tangent), $of_right.push(rhs_tangent));
                (self * rhs, a_dot.zip_elements(b, chain) + b_dot.zip_elements(a, chain))
            }
        }
    };
    (@/ ([$($generics:tt)*] $left:ty, $right:ty, $made:ty, $of_left:expr, $of_right:expr)) => {
        impl<$($generics)*> DivPullback<$right> for $left {
            #[inline(always)]
            fn div_pullback(self, rhs: $right, cotangent: $made) -> ($left, $right) {
                let b: $made = $of_right.push(rhs);
                let to_left = cotangent.zip_elements(b, |g, b| quotient_pullback(g, b, g).0);
                let to_right = to_left.zip_elements(self / rhs, denominator_cotangent);
                ($of_left.pull(to_left), $of_right.pull(to_right))
            }

            #[inline(always)]
            fn div_jvp(self, rhs: $right, tangent: $left, rhs_tangent: $right) -> ($made, $made) {
                let (quotient, b): (_, $made) = (self / rhs, $of_right.push(rhs));
                let (a_dot, b_dot): ($made, $made) = ($of_left.push(tangent), $of_right.push(rhs_tangent));
                let along = a_dot - b_dot.zip_elements(quotient, chain);
                (quotient, along.zip_elements(b, divided))
            }
        }
    };
    (@% ([$($generics:tt)*] $left:ty, $right:ty, $made:ty, $of_left:expr, $of_right:expr)) => {
        impl<$($generics)*> RemPullback<$right> for $left {
            #[inline(always)]
            fn rem_pullback(self, rhs: $right, cotangent: $made) -> ($left, $right) {
                let (a, b): ($made, $made) = ($of_left.push(self), $of_right.push(rhs));
                let multiples = (a - self % rhs).zip_elements(b, |taken, b| multiples(taken, 0.0, b));
                let to_right = -scale_elements(cotangent, multiples);
                ($of_left.pull(cotangent), $of_right.pull(to_right))
            }

            #[inline(always)]
            fn rem_jvp(self, rhs: $right, tangent: $left, rhs_tangent: $right) -> ($made, $made) {
                let rest = self % rhs;
                let (a, b): ($made, $made) = ($of_left.push(self), $of_right.push(rhs));
                let multiples = (a - rest).zip_elements(b, |taken, b| multiples(taken, 0.0, b));
                let (a_dot, b_dot): ($made, $made) = ($of_left.push(tangent), $of_right.push(rhs_tangent));
                (rest, a_dot - b_dot.zip_elements(multiples, chain))
            }
        }
    };
    ($symbols:tt $($generics:tt $left:ty, $right:ty => $made:ty: $of_left:expr, $of_right:expr;)*) => {
        $(operators!(@each $symbols ($generics $left, $right, $made, $of_left, $of_right));)*
    };
}

/// A tangent divided by a number; 0 where the tangent is 0 or the number 0 or infinite.
#[inline(always)]
pub fn divided<S: Real>(tangent: S, by: S) -> S {
    let singular = by.cmpeq(S::ZERO) | is_infinite(by) | tangent.vanishes();
    S::select(singular, S::zero(), tangent / by)
}

operators! {
    (+ - *)
    [S: Real] Xyz<S>, Xyz<S> => Xyz<S>: Same(), Same();
}

operators! {
    (* /)
    [S: Real] Xyz<S>, S => Xyz<S>: Same(), Splat();
}

/// Negation.
macro_rules! negatives {
    ($([$($generics:tt)*] $type:ty),* $(,)?) => {$(
        impl<$($generics)*> Arithmetic for $type {}

        impl<$($generics)*> NegPullback for $type {
            type Kept = Nothing;

            #[inline(always)]
            fn neg_pullback(_: &Nothing, cotangent: Self) -> Self {
                -cotangent
            }

            #[inline(always)]
            fn neg_jvp(self, tangent: Self) -> (Self, Self) {
                (-self, -tangent)
            }
        }
    )*};
}

/// Sums of two values of the same kind, and negation.
macro_rules! sums {
    ($([$($generics:tt)*] $type:ty),* $(,)?) => {
        negatives!($([$($generics)*] $type),*);
        operators!((+ -) $([$($generics)*] $type, $type => $type: Same(), Same();)*);
    };
}

#[cfg(feature = "glam")]
pub(crate) use {negatives, operators, sums};

negatives!([S: Real] Xyz<S>);
sums!([] f32, [] f64, [S: Real, D: Along<S>] Dual<S, D>, [] Var);

#[cfg(feature = "lanes")]
sums!([] wide::f32x8, [] wide::f32x16, [] wide::f64x8);
