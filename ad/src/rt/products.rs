//! The two kinds of rules of products, between which a pullback chooses.

use crate::rules::MulPullback;
use crate::{Differentiable, Tangent};

/// The rules of products of which some factor may be infinite or NaN.
#[derive(Clone, Copy)]
pub struct Products;

impl Products {
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

/// Runs `reverse` out of line.
#[cold]
#[inline(never)]
pub fn rarely<R>(reverse: impl FnOnce() -> R) -> R {
    reverse()
}
