//! The rules of products and quotients: with the comparison of cotangents with zero, or without it,
//! as a pullback chooses; a very large function calls them.
//!
//! `scale` is half of a rule, for numbers: a cotangent times one factor.

use crate::rules::{MulPullback, quotient_pullback_of_finite};
use crate::{Differentiable, Mask, Real, Tangent};

pub use crate::rules::scale;

/// The rules of products within one reverse sweep.
#[derive(Clone, Copy)]
pub struct Products {
    are_finite: bool,
}

impl Products {
    /// The rules where factors and quotients are finite.
    pub const OF_FINITE: Self = Self { are_finite: true };
    /// The rules where one may not be.
    pub const OF_ANY: Self = Self { are_finite: false };

    /// `cotangent * factor`, and 0 where the cotangent is 0.
    #[inline(always)]
    pub fn scale<S: Real>(self, cotangent: S, factor: S) -> S {
        match self.are_finite {
            true => cotangent * factor,
            false => scale(cotangent, factor),
        }
    }

    /// The pullback of `a / b`, which is finite where factors are: then `b` is not 0.
    #[inline(always)]
    pub fn div_pullback<S: Real>(self, a: S, b: S, cotangent: S) -> (S, S) {
        match self.are_finite {
            true => quotient_pullback_of_finite(a, b, cotangent),
            false => a.div_pullback(b, cotangent),
        }
    }

    /// The pullback of `a * b`.
    #[inline(always)]
    pub fn mul_pullback<A: MulPullback<B>, B: Differentiable>(
        self,
        a: A,
        b: B,
        cotangent: Tangent<A::Output>,
    ) -> (Tangent<A>, Tangent<B>) {
        match self.are_finite {
            true => a.mul_pullback_of_finite(b, cotangent),
            false => a.mul_pullback(b, cotangent),
        }
    }
}

/// Runs a reverse sweep: with plain products if `irregular`, a sum over factors and quotients, is 0,
/// which tells that they are finite, else, out of line, with the comparison.
///
/// A closure that is always inlined is written, and checked by the compiler, once, and compiled
/// twice.
#[inline(always)]
pub fn with_products<R>(irregular: f64, reverse: impl FnOnce(Products) -> R) -> R {
    match irregular == 0.0 {
        true => reverse(Products::OF_FINITE),
        false => rarely(move || reverse(Products::OF_ANY)),
    }
}

/// 0 unless the cotangent of a value is zero.
#[inline(always)]
pub fn vanishing<S: Real>(cotangent: S) -> f64 {
    match cotangent.vanishes().any() {
        true => f64::NAN,
        false => 0.0,
    }
}

/// The rules of products of a function with so many that their code has to be shared.
#[derive(Clone, Copy)]
pub struct ProductsOutOfLine;

impl ProductsOutOfLine {
    /// `cotangent * factor`, and 0 where the cotangent is 0.
    #[inline(never)]
    pub fn scale<S: Real>(self, cotangent: S, factor: S) -> S {
        scale(cotangent, factor)
    }

    /// The pullback of `a / b`.
    #[inline(never)]
    pub fn div_pullback<S: Real>(self, a: S, b: S, cotangent: S) -> (S, S) {
        a.div_pullback(b, cotangent)
    }

    /// The pullback of `a * b`.
    #[inline(never)]
    pub fn mul_pullback<A: MulPullback<B>, B: Differentiable>(
        self,
        a: A,
        b: B,
        cotangent: Tangent<A::Output>,
    ) -> (Tangent<A>, Tangent<B>) {
        a.mul_pullback(b, cotangent)
    }
}

/// Runs a reverse sweep out of line.
#[cold]
#[inline(never)]
pub fn rarely<R>(reverse: impl FnOnce() -> R) -> R {
    reverse()
}
