//! The kinds of rules of products: a pullback chooses between two of them, that of a very large
//! function calls the third.
//!
//! `scale` is half of a rule, for numbers: a cotangent times one factor.

use crate::rules::MulPullback;
use crate::{Differentiable, Real, Tangent};

pub use crate::rules::scale;

/// The rules of products of which some factor may be infinite or NaN.
#[derive(Clone, Copy)]
pub struct Products;

impl Products {
    /// `cotangent * factor`, and 0 where the cotangent is 0.
    #[inline(always)]
    pub fn scale<S: Real>(self, cotangent: S, factor: S) -> S {
        scale(cotangent, factor)
    }

    /// The pullback of `a * b`.
    #[inline(always)]
    pub fn mul_pullback<A: MulPullback<B>, B: Differentiable>(
        self,
        a: A,
        b: B,
        cotangent: Tangent<A::Output>,
    ) -> (Tangent<A>, Tangent<B>) {
        a.mul_pullback(b, cotangent)
    }
}

/// The rules of products whose factors are finite.
#[derive(Clone, Copy)]
pub struct ProductsOfFinite;

impl ProductsOfFinite {
    /// `cotangent * factor`
    #[inline(always)]
    pub fn scale<S: Real>(self, cotangent: S, factor: S) -> S {
        cotangent * factor
    }

    /// The pullback of `a * b`.
    #[inline(always)]
    pub fn mul_pullback<A: MulPullback<B>, B: Differentiable>(
        self,
        a: A,
        b: B,
        cotangent: Tangent<A::Output>,
    ) -> (Tangent<A>, Tangent<B>) {
        a.mul_pullback_of_finite(b, cotangent)
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

/// Runs `reverse` out of line.
#[cold]
#[inline(never)]
pub fn rarely<R>(reverse: impl FnOnce() -> R) -> R {
    reverse()
}
