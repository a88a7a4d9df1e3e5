//! Derivatives of the methods of slices, arrays and vectors.
//!
//! The pullback of a method that takes `&mut self` gets, after the cotangent of the result, that of
//! what the sequence holds afterwards, and returns that of what it held before. The cotangent of a
//! `Vec` or a slice may be shorter than the sequence: see
//! [values of any length](crate::Differentiable).

#![allow(clippy::type_complexity)]

use crate::{Additive, Differentiable, Tangent};

/// A cotangent of a sequence.
pub trait Elements<T>: Additive {
    /// The cotangents of the first `len` elements.
    fn elements(&mut self, len: usize) -> &mut [T];
    /// From those of a copy.
    fn from_copy(copy: Vec<T>) -> Self;
    /// To those of what it was copied from.
    fn into_source(self) -> Vec<T>;
}

impl<T: Additive> Elements<T> for Vec<T> {
    fn elements(&mut self, len: usize) -> &mut [T] {
        if self.len() < len {
            self.resize_with(len, T::zero);
        }
        &mut self[..len]
    }

    fn from_copy(copy: Vec<T>) -> Self {
        copy
    }

    fn into_source(self) -> Vec<T> {
        self
    }
}

impl<T: Additive, const N: usize> Elements<T> for [T; N] {
    fn elements(&mut self, len: usize) -> &mut [T] {
        &mut self[..len]
    }

    fn from_copy(copy: Vec<T>) -> Self {
        let mut elements = copy.into_iter();
        core::array::from_fn(|_| elements.next().unwrap_or_else(T::zero))
    }

    fn into_source(self) -> Vec<T> {
        self.into()
    }
}

/// The `_vjp` siblings of the methods of slices and arrays.
pub trait SequenceRules: Differentiable<Tangent: Elements<Tangent<Self::Element>>> {
    /// An element.
    type Element: Differentiable;

    /// The sequence.
    fn sequence(&mut self) -> &mut [Self::Element];

    /// The elements, to read.
    fn view(&self) -> &[Self::Element];

    /// The cotangents of the copies.
    #[inline]
    fn to_vec_vjp(
        &self,
    ) -> (Vec<Self::Element>, impl FnOnce(Vec<Tangent<Self::Element>>) -> Self::Tangent + use<Self>)
    where
        Self::Element: Clone,
    {
        (self.view().to_vec(), Elements::from_copy)
    }

    /// Changes places back.
    #[inline]
    fn swap_vjp(
        &mut self,
        i: usize,
        j: usize,
    ) -> ((), impl FnOnce((), Self::Tangent) -> (Self::Tangent, (), ()) + use<Self>) {
        let len = self.view().len();
        self.sequence().swap(i, j);
        ((), move |(), mut cotangent: Self::Tangent| {
            cotangent.elements(len).swap(i, j);
            (cotangent, (), ())
        })
    }

    /// Turns the order back.
    #[inline]
    fn reverse_vjp(&mut self) -> ((), impl FnOnce((), Self::Tangent) -> Self::Tangent + use<Self>) {
        let len = self.view().len();
        self.sequence().reverse();
        ((), move |(), mut cotangent: Self::Tangent| {
            cotangent.elements(len).reverse();
            cotangent
        })
    }

    /// Turns the elements back.
    #[inline]
    fn rotate_left_vjp(
        &mut self,
        by: usize,
    ) -> ((), impl FnOnce((), Self::Tangent) -> (Self::Tangent, ()) + use<Self>) {
        let len = self.view().len();
        self.sequence().rotate_left(by);
        ((), move |(), mut cotangent: Self::Tangent| {
            cotangent.elements(len).rotate_right(by);
            (cotangent, ())
        })
    }

    /// Turns the elements back.
    #[inline]
    fn rotate_right_vjp(
        &mut self,
        by: usize,
    ) -> ((), impl FnOnce((), Self::Tangent) -> (Self::Tangent, ()) + use<Self>) {
        let len = self.view().len();
        self.sequence().rotate_right(by);
        ((), move |(), mut cotangent: Self::Tangent| {
            cotangent.elements(len).rotate_left(by);
            (cotangent, ())
        })
    }

    /// To the places where the elements came from. The pullback is boxed: an opaque type would hold on
    /// to what the comparison borrows.
    #[inline]
    fn sort_by_vjp<F>(
        &mut self,
        mut compare: F,
    ) -> ((), Box<dyn FnOnce((), Self::Tangent) -> (Self::Tangent, ())>)
    where
        F: FnMut(&Self::Element, &Self::Element) -> core::cmp::Ordering,
    {
        let from = sorted_from(self.sequence(), &mut compare);
        let pullback = move |(), mut cotangent: Self::Tangent| {
            let mut before = Self::Tangent::zero();
            let elements = cotangent.elements(from.len());
            let places = before.elements(from.len());
            for (&place, element) in from.iter().zip(elements) {
                places[place].accumulate(element.clone());
            }
            (before, ())
        };
        ((), Box::new(pullback))
    }

    /// As [`sort_by_vjp`](Self::sort_by_vjp), which keeps the order of equal elements: an order that
    /// the unstable sort may give them, too.
    #[inline]
    fn sort_unstable_by_vjp<F>(
        &mut self,
        compare: F,
    ) -> ((), Box<dyn FnOnce((), Self::Tangent) -> (Self::Tangent, ())>)
    where
        F: FnMut(&Self::Element, &Self::Element) -> core::cmp::Ordering,
    {
        self.sort_by_vjp(compare)
    }

    /// To the value, the sum; nothing to what it overwrote.
    #[inline]
    fn fill_vjp(
        &mut self,
        value: Self::Element,
    ) -> ((), impl FnOnce((), Self::Tangent) -> (Self::Tangent, Tangent<Self::Element>) + use<Self>)
    where
        Self::Element: Clone,
    {
        self.sequence().fill(value);
        ((), |(), cotangent: Self::Tangent| {
            (Additive::zero(), crate::rt::sum(cotangent.into_source()))
        })
    }

    /// To the source, element by element; nothing to what it overwrote.
    #[inline]
    fn copy_from_slice_vjp(
        &mut self,
        source: &[Self::Element],
    ) -> (
        (),
        impl FnOnce((), Self::Tangent) -> (Self::Tangent, Vec<Tangent<Self::Element>>) + use<Self>,
    )
    where
        Self::Element: Copy,
    {
        self.sequence().copy_from_slice(source);
        ((), |(), cotangent: Self::Tangent| (Additive::zero(), cotangent.into_source()))
    }
}

/// Sorts, and returns where each element came from.
pub(super) fn sorted_from<T>(
    elements: &mut [T],
    compare: &mut dyn FnMut(&T, &T) -> core::cmp::Ordering,
) -> Vec<usize> {
    let mut from: Vec<usize> = (0..elements.len()).collect();
    from.sort_by(|&i, &j| compare(&elements[i], &elements[j]));
    // Follows each cycle of the permutation: place `i` gets what lies at `from[i]`.
    let mut pending = from.clone();
    for start in 0..pending.len() {
        let mut place = start;
        while pending[place] != start {
            let next = pending[place];
            elements.swap(place, next);
            pending[place] = place;
            place = next;
        }
        pending[place] = place;
    }
    from
}

impl<T: Differentiable> SequenceRules for [T] {
    type Element = T;

    fn sequence(&mut self) -> &mut [T] {
        self
    }

    fn view(&self) -> &[T] {
        self
    }
}

impl<T: Differentiable, const N: usize> SequenceRules for [T; N] {
    type Element = T;

    fn sequence(&mut self) -> &mut [T] {
        self
    }

    fn view(&self) -> &[T] {
        self
    }
}

/// The `_vjp` siblings of the methods that change the length of a `Vec`.
pub trait VecRules {
    /// An element.
    type Element: Differentiable;

    /// Takes the cotangent of the new element out.
    fn push_vjp(
        &mut self,
        value: Self::Element,
    ) -> (
        (),
        impl FnOnce(
            (),
            Vec<Tangent<Self::Element>>,
        ) -> (Vec<Tangent<Self::Element>>, Tangent<Self::Element>)
        + use<Self>,
    );

    /// Puts the cotangent of the removed element back.
    fn pop_vjp(
        &mut self,
    ) -> (
        Option<Self::Element>,
        impl FnOnce(Tangent<Self::Element>, Vec<Tangent<Self::Element>>) -> Vec<Tangent<Self::Element>>
        + use<Self>,
    );

    /// Nothing to what was there.
    fn clear_vjp(
        &mut self,
    ) -> ((), impl FnOnce((), Vec<Tangent<Self::Element>>) -> Vec<Tangent<Self::Element>> + use<Self>);

    /// Takes the cotangents of the new elements out.
    fn extend_from_slice_vjp(
        &mut self,
        source: &[Self::Element],
    ) -> (
        (),
        impl FnOnce(
            (),
            Vec<Tangent<Self::Element>>,
        ) -> (Vec<Tangent<Self::Element>>, Vec<Tangent<Self::Element>>)
        + use<Self>,
    )
    where
        Self::Element: Clone;

    /// The same for elements that are handed over.
    fn extend_vjp<I>(
        &mut self,
        items: I,
    ) -> (
        (),
        impl FnOnce((), Vec<Tangent<Self::Element>>) -> (Vec<Tangent<Self::Element>>, Tangent<I>)
        + use<Self, I>,
    )
    where
        I: IntoIterator<Item = Self::Element>
            + Differentiable<Tangent: Elements<Tangent<Self::Element>>>;
}

impl<T: Differentiable> VecRules for Vec<T> {
    type Element = T;

    #[inline]
    fn push_vjp(
        &mut self,
        value: T,
    ) -> ((), impl FnOnce((), Vec<Tangent<T>>) -> (Vec<Tangent<T>>, Tangent<T>) + use<T>) {
        let len = self.len();
        self.push(value);
        ((), move |(), mut cotangent: Vec<Tangent<T>>| {
            cotangent.truncate(len + 1);
            let last = if cotangent.len() > len { cotangent.pop() } else { None };
            (cotangent, last.unwrap_or_else(Additive::zero))
        })
    }

    #[inline]
    fn pop_vjp(
        &mut self,
    ) -> (Option<T>, impl FnOnce(Tangent<T>, Vec<Tangent<T>>) -> Vec<Tangent<T>> + use<T>) {
        let last = self.pop();
        let was_there = last.is_some();
        let len = self.len();
        (last, move |last, mut cotangent: Vec<Tangent<T>>| {
            cotangent.resize_with(len, Additive::zero);
            if was_there {
                cotangent.push(last);
            }
            cotangent
        })
    }

    #[inline]
    fn clear_vjp(&mut self) -> ((), impl FnOnce((), Vec<Tangent<T>>) -> Vec<Tangent<T>> + use<T>) {
        self.clear();
        ((), |(), _: Vec<Tangent<T>>| Vec::new())
    }

    #[inline]
    fn extend_from_slice_vjp(
        &mut self,
        source: &[T],
    ) -> ((), impl FnOnce((), Vec<Tangent<T>>) -> (Vec<Tangent<T>>, Vec<Tangent<T>>) + use<T>)
    where
        T: Clone,
    {
        let len = self.len();
        self.extend_from_slice(source);
        ((), move |(), mut cotangent: Vec<Tangent<T>>| {
            let new = split_off(&mut cotangent, len);
            (cotangent, new)
        })
    }

    #[inline]
    fn extend_vjp<I>(
        &mut self,
        items: I,
    ) -> ((), impl FnOnce((), Vec<Tangent<T>>) -> (Vec<Tangent<T>>, Tangent<I>) + use<T, I>)
    where
        I: IntoIterator<Item = T> + Differentiable<Tangent: Elements<Tangent<T>>>,
    {
        let len = self.len();
        self.extend(items);
        ((), move |(), mut cotangent: Vec<Tangent<T>>| {
            let new = split_off(&mut cotangent, len);
            (cotangent, Elements::from_copy(new))
        })
    }
}

/// The cotangents of the elements from `len` on, which the sequence did not have before.
fn split_off<T>(cotangent: &mut Vec<T>, len: usize) -> Vec<T> {
    if cotangent.len() > len { cotangent.split_off(len) } else { Vec::new() }
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
