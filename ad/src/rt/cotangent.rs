//! How cotangents are added up, taken apart and handed over.
//!
//! The reverse sweep knows no types. What it does to a cotangent goes through these traits, whose
//! parameter `Kind` keeps their implementations apart; it is inferred.

use core::ops::{Index, Range, RangeInclusive};

use std::collections::VecDeque;

use super::OfChanged;
use crate::{Additive, Boxed, NoTangent};

/// Both sides of a conversion are of one kind.
pub enum Same {}

/// One side is the tangent of a `#[constant]` field.
pub enum Constant {}

/// One side is the tangent of a slice, the other that of an array.
pub enum Length {}

/// One side is the tangent of a box, the other that of its content.
pub enum Content {}

/// Adds a contribution to a cotangent. What flows to a `#[constant]` field is dropped.
pub trait Absorb<C, Kind> {
    /// `self += contribution`
    fn absorb(&mut self, contribution: C);
}

impl<T: Additive> Absorb<T, Same> for T {
    #[inline(always)]
    fn absorb(&mut self, contribution: T) {
        self.accumulate(contribution);
    }
}

impl<T: ?Sized, C: Additive> Absorb<C, Constant> for NoTangent<T> {
    #[inline(always)]
    fn absorb(&mut self, _: C) {}
}

impl<T: Additive> Absorb<Vec<T>, Length> for [T] {
    #[inline]
    fn absorb(&mut self, contribution: Vec<T>) {
        for (mine, theirs) in self.iter_mut().zip(contribution) {
            mine.accumulate(theirs);
        }
    }
}

impl<T: Additive, const N: usize> Absorb<[T; N], Length> for [T] {
    #[inline]
    fn absorb(&mut self, contribution: [T; N]) {
        for (mine, theirs) in self.iter_mut().zip(contribution) {
            mine.accumulate(theirs);
        }
    }
}

impl<T: Additive, const N: usize> Absorb<Vec<T>, Length> for [T; N] {
    #[inline]
    fn absorb(&mut self, contribution: Vec<T>) {
        self.as_mut_slice().absorb(contribution);
    }
}

impl<T: Additive> Absorb<T, Content> for Boxed<T> {
    #[inline]
    fn absorb(&mut self, contribution: T) {
        self.accumulate(Boxed::new(contribution));
    }
}

impl<T: Additive> Absorb<Boxed<T>, Content> for T {
    #[inline]
    fn absorb(&mut self, contribution: Boxed<T>) {
        self.accumulate(contribution.into_inner());
    }
}

/// The cotangent that a value has which went into a field or an argument. Nothing comes out of a
/// `#[constant]` field; an array may have been passed as a slice.
pub trait Enter<T, Kind> {
    /// The conversion.
    fn enter(self) -> T;
}

impl<T: Additive> Enter<T, Same> for T {
    #[inline(always)]
    fn enter(self) -> T {
        self
    }
}

impl<T: ?Sized, C: Additive> Enter<C, Constant> for NoTangent<T> {
    #[inline(always)]
    fn enter(self) -> C {
        C::zero()
    }
}

impl<T: Additive, const N: usize> Enter<[T; N], Length> for Vec<T> {
    #[inline]
    fn enter(self) -> [T; N] {
        let mut elements = self.into_iter();
        core::array::from_fn(|_| elements.next().unwrap_or_else(T::zero))
    }
}

impl<T: Additive> Enter<T, Content> for Boxed<T> {
    #[inline]
    fn enter(self) -> T {
        self.into_inner()
    }
}

impl<T: Additive> Enter<Boxed<T>, Content> for T {
    #[inline]
    fn enter(self) -> Boxed<T> {
        Boxed::new(self)
    }
}

/// Moves a cotangent out and leaves a zero.
pub trait Take<T, Kind> {
    /// The cotangent so far.
    fn take(&mut self) -> T;
}

impl<T: Additive> Take<T, Same> for T {
    #[inline(always)]
    fn take(&mut self) -> T {
        core::mem::replace(self, T::zero())
    }
}

impl<T: ?Sized, C: Additive> Take<C, Constant> for NoTangent<T> {
    #[inline(always)]
    fn take(&mut self) -> C {
        C::zero()
    }
}

impl<T: Additive> Take<Vec<T>, Length> for [T] {
    #[inline]
    fn take(&mut self) -> Vec<T> {
        self.iter_mut().map(|element| core::mem::replace(element, T::zero())).collect()
    }
}

impl<T: Additive, const N: usize> Take<Vec<T>, Length> for [T; N] {
    #[inline]
    fn take(&mut self) -> Vec<T> {
        self.as_mut_slice().take()
    }
}

impl<T: Additive> Take<T, Content> for Boxed<T> {
    #[inline]
    fn take(&mut self) -> T {
        core::mem::replace(self, Boxed::zero()).into_inner()
    }
}

/// The cotangent of a place that a call has changed: a place that cuts derivatives may not be.
#[inline(always)]
pub fn take_changed<P, T, Kind>(place: &mut P) -> T
where
    P: Take<T, Kind> + ?Sized,
    Kind: OfChanged<T>,
{
    place.take()
}

/// Stands for the cotangent of a parameter that callers do not lend.
pub struct NotLent;

/// Lends nothing.
pub enum Nothing {}

impl<T: ?Sized> Take<NotLent, Nothing> for T {
    #[inline(always)]
    fn take(&mut self) -> NotLent {
        NotLent
    }
}

/// What a caller lends of which there is no cotangent yet.
pub trait Lent {
    /// A zero.
    fn nothing() -> Self;
}

impl Lent for NotLent {
    #[inline(always)]
    fn nothing() -> Self {
        Self
    }
}

impl<T: Additive> Lent for T {
    #[inline(always)]
    fn nothing() -> Self {
        T::zero()
    }
}

/// The cotangent of a variable before it was overwritten: moves out what has gathered.
#[inline(always)]
pub fn take<T: Additive>(cotangent: &mut T) -> T {
    core::mem::replace(cotangent, T::zero())
}

/// The cotangent of `x` in `[x; N]` and `vec![x; n]`.
#[inline(always)]
pub fn sum<T: Additive>(cotangents: impl IntoIterator<Item = T>) -> T {
    let mut total = T::zero();
    for cotangent in cotangents {
        total.accumulate(cotangent);
    }
    total
}

/// The cotangent of an element or of a range of elements, to be changed in place.
#[diagnostic::on_unimplemented(
    message = "there is no derivative by what `[..]` of this type gives",
    label = "indexed here",
    note = "slices, arrays, `Vec`s and vectors are indexed by `usize` and ranges",
    note = "of your own type put `#[differentiable]` on `impl Index`, too, call a method under it, or index a field"
)]
pub trait At<I> {
    /// The cotangent of the part.
    type Part: ?Sized;

    /// The part. A `Vec` that lacks it grows.
    fn at(&mut self, index: I) -> &mut Self::Part;
}

/// The part of `cotangent` at `index`.
#[inline(always)]
pub fn at<C: At<I> + ?Sized, I>(cotangent: &mut C, index: I) -> &mut C::Part {
    cotangent.at(index)
}

/// Adds the zeros that a cotangent lacks.
#[cold]
fn grow<T: Additive>(cotangent: &mut Vec<T>, len: usize) {
    cotangent.resize_with(len, T::zero);
}

impl<T: Additive> At<usize> for Vec<T> {
    type Part = T;

    #[inline(always)]
    fn at(&mut self, index: usize) -> &mut T {
        if index >= self.len() {
            grow(self, index + 1);
        }
        &mut self[index]
    }
}

impl<T: Additive> At<usize> for VecDeque<T> {
    type Part = T;

    #[inline(always)]
    fn at(&mut self, index: usize) -> &mut T {
        if index >= self.len() {
            self.resize_with(index + 1, T::zero);
        }
        &mut self[index]
    }
}

impl<T: Additive> At<Range<usize>> for Vec<T> {
    type Part = [T];

    #[inline]
    fn at(&mut self, range: Range<usize>) -> &mut [T] {
        if range.end > self.len() {
            grow(self, range.end);
        }
        &mut self[range]
    }
}

impl<T: Additive> At<RangeInclusive<usize>> for Vec<T> {
    type Part = [T];

    #[inline]
    fn at(&mut self, range: RangeInclusive<usize>) -> &mut [T] {
        self.at(*range.start()..range.end() + 1)
    }
}

impl<I, T: At<I> + Additive> At<I> for Boxed<T> {
    type Part = T::Part;

    #[inline]
    fn at(&mut self, index: I) -> &mut T::Part {
        (**self).at(index)
    }
}

macro_rules! at_by_index {
    ($([$($generics:tt)*] $type:ty, $index:ty, $part:ty;)*) => {$(
        impl<$($generics)*> At<$index> for $type {
            type Part = $part;

            #[inline(always)]
            fn at(&mut self, index: $index) -> &mut $part {
                &mut self[index]
            }
        }
    )*};
}

#[cfg(feature = "glam")]
pub(crate) use at_by_index;

at_by_index! {
    [T] [T], usize, T;
    [T] [T], Range<usize>, [T];
    [T] [T], RangeInclusive<usize>, [T];
    [T, const N: usize] [T; N], usize, T;
    [T, const N: usize] [T; N], Range<usize>, [T];
    [T, const N: usize] [T; N], RangeInclusive<usize>, [T];
}

macro_rules! at_constant {
    ($($index:ty)*) => {$(
        /// What flows to a part of a `#[constant]` field is dropped too.
        impl<T: Index<$index> + ?Sized> At<$index> for NoTangent<T> {
            type Part = NoTangent<T::Output>;

            #[inline(always)]
            fn at(&mut self, _: $index) -> &mut NoTangent<T::Output> {
                NoTangent::anywhere()
            }
        }
    )*};
}

at_constant!(usize Range<usize> RangeInclusive<usize>);
