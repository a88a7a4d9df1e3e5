//! Derivatives of the methods that change the length of a `Vec`.
//!
//! As in [`sequence`](super::sequence): a pullback gets the cotangent of the result, then that of what
//! the `Vec` holds afterwards, which may be shorter than the `Vec`.

#![allow(clippy::type_complexity)]

use super::sequence::Elements;
use crate::{Additive, Differentiable, Tangent};

/// Cotangents of the elements of a `Vec`.
type Tangents<T> = Vec<Tangent<T>>;

/// Those of its elements.
type Of<V> = Tangents<<V as VecRules>::Element>;

/// The first `len` cotangents, and no more.
fn fitted<T: Additive>(mut cotangent: Vec<T>, len: usize) -> Vec<T> {
    cotangent.elements(len);
    cotangent.truncate(len);
    cotangent
}

/// The cotangents of the elements from `len` on, which the `Vec` did not have before.
fn new_ones<T>(cotangent: &mut Vec<T>, len: usize) -> Vec<T> {
    if cotangent.len() > len { cotangent.split_off(len) } else { Vec::new() }
}

/// The `_vjp` and `_jvp` siblings of the methods of a `Vec`. What changes it changes its tangent alike.
pub trait VecRules {
    /// An element.
    type Element: Differentiable;

    /// The `Vec`.
    fn elements_mut(&mut self) -> &mut Vec<Self::Element>;

    /// Takes the cotangent of the new element out.
    #[inline]
    fn push_vjp(
        &mut self,
        value: Self::Element,
    ) -> ((), impl FnOnce((), Of<Self>) -> (Of<Self>, Tangent<Self::Element>) + use<Self>) {
        let elements = self.elements_mut();
        let len = elements.len();
        elements.push(value);
        ((), move |(), mut cotangent: Of<Self>| {
            cotangent.truncate(len + 1);
            let last = if cotangent.len() > len { cotangent.pop() } else { None };
            (cotangent, last.unwrap_or_else(Additive::zero))
        })
    }

    /// Appends the tangent.
    #[inline]
    fn push_jvp(
        &mut self,
        value: Self::Element,
        tangent: &mut Of<Self>,
        value_tangent: Tangent<Self::Element>,
    ) -> ((), ()) {
        self.elements_mut().push(value);
        tangent.push(value_tangent);
        ((), ())
    }

    /// Puts the cotangent of the removed element back.
    #[inline]
    fn pop_vjp(
        &mut self,
    ) -> (
        Option<Self::Element>,
        impl FnOnce(Tangent<Self::Element>, Of<Self>) -> Of<Self> + use<Self>,
    ) {
        let elements = self.elements_mut();
        let last = elements.pop();
        let (was_there, len) = (last.is_some(), elements.len());
        (last, move |last, mut cotangent: Of<Self>| {
            cotangent.resize_with(len, Additive::zero);
            if was_there {
                cotangent.push(last);
            }
            cotangent
        })
    }

    /// The tangent of the removed element; zero for `None`.
    #[inline]
    fn pop_jvp(
        &mut self,
        tangent: &mut Of<Self>,
    ) -> (Option<Self::Element>, Tangent<Self::Element>) {
        (self.elements_mut().pop(), tangent.pop().unwrap_or_else(Additive::zero))
    }

    /// Nothing to what was there.
    #[inline]
    fn clear_vjp(&mut self) -> ((), impl FnOnce((), Of<Self>) -> Of<Self> + use<Self>) {
        self.elements_mut().clear();
        ((), |(), _| Vec::new())
    }

    /// Removes the tangents, too.
    #[inline]
    fn clear_jvp(&mut self, tangent: &mut Of<Self>) -> ((), ()) {
        self.elements_mut().clear();
        tangent.clear();
        ((), ())
    }

    /// Takes the cotangents of the new elements out.
    #[inline]
    fn extend_from_slice_vjp(
        &mut self,
        source: &[Self::Element],
    ) -> ((), impl FnOnce((), Of<Self>) -> (Of<Self>, Of<Self>) + use<Self>)
    where
        Self::Element: Clone,
    {
        let elements = self.elements_mut();
        let len = elements.len();
        elements.extend_from_slice(source);
        ((), move |(), mut cotangent| {
            let new = new_ones(&mut cotangent, len);
            (cotangent, new)
        })
    }

    /// Appends the tangents.
    #[inline]
    fn extend_from_slice_jvp(
        &mut self,
        source: &[Self::Element],
        tangent: &mut Of<Self>,
        source_tangent: &[Tangent<Self::Element>],
    ) -> ((), ())
    where
        Self::Element: Clone,
    {
        self.elements_mut().extend_from_slice(source);
        tangent.extend_from_slice(source_tangent);
        ((), ())
    }

    /// The same for elements that are handed over.
    #[inline]
    fn extend_vjp<I>(
        &mut self,
        items: I,
    ) -> ((), impl FnOnce((), Of<Self>) -> (Of<Self>, Tangent<I>) + use<Self, I>)
    where
        I: IntoIterator<Item = Self::Element>
            + Differentiable<Tangent: Elements<Tangent<Self::Element>>>,
    {
        let elements = self.elements_mut();
        let len = elements.len();
        elements.extend(items);
        ((), move |(), mut cotangent| {
            let new = new_ones(&mut cotangent, len);
            (cotangent, Elements::from_copy(new))
        })
    }

    /// Appends the tangents of elements that are handed over.
    #[inline]
    fn extend_jvp<I>(
        &mut self,
        items: I,
        tangent: &mut Of<Self>,
        items_tangent: Tangent<I>,
    ) -> ((), ())
    where
        I: IntoIterator<Item = Self::Element>
            + Differentiable<Tangent: IntoIterator<Item = Tangent<Self::Element>>>,
    {
        self.elements_mut().extend(items);
        tangent.extend(items_tangent);
        ((), ())
    }

    /// Takes the cotangent of the new element out.
    #[inline]
    #[track_caller]
    fn insert_vjp(
        &mut self,
        index: usize,
        value: Self::Element,
    ) -> ((), impl FnOnce((), Of<Self>) -> (Of<Self>, (), Tangent<Self::Element>) + use<Self>) {
        let elements = self.elements_mut();
        elements.insert(index, value);
        let len = elements.len();
        ((), move |(), cotangent| {
            let mut before = fitted(cotangent, len);
            let inserted = before.remove(index);
            (before, (), inserted)
        })
    }

    /// Inserts the tangent.
    #[inline]
    #[track_caller]
    fn insert_jvp(
        &mut self,
        index: usize,
        value: Self::Element,
        tangent: &mut Of<Self>,
        _: (),
        value_tangent: Tangent<Self::Element>,
    ) -> ((), ()) {
        self.elements_mut().insert(index, value);
        tangent.insert(index, value_tangent);
        ((), ())
    }

    /// Puts the cotangent of the removed element back.
    #[inline]
    #[track_caller]
    fn remove_vjp(
        &mut self,
        index: usize,
    ) -> (Self::Element, impl FnOnce(Tangent<Self::Element>, Of<Self>) -> (Of<Self>, ()) + use<Self>)
    {
        let elements = self.elements_mut();
        let removed = elements.remove(index);
        let len = elements.len();
        (removed, move |removed, cotangent| {
            let mut before = fitted(cotangent, len);
            before.insert(index, removed);
            (before, ())
        })
    }

    /// Removes the tangent.
    #[inline]
    #[track_caller]
    fn remove_jvp(
        &mut self,
        index: usize,
        tangent: &mut Of<Self>,
        _: (),
    ) -> (Self::Element, Tangent<Self::Element>) {
        (self.elements_mut().remove(index), tangent.remove(index))
    }

    /// Puts the cotangent of the removed element back, and that of the last one at the end.
    #[inline]
    #[track_caller]
    fn swap_remove_vjp(
        &mut self,
        index: usize,
    ) -> (Self::Element, impl FnOnce(Tangent<Self::Element>, Of<Self>) -> (Of<Self>, ()) + use<Self>)
    {
        let elements = self.elements_mut();
        let removed = elements.swap_remove(index);
        let len = elements.len();
        (removed, move |removed, cotangent| {
            let mut before = fitted(cotangent, len);
            before.push(removed);
            before.swap(index, len);
            (before, ())
        })
    }

    /// Removes the tangent alike.
    #[inline]
    #[track_caller]
    fn swap_remove_jvp(
        &mut self,
        index: usize,
        tangent: &mut Of<Self>,
        _: (),
    ) -> (Self::Element, Tangent<Self::Element>) {
        (self.elements_mut().swap_remove(index), tangent.swap_remove(index))
    }

    /// Nothing to what was removed.
    #[inline]
    fn truncate_vjp(
        &mut self,
        len: usize,
    ) -> ((), impl FnOnce((), Of<Self>) -> (Of<Self>, ()) + use<Self>) {
        let elements = self.elements_mut();
        elements.truncate(len);
        let len = elements.len();
        ((), move |(), cotangent| (fitted(cotangent, len), ()))
    }

    /// Removes the tangents, too.
    #[inline]
    fn truncate_jvp(&mut self, len: usize, tangent: &mut Of<Self>, _: ()) -> ((), ()) {
        self.elements_mut().truncate(len);
        tangent.truncate(len);
        ((), ())
    }

    /// To the value, the sum of the cotangents of its copies; nothing to what was removed.
    #[inline]
    fn resize_vjp(
        &mut self,
        len: usize,
        value: Self::Element,
    ) -> ((), impl FnOnce((), Of<Self>) -> (Of<Self>, (), Tangent<Self::Element>) + use<Self>)
    where
        Self::Element: Clone,
    {
        let elements = self.elements_mut();
        let kept = elements.len().min(len);
        elements.resize(len, value);
        ((), move |(), cotangent| {
            let mut before = fitted(cotangent, len);
            let mut to_value = Tangent::<Self::Element>::zero();
            before.drain(kept..).for_each(|copy| to_value.accumulate(copy));
            (before, (), to_value)
        })
    }

    /// Copies the tangent, too.
    #[inline]
    fn resize_jvp(
        &mut self,
        len: usize,
        value: Self::Element,
        tangent: &mut Of<Self>,
        _: (),
        value_tangent: Tangent<Self::Element>,
    ) -> ((), ())
    where
        Self::Element: Clone,
    {
        self.elements_mut().resize(len, value);
        tangent.resize(len, value_tangent);
        ((), ())
    }

    /// Joins the cotangents of both parts.
    #[inline]
    #[track_caller]
    fn split_off_vjp(
        &mut self,
        at: usize,
    ) -> (Vec<Self::Element>, impl FnOnce(Of<Self>, Of<Self>) -> (Of<Self>, ()) + use<Self>) {
        let rest = self.elements_mut().split_off(at);
        (rest, move |rest, cotangent| {
            let mut before = fitted(cotangent, at);
            before.extend(rest);
            (before, ())
        })
    }

    /// Splits the tangents, too.
    #[inline]
    #[track_caller]
    fn split_off_jvp(
        &mut self,
        at: usize,
        tangent: &mut Of<Self>,
        _: (),
    ) -> (Vec<Self::Element>, Of<Self>) {
        (self.elements_mut().split_off(at), tangent.split_off(at))
    }

    /// Takes the cotangents of the new elements out. Nothing to what the other holds afterwards:
    /// it is empty.
    #[inline]
    fn append_vjp(
        &mut self,
        other: &mut Vec<Self::Element>,
    ) -> ((), impl FnOnce((), Of<Self>, Of<Self>) -> (Of<Self>, Of<Self>) + use<Self>) {
        let elements = self.elements_mut();
        let kept = elements.len();
        elements.append(other);
        let len = elements.len();
        ((), move |(), cotangent, _| {
            let mut before = fitted(cotangent, len);
            let appended = before.split_off(kept);
            (before, appended)
        })
    }

    /// Appends the tangents, too.
    #[inline]
    fn append_jvp(
        &mut self,
        other: &mut Vec<Self::Element>,
        tangent: &mut Of<Self>,
        other_tangent: &mut Of<Self>,
    ) -> ((), ()) {
        self.elements_mut().append(other);
        tangent.append(other_tangent);
        ((), ())
    }

    /// To the places that the elements had which were kept. The pullback is boxed: an opaque type would
    /// hold on to what the predicate borrows.
    #[inline]
    fn retain_vjp<F>(&mut self, keeps: F) -> ((), Box<dyn FnOnce((), Of<Self>) -> (Of<Self>, ())>)
    where
        F: FnMut(&Self::Element) -> bool,
    {
        let kept = retained(self.elements_mut(), keeps);
        let pullback = move |(), cotangent| {
            let mut after =
                fitted(cotangent, kept.iter().filter(|kept| **kept).count()).into_iter();
            let before = kept.iter().map(|kept| match kept {
                true => after.next().unwrap_or_else(Additive::zero),
                false => Additive::zero(),
            });
            (before.collect(), ())
        };
        ((), Box::new(pullback))
    }

    /// Keeps the tangents of the elements that are kept.
    #[inline]
    fn retain_jvp<F>(&mut self, keeps: F, tangent: &mut Of<Self>, _: ()) -> ((), ())
    where
        F: FnMut(&Self::Element) -> bool,
    {
        let mut kept = retained(self.elements_mut(), keeps).into_iter();
        tangent.retain(|_| kept.next().unwrap_or(false));
        ((), ())
    }
}

/// Keeps some elements; says of each whether it is one of them.
fn retained<T>(elements: &mut Vec<T>, mut keeps: impl FnMut(&T) -> bool) -> Vec<bool> {
    let mut kept = Vec::with_capacity(elements.len());
    elements.retain(|element| {
        let keeps = keeps(element);
        kept.push(keeps);
        keeps
    });
    kept
}

impl<T: Differentiable> VecRules for Vec<T> {
    type Element = T;

    fn elements_mut(&mut self) -> &mut Vec<T> {
        self
    }
}

/// The elements in a range, which the `Vec` loses: what `drain` gives one by one.
#[doc(hidden)]
pub fn drained<T>(elements: &mut Vec<T>, from: usize, to: usize) -> Vec<T> {
    elements.drain(from..to).collect()
}

/// The derivative of [`drained`].
#[doc(hidden)]
#[allow(non_camel_case_types)]
pub enum drained {}

impl drained {
    /// Puts the cotangents of the removed elements back.
    #[inline]
    #[track_caller]
    pub fn vjp<T: Differentiable>(
        elements: &mut Vec<T>,
        from: usize,
        to: usize,
    ) -> (Vec<T>, impl FnOnce(Tangents<T>, Tangents<T>) -> (Tangents<T>, (), ()) + use<T>) {
        let removed = drained(elements, from, to);
        let len = elements.len();
        (removed, move |removed, cotangent| {
            let mut before = fitted(cotangent, len);
            before.splice(from..from, fitted(removed, to - from));
            (before, (), ())
        })
    }

    /// Removes the tangents alike.
    #[inline]
    #[track_caller]
    pub fn jvp<T: Differentiable>(
        elements: &mut Vec<T>,
        from: usize,
        to: usize,
        tangent: &mut Tangents<T>,
        _: (),
        _: (),
    ) -> (Vec<T>, Tangents<T>) {
        (drained(elements, from, to), drained(tangent, from, to))
    }
}
