//! Derivatives of the methods of slices, arrays and vectors.

use crate::{Additive, Differentiable, Tangent};

/// The `_vjp` siblings of the methods of a sequence.
pub trait SequenceRules: Differentiable {
    /// An element.
    type Element: Differentiable;

    /// The cotangents of the copies.
    fn to_vec_vjp(
        &self,
    ) -> (Vec<Self::Element>, impl FnOnce(Vec<Tangent<Self::Element>>) -> Self::Tangent + use<Self>)
    where
        Self::Element: Clone;
}

/// The `_vjp` sibling of `clone`.
pub trait CloneRules: Clone + Differentiable {
    /// The cotangent of the copy.
    #[inline(always)]
    fn clone_vjp(&self) -> (Self, impl FnOnce(Tangent<Self>) -> Tangent<Self> + use<Self>) {
        (self.clone(), |cotangent| cotangent)
    }
}

impl<T: Clone + Differentiable> CloneRules for T {}

impl<T: Differentiable> SequenceRules for [T] {
    type Element = T;

    #[inline]
    fn to_vec_vjp(&self) -> (Vec<T>, impl FnOnce(Vec<Tangent<T>>) -> Vec<Tangent<T>> + use<T>)
    where
        T: Clone,
    {
        (self.to_vec(), |cotangent| cotangent)
    }
}

impl<T: Differentiable, const N: usize> SequenceRules for [T; N] {
    type Element = T;

    #[inline]
    fn to_vec_vjp(&self) -> (Vec<T>, impl FnOnce(Vec<Tangent<T>>) -> [Tangent<T>; N] + use<T, N>)
    where
        T: Clone,
    {
        (self.to_vec(), |cotangent: Vec<Tangent<T>>| {
            let mut elements = cotangent.into_iter();
            core::array::from_fn(|_| elements.next().unwrap_or_else(Additive::zero))
        })
    }
}
