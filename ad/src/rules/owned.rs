//! Derivatives of what makes a value of one's own of a slice or of what is behind a reference.

use core::array::TryFromSliceError;

use super::Elements;
use crate::{Differentiable, Tangent};

/// The `_vjp` and `_jvp` siblings of `to_owned`; a tangent is passed as an `L`.
pub trait OwnedRules<L>: Differentiable {
    /// What is made of a reference.
    type Owned: Differentiable;

    /// The cotangent of the copy.
    fn to_owned_vjp(
        &self,
    ) -> (Self::Owned, impl FnOnce(Tangent<Self::Owned>) -> Self::Tangent + use<Self, L>);

    /// A copy of the tangent.
    fn to_owned_jvp(&self, tangent: L) -> (Self::Owned, Tangent<Self::Owned>);
}

impl<T: Clone + Differentiable> OwnedRules<Tangent<T>> for T {
    type Owned = T;

    #[inline(always)]
    fn to_owned_vjp(&self) -> (T, impl FnOnce(Tangent<T>) -> Tangent<T> + use<T>) {
        (self.clone(), |cotangent| cotangent)
    }

    #[inline(always)]
    fn to_owned_jvp(&self, tangent: Tangent<T>) -> (T, Tangent<T>) {
        (self.clone(), tangent)
    }
}

impl<'a, T: Clone + Differentiable> OwnedRules<&'a [Tangent<T>]> for [T] {
    type Owned = Vec<T>;

    #[inline]
    fn to_owned_vjp(
        &self,
    ) -> (Vec<T>, impl FnOnce(Vec<Tangent<T>>) -> Vec<Tangent<T>> + use<'a, T>) {
        (self.to_vec(), |cotangent| cotangent)
    }

    #[inline]
    fn to_owned_jvp(&self, tangent: &'a [Tangent<T>]) -> (Vec<T>, Vec<Tangent<T>>) {
        (self.to_vec(), tangent.to_vec())
    }
}

/// The `_vjp` and `_jvp` siblings of `try_into` of slices to arrays.
pub trait TryIntoRules<T: Differentiable + Copy>: Differentiable {
    /// To the elements; nothing where the slice has another length.
    fn try_into_vjp<const N: usize>(
        &self,
    ) -> (
        Result<[T; N], TryFromSliceError>,
        impl FnOnce(([Tangent<T>; N], ())) -> Self::Tangent + use<Self, T, N>,
    );

    /// The tangents as an array.
    fn try_into_jvp<const N: usize>(
        &self,
        tangent: &[Tangent<T>],
    ) -> (Result<[T; N], TryFromSliceError>, ([Tangent<T>; N], ()));
}

impl<T: Differentiable + Copy> TryIntoRules<T> for [T] {
    #[inline]
    fn try_into_vjp<const N: usize>(
        &self,
    ) -> (
        Result<[T; N], TryFromSliceError>,
        impl FnOnce(([Tangent<T>; N], ())) -> Vec<Tangent<T>> + use<T, N>,
    ) {
        let array = <[T; N]>::try_from(self);
        let len = if array.is_ok() { N } else { 0 };
        (array, move |(cotangent, ())| cotangent.into_iter().take(len).collect())
    }

    #[inline]
    fn try_into_jvp<const N: usize>(
        &self,
        tangent: &[Tangent<T>],
    ) -> (Result<[T; N], TryFromSliceError>, ([Tangent<T>; N], ())) {
        (<[T; N]>::try_from(self), (Elements::from_copy(tangent.to_vec()), ()))
    }
}
