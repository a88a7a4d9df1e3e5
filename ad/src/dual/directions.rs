//! What a dual number carries beside its value.

use core::array;
use core::fmt::Debug;

use crate::Real;

/// The derivative of a number along one direction, or along several.
pub trait Along<S: Real>: Copy + Debug + Default + PartialEq + Send + Sync + 'static {
    /// The derivatives of a constant.
    const ZERO: Self;

    /// What `f` makes of the derivative along each direction.
    fn map(self, f: impl Fn(S) -> S) -> Self;

    /// What `f` makes of the derivatives of two numbers along each direction.
    fn zip(self, other: Self, f: impl Fn(S, S) -> S) -> Self;

    /// What `f` makes of `start` and the derivatives, one direction after the other.
    fn fold<T>(self, start: T, f: impl Fn(T, S) -> T) -> T;

    /// The neutral element of addition.
    #[inline(always)]
    fn neutral() -> Self {
        Self::ZERO.map(|_| S::zero())
    }

    /// The derivatives of a sum.
    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }

    /// The derivatives times `slope`; 0 where one of the two is 0, whatever the other is.
    #[inline(always)]
    fn times(self, slope: S) -> Self {
        let flat = slope.vanishes();
        self.map(|along| S::select(flat | along.vanishes(), S::ZERO, along * slope))
    }

    /// `if_true` where the mask holds, else `if_false`.
    #[inline(always)]
    fn choose(mask: S::Mask, if_true: Self, if_false: Self) -> Self {
        if_true.zip(if_false, |if_true, if_false| S::select(mask, if_true, if_false))
    }
}

impl<S: Real> Along<S> for S {
    const ZERO: Self = <S as Real>::ZERO;

    #[inline(always)]
    fn map(self, f: impl Fn(S) -> S) -> Self {
        f(self)
    }

    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(S, S) -> S) -> Self {
        f(self, other)
    }

    #[inline(always)]
    fn fold<T>(self, start: T, f: impl Fn(T, S) -> T) -> T {
        f(start, self)
    }
}

/// Derivatives along `K` directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Directions<S, const K: usize>(pub [S; K]);

impl<S: Real, const K: usize> Default for Directions<S, K> {
    fn default() -> Self {
        Self([S::default(); K])
    }
}

impl<S: Real, const K: usize> Along<S> for Directions<S, K> {
    const ZERO: Self = Self([S::ZERO; K]);

    #[inline(always)]
    fn map(self, f: impl Fn(S) -> S) -> Self {
        Self(self.0.map(f))
    }

    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(S, S) -> S) -> Self {
        Self(array::from_fn(|k| f(self.0[k], other.0[k])))
    }

    #[inline(always)]
    fn fold<T>(self, start: T, f: impl Fn(T, S) -> T) -> T {
        self.0.into_iter().fold(start, f)
    }
}
