//! Methods of slices, arrays and vectors. What changes a sequence changes its tangent alike.

use crate::rules::{SequenceRules, VecRules, sequence::sorted_from};
use crate::{Differentiable, Tangent};

/// The `_jvp` siblings of the methods of slices and arrays.
pub trait SequenceForward: SequenceRules {
    /// The copies of the tangents.
    #[inline]
    fn to_vec_jvp(
        &self,
        tangent: &[Tangent<Self::Element>],
    ) -> (Vec<Self::Element>, Vec<Tangent<Self::Element>>)
    where
        Self::Element: Clone,
    {
        (self.view().to_vec(), tangent.to_vec())
    }

    /// The tangents change places, too.
    #[inline]
    fn swap_jvp(
        &mut self,
        i: usize,
        j: usize,
        tangent: &mut [Tangent<Self::Element>],
        (): (),
        (): (),
    ) -> ((), ()) {
        self.sequence().swap(i, j);
        tangent.swap(i, j);
        ((), ())
    }

    /// Turns the order of the tangents, too.
    #[inline]
    fn reverse_jvp(&mut self, tangent: &mut [Tangent<Self::Element>]) -> ((), ()) {
        self.sequence().reverse();
        tangent.reverse();
        ((), ())
    }

    /// Turns the tangents, too.
    #[inline]
    fn rotate_left_jvp(
        &mut self,
        by: usize,
        tangent: &mut [Tangent<Self::Element>],
        (): (),
    ) -> ((), ()) {
        self.sequence().rotate_left(by);
        tangent.rotate_left(by);
        ((), ())
    }

    /// Turns the tangents, too.
    #[inline]
    fn rotate_right_jvp(
        &mut self,
        by: usize,
        tangent: &mut [Tangent<Self::Element>],
        (): (),
    ) -> ((), ()) {
        self.sequence().rotate_right(by);
        tangent.rotate_right(by);
        ((), ())
    }

    /// The tangent of the value, everywhere.
    #[inline]
    fn fill_jvp(
        &mut self,
        value: Self::Element,
        tangent: &mut [Tangent<Self::Element>],
        value_tangent: Tangent<Self::Element>,
    ) -> ((), ())
    where
        Self::Element: Clone,
    {
        self.sequence().fill(value);
        tangent.fill(value_tangent);
        ((), ())
    }

    /// The tangents follow their elements.
    #[inline]
    fn sort_by_jvp<F>(
        &mut self,
        mut compare: F,
        tangent: &mut [Tangent<Self::Element>],
        (): (),
    ) -> ((), ())
    where
        F: FnMut(&Self::Element, &Self::Element) -> core::cmp::Ordering,
    {
        let from = sorted_from(self.sequence(), &mut compare);
        let sorted: Vec<_> = from.into_iter().map(|place| tangent[place].clone()).collect();
        tangent.clone_from_slice(&sorted);
        ((), ())
    }

    /// As [`sort_by_jvp`](Self::sort_by_jvp).
    #[inline]
    fn sort_unstable_by_jvp<F>(
        &mut self,
        compare: F,
        tangent: &mut [Tangent<Self::Element>],
        (): (),
    ) -> ((), ())
    where
        F: FnMut(&Self::Element, &Self::Element) -> core::cmp::Ordering,
    {
        self.sort_by_jvp(compare, tangent, ())
    }

    /// The tangents of the source.
    #[inline]
    fn copy_from_slice_jvp(
        &mut self,
        source: &[Self::Element],
        tangent: &mut [Tangent<Self::Element>],
        source_tangent: &[Tangent<Self::Element>],
    ) -> ((), ())
    where
        Self::Element: Copy,
    {
        self.sequence().copy_from_slice(source);
        tangent.clone_from_slice(source_tangent);
        ((), ())
    }
}

impl<T: Differentiable> SequenceForward for [T] {}
impl<T: Differentiable, const N: usize> SequenceForward for [T; N] {}

/// The `_jvp` siblings of the methods that change the length of a `Vec`.
pub trait VecForward: VecRules {
    /// Appends the tangents of elements that are handed over.
    fn extend_jvp<I>(
        &mut self,
        items: I,
        tangent: &mut Vec<Tangent<Self::Element>>,
        items_tangent: Tangent<I>,
    ) -> ((), ())
    where
        I: IntoIterator<Item = Self::Element>
            + Differentiable<Tangent: IntoIterator<Item = Tangent<Self::Element>>>;

    /// Appends the tangent.
    fn push_jvp(
        &mut self,
        value: Self::Element,
        tangent: &mut Vec<Tangent<Self::Element>>,
        value_tangent: Tangent<Self::Element>,
    ) -> ((), ());

    /// The tangent of the removed element; zero for `None`.
    fn pop_jvp(
        &mut self,
        tangent: &mut Vec<Tangent<Self::Element>>,
    ) -> (Option<Self::Element>, Tangent<Self::Element>);

    /// Removes the tangents, too.
    fn clear_jvp(&mut self, tangent: &mut Vec<Tangent<Self::Element>>) -> ((), ());

    /// Appends the tangents.
    fn extend_from_slice_jvp(
        &mut self,
        source: &[Self::Element],
        tangent: &mut Vec<Tangent<Self::Element>>,
        source_tangent: &[Tangent<Self::Element>],
    ) -> ((), ())
    where
        Self::Element: Clone;
}

impl<T: Differentiable> VecForward for Vec<T> {
    #[inline]
    fn extend_jvp<I>(
        &mut self,
        items: I,
        tangent: &mut Vec<Tangent<T>>,
        items_tangent: Tangent<I>,
    ) -> ((), ())
    where
        I: IntoIterator<Item = T> + Differentiable<Tangent: IntoIterator<Item = Tangent<T>>>,
    {
        self.extend(items);
        tangent.extend(items_tangent);
        ((), ())
    }

    #[inline]
    fn push_jvp(
        &mut self,
        value: T,
        tangent: &mut Vec<Tangent<T>>,
        value_tangent: Tangent<T>,
    ) -> ((), ()) {
        self.push(value);
        tangent.push(value_tangent);
        ((), ())
    }

    #[inline]
    fn pop_jvp(&mut self, tangent: &mut Vec<Tangent<T>>) -> (Option<T>, Tangent<T>) {
        (self.pop(), tangent.pop().unwrap_or_else(crate::Additive::zero))
    }

    #[inline]
    fn clear_jvp(&mut self, tangent: &mut Vec<Tangent<T>>) -> ((), ()) {
        self.clear();
        tangent.clear();
        ((), ())
    }

    #[inline]
    fn extend_from_slice_jvp(
        &mut self,
        source: &[T],
        tangent: &mut Vec<Tangent<T>>,
        source_tangent: &[Tangent<T>],
    ) -> ((), ())
    where
        T: Clone,
    {
        self.extend_from_slice(source);
        tangent.extend_from_slice(source_tangent);
        ((), ())
    }
}

/// The `_jvp` sibling of `clone`.
pub trait CloneForward: Clone + Differentiable {
    /// A copy of the tangent.
    #[inline(always)]
    fn clone_jvp(&self, tangent: Tangent<Self>) -> (Self, Tangent<Self>) {
        (self.clone(), tangent)
    }
}

impl<T: Clone + Differentiable> CloneForward for T {}
