//! Derivatives of the methods of slices, arrays and vectors.
//!
//! The pullback of a method that takes `&mut self` gets, after the cotangent of the result, that of
//! what the sequence holds afterwards, and returns that of what it held before. The cotangent of a
//! `Vec` or a slice may be shorter than the sequence: see
//! [values of any length](crate::Differentiable).

use core::borrow::Borrow;
use core::cmp::Ordering;

use super::in_place::in_place;
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

/// Rules of sorts, which all keep the order of equal elements: an unstable sort has a rule where equal elements are the
/// same. A row gives the comparison. The pullback is boxed: an opaque type would hold on to what the
/// comparison borrows.
macro_rules! sorts {
    ($($name:ident[$($generics:tt)*]($by:ident) $compare:expr;)*) => { pastey::paste! {$(
        /// To the places where the elements came from.
        #[inline]
        #[allow(unused_mut)]
        fn [<$name _vjp>]<$($generics)*>(
            &mut self,
            mut $by: F,
        ) -> ((), Box<dyn FnOnce((), Self::Tangent) -> (Self::Tangent, ())>) {
            let from = sorted_from(self.sequence(), &mut $compare);
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

        /// The tangents follow their elements.
        #[inline]
        #[allow(unused_mut)]
        fn [<$name _jvp>]<$($generics)*>(
            &mut self,
            mut $by: F,
            tangent: &mut [Tangent<Self::Element>],
            (): (),
        ) -> ((), ()) {
            let from = sorted_from(self.sequence(), &mut $compare);
            let sorted: Vec<_> = from.into_iter().map(|place| tangent[place].clone()).collect();
            tangent.clone_from_slice(&sorted);
            ((), ())
        }
    )*}};
}

/// The `_vjp` and `_jvp` siblings of the methods of slices and arrays. What changes a sequence changes
/// its tangent alike.
pub trait SequenceRules: Differentiable<Tangent: Elements<Tangent<Self::Element>>> {
    /// An element.
    type Element: Differentiable;

    /// The sequence.
    fn sequence(&mut self) -> &mut [Self::Element];

    /// The elements, to read.
    fn view(&self) -> &[Self::Element];

    /// The cotangents of the elements.
    #[inline(always)]
    fn as_slice_vjp(&self) -> (&[Self::Element], fn(Vec<Tangent<Self::Element>>) -> Self::Tangent) {
        (self.view(), Elements::from_copy)
    }

    /// The tangents of the elements.
    #[inline]
    fn as_slice_jvp(
        &self,
        tangent: &[Tangent<Self::Element>],
    ) -> (&[Self::Element], Vec<Tangent<Self::Element>>) {
        (self.view(), tangent.to_vec())
    }

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

    /// To each row the cotangents of its copies. The pullback is boxed: an opaque type would hold on to what rows
    /// borrow.
    #[inline]
    fn concat_vjp<T: Clone + Differentiable>(
        &self,
    ) -> (Vec<T>, Box<dyn FnOnce(Vec<Tangent<T>>) -> Self::Tangent>)
    where
        Self::Element: Borrow<[T]> + Differentiable<Tangent: Elements<Tangent<T>>>,
    {
        let lengths: Vec<usize> = self.view().iter().map(|row| row.borrow().len()).collect();
        let pullback = move |cotangent: Vec<Tangent<T>>| {
            let mut copies = cotangent.into_iter();
            let rows = lengths.into_iter();
            let rows =
                rows.map(|length| Elements::from_copy(copies.by_ref().take(length).collect()));
            Elements::from_copy(rows.collect())
        };
        (self.view().concat(), Box::new(pullback))
    }

    /// The tangents of the rows, one after the other.
    #[inline]
    fn concat_jvp<T: Clone + Differentiable>(
        &self,
        tangent: &[Tangent<Self::Element>],
    ) -> (Vec<T>, Vec<Tangent<T>>)
    where
        Self::Element: Borrow<[T]> + Differentiable<Tangent: Borrow<[Tangent<T>]>>,
    {
        (self.view().concat(), tangent.concat())
    }

    in_place! {
        sequence [[Tangent<Self::Element>]] [Self::Tangent]

        /// Changes places back.
        swap(i: usize, j: usize) => |_, len, (), g| {
            g.elements(len).swap(i, j);
            (g, (), ())
        };
        /// Turns the order back.
        reverse() => |_, len, (), g| {
            g.elements(len).reverse();
            g
        };
        /// Turns the elements back.
        rotate_left(by: usize) => |_, len, (), g| {
            g.elements(len).rotate_right(by);
            (g, ())
        };
        /// Turns the elements back.
        rotate_right(by: usize) => |_, len, (), g| {
            g.elements(len).rotate_left(by);
            (g, ())
        };
        /// To the value, the sum; nothing to what it overwrote.
        fill(; value: Element) where Element: Clone
            => |_, _, (), g| (Additive::zero(), crate::rt::sum(g.into_source()));
        /// To the source, element by element; nothing to what it overwrote.
        copy_from_slice(; source: Slice) where Element: Copy,
            |tangents| tangents.0.clone_from_slice(tangents.1)
            => |_, _, (), g| (Additive::zero(), g.into_source());
    }

    sorts! {
        sort_by[F: FnMut(&Self::Element, &Self::Element) -> Ordering](compare) compare;
        sort_unstable_by[F: FnMut(&Self::Element, &Self::Element) -> Ordering](compare) compare;
        sort_by_key[K: Ord, F: FnMut(&Self::Element) -> K](key) |a, b| key(a).cmp(&key(b));
    }
}

/// Sorts, and returns where each element came from.
pub(super) fn sorted_from<T>(
    elements: &mut [T],
    compare: &mut dyn FnMut(&T, &T) -> Ordering,
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

/// The `_vjp` and `_jvp` siblings of `clone`.
pub trait CloneRules: Clone + Differentiable {
    /// The cotangent of the copy.
    #[inline(always)]
    fn clone_vjp(&self) -> (Self, impl FnOnce(Tangent<Self>) -> Tangent<Self> + use<Self>) {
        (self.clone(), |cotangent| cotangent)
    }

    /// A copy of the tangent.
    #[inline(always)]
    fn clone_jvp(&self, tangent: Tangent<Self>) -> (Self, Tangent<Self>) {
        (self.clone(), tangent)
    }
}

impl<T: Clone + Differentiable> CloneRules for T {}

/// `elements.copy_within(from..to, at)`
#[doc(hidden)]
pub fn copied_within<T: Copy>(elements: &mut [T], from: usize, to: usize, at: usize) {
    elements.copy_within(from..to, at);
}

/// The derivative of [`copied_within`].
#[doc(hidden)]
#[allow(non_camel_case_types)]
pub enum copied_within {}

impl copied_within {
    /// The cotangents of the copies to what they are copies of; nothing to what they overwrote.
    #[inline]
    #[track_caller]
    pub fn vjp<T: Differentiable + Copy>(
        elements: &mut [T],
        from: usize,
        to: usize,
        at: usize,
    ) -> ((), impl FnOnce((), Vec<Tangent<T>>) -> (Vec<Tangent<T>>, (), (), ()) + use<T>) {
        let len = elements.len();
        elements.copy_within(from..to, at);
        ((), move |(), mut cotangent: Vec<Tangent<T>>| {
            let elements = cotangent.elements(len);
            let copies: Vec<_> = elements[at..at + (to - from)]
                .iter_mut()
                .map(|copy| core::mem::replace(copy, Additive::zero()))
                .collect();
            for (element, copy) in elements[from..to].iter_mut().zip(copies) {
                element.accumulate(copy);
            }
            (cotangent, (), (), ())
        })
    }

    /// Copies the tangents, too.
    #[inline]
    #[track_caller]
    pub fn jvp<T: Differentiable + Copy>(
        elements: &mut [T],
        from: usize,
        to: usize,
        at: usize,
        tangent: &mut [Tangent<T>],
        _: (),
        _: (),
        _: (),
    ) -> ((), ()) {
        elements.copy_within(from..to, at);
        let copies = tangent[from..to].to_vec();
        tangent[at..at + copies.len()].clone_from_slice(&copies);
        ((), ())
    }
}
