//! Arrays, where only the type tells that [`map`](super::attempt) is theirs.

use super::attempt::{Failure, Holds, Mapped, Takes};
use crate::{Additive, Differentiable, Tangent};

/// What an array of so many elements holds in their place: there is no such value.
pub enum Arranged<const N: usize> {}

impl<const N: usize> Differentiable for Arranged<N> {
    type Tangent = ();
    type Shape = ();

    #[inline(always)]
    fn shape(&self) {}
}

impl<const N: usize> Failure for Arranged<N> {}

impl<T: Differentiable, const N: usize> Holds<T> for Arranged<N> {
    type Whole = [T; N];

    #[inline(always)]
    fn full(_: T) -> [T; N] {
        unreachable!("an array has elements")
    }

    #[inline(always)]
    fn again(self) -> [T; N] {
        match self {}
    }
}

impl<T: Differentiable + Clone, const N: usize> Takes<T> for Arranged<N> {
    #[inline(always)]
    fn taken(element: &T) -> T {
        element.clone()
    }
}

impl<T: Differentiable, const N: usize> Mapped for [T; N] {
    type Content = T;
    type Failure = Arranged<N>;
    type Elements = Self;

    #[inline(always)]
    fn spread(self) -> Result<Result<T, Arranged<N>>, Self> {
        Err(self)
    }

    #[inline(always)]
    fn whole(elements: Self) -> Self {
        elements
    }

    #[inline(always)]
    fn joined(_: Tangent<T>, (): (), elements: [Tangent<T>; N]) -> [Tangent<T>; N] {
        elements
    }

    #[inline(always)]
    fn apart(elements: [Tangent<T>; N]) -> (Tangent<T>, (), [Tangent<T>; N]) {
        (Additive::zero(), (), elements)
    }
}
