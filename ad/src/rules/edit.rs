//! Derivatives of the methods that insert, remove and move elements of a `Vec`.
//!
//! As in [`sequence`](super::sequence): a pullback gets the cotangent of the result, then that of what
//! the `Vec` holds afterwards, which may be shorter than the `Vec`.

#![allow(clippy::type_complexity)]

use super::sequence::Elements;
use crate::{Additive, Differentiable, Tangent};

/// Cotangents of the elements of a `Vec`.
type Tangents<T> = Vec<Tangent<T>>;

/// The first `len` cotangents, and no more.
fn fitted<T: Additive>(mut cotangent: Vec<T>, len: usize) -> Vec<T> {
    cotangent.elements(len);
    cotangent.truncate(len);
    cotangent
}

/// The `_vjp` and `_jvp` siblings of the methods of a `Vec`.
pub trait EditRules<T: Differentiable> {
    /// Takes the cotangent of the new element out.
    fn insert_vjp(
        &mut self,
        index: usize,
        value: T,
    ) -> ((), impl FnOnce((), Tangents<T>) -> (Tangents<T>, (), Tangent<T>) + use<Self, T>);

    /// Inserts the tangent.
    fn insert_jvp(
        &mut self,
        index: usize,
        value: T,
        tangent: &mut Tangents<T>,
        _: (),
        value_tangent: Tangent<T>,
    ) -> ((), ());

    /// Puts the cotangent of the removed element back.
    fn remove_vjp(
        &mut self,
        index: usize,
    ) -> (T, impl FnOnce(Tangent<T>, Tangents<T>) -> (Tangents<T>, ()) + use<Self, T>);

    /// Removes the tangent.
    fn remove_jvp(&mut self, index: usize, tangent: &mut Tangents<T>, _: ()) -> (T, Tangent<T>);

    /// Puts the cotangent of the removed element back, and that of the last one at the end.
    fn swap_remove_vjp(
        &mut self,
        index: usize,
    ) -> (T, impl FnOnce(Tangent<T>, Tangents<T>) -> (Tangents<T>, ()) + use<Self, T>);

    /// Removes the tangent alike.
    fn swap_remove_jvp(
        &mut self,
        index: usize,
        tangent: &mut Tangents<T>,
        _: (),
    ) -> (T, Tangent<T>);

    /// Nothing to what was removed.
    fn truncate_vjp(
        &mut self,
        len: usize,
    ) -> ((), impl FnOnce((), Tangents<T>) -> (Tangents<T>, ()) + use<Self, T>);

    /// Removes the tangents, too.
    fn truncate_jvp(&mut self, len: usize, tangent: &mut Tangents<T>, _: ()) -> ((), ());

    /// To the value, the sum of the cotangents of its copies; nothing to what was removed.
    fn resize_vjp(
        &mut self,
        len: usize,
        value: T,
    ) -> ((), impl FnOnce((), Tangents<T>) -> (Tangents<T>, (), Tangent<T>) + use<Self, T>)
    where
        T: Clone;

    /// Copies the tangent, too.
    fn resize_jvp(
        &mut self,
        len: usize,
        value: T,
        tangent: &mut Tangents<T>,
        _: (),
        value_tangent: Tangent<T>,
    ) -> ((), ())
    where
        T: Clone;

    /// Joins the cotangents of both parts.
    fn split_off_vjp(
        &mut self,
        at: usize,
    ) -> (Vec<T>, impl FnOnce(Tangents<T>, Tangents<T>) -> (Tangents<T>, ()) + use<Self, T>);

    /// Splits the tangents, too.
    fn split_off_jvp(
        &mut self,
        at: usize,
        tangent: &mut Tangents<T>,
        _: (),
    ) -> (Vec<T>, Tangents<T>);

    /// Takes the cotangents of the new elements out. Nothing to what the other holds afterwards:
    /// it is empty.
    fn append_vjp(
        &mut self,
        other: &mut Vec<T>,
    ) -> ((), impl FnOnce((), Tangents<T>, Tangents<T>) -> (Tangents<T>, Tangents<T>) + use<Self, T>);

    /// Appends the tangents, too.
    fn append_jvp(
        &mut self,
        other: &mut Vec<T>,
        tangent: &mut Tangents<T>,
        other_tangent: &mut Tangents<T>,
    ) -> ((), ());
}

impl<T: Differentiable> EditRules<T> for Vec<T> {
    #[inline]
    #[track_caller]
    fn insert_vjp(
        &mut self,
        index: usize,
        value: T,
    ) -> ((), impl FnOnce((), Tangents<T>) -> (Tangents<T>, (), Tangent<T>) + use<T>) {
        self.insert(index, value);
        let len = self.len();
        ((), move |(), cotangent| {
            let mut before = fitted(cotangent, len);
            let inserted = before.remove(index);
            (before, (), inserted)
        })
    }

    #[inline]
    #[track_caller]
    fn insert_jvp(
        &mut self,
        index: usize,
        value: T,
        tangent: &mut Tangents<T>,
        _: (),
        value_tangent: Tangent<T>,
    ) -> ((), ()) {
        self.insert(index, value);
        tangent.insert(index, value_tangent);
        ((), ())
    }

    #[inline]
    #[track_caller]
    fn remove_vjp(
        &mut self,
        index: usize,
    ) -> (T, impl FnOnce(Tangent<T>, Tangents<T>) -> (Tangents<T>, ()) + use<T>) {
        let removed = self.remove(index);
        let len = self.len();
        (removed, move |removed, cotangent| {
            let mut before = fitted(cotangent, len);
            before.insert(index, removed);
            (before, ())
        })
    }

    #[inline]
    #[track_caller]
    fn remove_jvp(&mut self, index: usize, tangent: &mut Tangents<T>, _: ()) -> (T, Tangent<T>) {
        (self.remove(index), tangent.remove(index))
    }

    #[inline]
    #[track_caller]
    fn swap_remove_vjp(
        &mut self,
        index: usize,
    ) -> (T, impl FnOnce(Tangent<T>, Tangents<T>) -> (Tangents<T>, ()) + use<T>) {
        let removed = self.swap_remove(index);
        let len = self.len();
        (removed, move |removed, cotangent| {
            let mut before = fitted(cotangent, len);
            before.push(removed);
            before.swap(index, len);
            (before, ())
        })
    }

    #[inline]
    #[track_caller]
    fn swap_remove_jvp(
        &mut self,
        index: usize,
        tangent: &mut Tangents<T>,
        _: (),
    ) -> (T, Tangent<T>) {
        (self.swap_remove(index), tangent.swap_remove(index))
    }

    #[inline]
    fn truncate_vjp(
        &mut self,
        len: usize,
    ) -> ((), impl FnOnce((), Tangents<T>) -> (Tangents<T>, ()) + use<T>) {
        self.truncate(len);
        let len = self.len();
        ((), move |(), cotangent| (fitted(cotangent, len), ()))
    }

    #[inline]
    fn truncate_jvp(&mut self, len: usize, tangent: &mut Tangents<T>, _: ()) -> ((), ()) {
        self.truncate(len);
        tangent.truncate(len);
        ((), ())
    }

    #[inline]
    fn resize_vjp(
        &mut self,
        len: usize,
        value: T,
    ) -> ((), impl FnOnce((), Tangents<T>) -> (Tangents<T>, (), Tangent<T>) + use<T>)
    where
        T: Clone,
    {
        let kept = self.len().min(len);
        self.resize(len, value);
        ((), move |(), cotangent| {
            let mut before = fitted(cotangent, len);
            let mut to_value = Tangent::<T>::zero();
            before.drain(kept..).for_each(|copy| to_value.accumulate(copy));
            (before, (), to_value)
        })
    }

    #[inline]
    fn resize_jvp(
        &mut self,
        len: usize,
        value: T,
        tangent: &mut Tangents<T>,
        _: (),
        value_tangent: Tangent<T>,
    ) -> ((), ())
    where
        T: Clone,
    {
        self.resize(len, value);
        tangent.resize(len, value_tangent);
        ((), ())
    }

    #[inline]
    #[track_caller]
    fn split_off_vjp(
        &mut self,
        at: usize,
    ) -> (Vec<T>, impl FnOnce(Tangents<T>, Tangents<T>) -> (Tangents<T>, ()) + use<T>) {
        let rest = self.split_off(at);
        (rest, move |rest, cotangent| {
            let mut before = fitted(cotangent, at);
            before.extend(rest);
            (before, ())
        })
    }

    #[inline]
    #[track_caller]
    fn split_off_jvp(
        &mut self,
        at: usize,
        tangent: &mut Tangents<T>,
        _: (),
    ) -> (Vec<T>, Tangents<T>) {
        (self.split_off(at), tangent.split_off(at))
    }

    #[inline]
    fn append_vjp(
        &mut self,
        other: &mut Vec<T>,
    ) -> ((), impl FnOnce((), Tangents<T>, Tangents<T>) -> (Tangents<T>, Tangents<T>) + use<T>)
    {
        let kept = self.len();
        self.append(other);
        let len = self.len();
        ((), move |(), cotangent, _| {
            let mut before = fitted(cotangent, len);
            let appended = before.split_off(kept);
            (before, appended)
        })
    }

    #[inline]
    fn append_jvp(
        &mut self,
        other: &mut Vec<T>,
        tangent: &mut Tangents<T>,
        other_tangent: &mut Tangents<T>,
    ) -> ((), ()) {
        self.append(other);
        tangent.append(other_tangent);
        ((), ())
    }
}
