//! What loops over elements run over: the positions of elements.

use std::borrow::Cow;
use std::collections::VecDeque;
use std::rc::Rc;
use std::sync::Arc;

use core::iter::{Product, StepBy, Sum, empty};
use core::ops::Range;

use crate::rules::Arithmetic;
use crate::{Additive, Real};

/// The starts of the windows of `size` elements, as `slice::windows` has them.
///
/// Panics where `size` is 0.
#[inline(always)]
pub fn windows(len: usize, size: usize) -> Range<usize> {
    assert!(size != 0, "window size must be non-zero");
    0..(len + 1).saturating_sub(size)
}

/// The starts of the whole chunks of `size` elements, as `slice::chunks_exact` has them.
///
/// Panics where `size` is 0.
#[inline(always)]
pub fn chunks_exact(len: usize, size: usize) -> StepBy<Range<usize>> {
    assert!(size != 0, "chunk size must be non-zero");
    (0..len - len % size).step_by(size)
}

/// An item of `left.chain(right)`.
#[derive(Clone, Copy)]
pub enum Side<L, R> {
    /// One of the first iterator.
    Left(L),
    /// One of the second.
    Right(R),
}

/// The number of the item that a search finds; where there is none one too large. What is searched are items with their
/// numbers.
pub mod position {
    use core::cmp::Ordering;
    use core::iter::Enumerate;

    fn of<T>(found: Option<(usize, T)>) -> usize {
        found.map_or(usize::MAX, |(position, _)| position)
    }

    /// Items with their numbers.
    #[inline]
    pub fn numbered<I: IntoIterator>(items: I) -> Enumerate<I::IntoIter> {
        items.into_iter().enumerate()
    }

    /// Those of which a test holds.
    #[inline]
    pub fn filtered<T>(
        items: impl Iterator<Item = (usize, T)>,
        mut is_kept: impl FnMut(&T) -> bool,
    ) -> impl Iterator<Item = (usize, T)> {
        items.filter(move |(_, item)| is_kept(item))
    }

    macro_rules! searches {
        ($($by:ident $by_key:ident)*) => {$(
            /// As the method of iterators.
            #[inline]
            pub fn $by<T>(
                items: impl Iterator<Item = (usize, T)>,
                mut compare: impl FnMut(&T, &T) -> Ordering,
            ) -> usize {
                of(items.$by(|a, b| compare(&a.1, &b.1)))
            }

            /// As the method of iterators.
            #[inline]
            pub fn $by_key<T, K: Ord>(
                items: impl Iterator<Item = (usize, T)>,
                mut key: impl FnMut(&T) -> K,
            ) -> usize {
                of(items.$by_key(|item| key(&item.1)))
            }
        )*};
    }

    searches!(max_by max_by_key min_by min_by_key);

    /// As the method of iterators.
    #[inline]
    pub fn find<T>(
        mut items: impl Iterator<Item = (usize, T)>,
        mut is_it: impl FnMut(&T) -> bool,
    ) -> usize {
        of(items.find(|item| is_it(&item.1)))
    }
}

/// A position, which goes on to the next.
#[inline(always)]
pub fn advance(position: &mut usize) -> usize {
    let at = *position;
    *position += 1;
    at
}

/// Compiles for sequences of the standard library.
#[inline(always)]
pub fn is_sequence<S: Sequence + ?Sized>(_: &S) {}

/// Numbers, of which those that are equal are the same.
#[diagnostic::on_unimplemented(
    message = "where elements are equal, their order after `sort_unstable_by` is not specified, and may be another one in the derivative",
    label = "a `{Self}` may be equal to another one",
    note = "write `sort_by`, which keeps the order of equal elements"
)]
pub trait ToldApart {}

#[diagnostic::do_not_recommend]
impl<S: Real> ToldApart for S {}

/// Compiles for lists whose order comparisons of the elements tell.
#[inline(always)]
pub fn are_told_apart<T: ToldApart>(_: &[T]) {}

/// An option of a `&mut`. The cotangent of its content is that of the option, which is not so for a
/// result.
#[diagnostic::on_unimplemented(
    message = "`as_mut().unwrap()` has a derivative where it is called on an option",
    label = "this is none",
    note = "of a result write `if let Ok(x) = &mut result {{ .. }}`"
)]
pub trait LendsContent {}

impl<T> LendsContent for Option<&mut T> {}

/// What an option lends, which is checked to be one.
#[inline(always)]
pub fn lent_content<L: LendsContent>(lent: L) -> L {
    lent
}

/// What lends parts of an element at the same time.
#[diagnostic::on_unimplemented(
    message = "two parts of one element of a `{Self}` are lent here at the same time",
    label = "an element of a slice or an array can lend both",
    note = "do it in a function that takes the element as `&mut`, or the elements as `&mut [T]`"
)]
pub trait LendsParts {}

impl<T> LendsParts for [T] {}
impl<T, const N: usize> LendsParts for [T; N] {}
impl<S: LendsParts + ?Sized> LendsParts for &mut S {}
impl<S: LendsParts + ?Sized> LendsParts for Box<S> {}

/// Compiles for what lends parts of an element at the same time.
#[inline(always)]
pub fn lends_parts<S: LendsParts + ?Sized>(_: &S) {}

/// A sequence of the standard library, whose elements stand in order and whose methods are known.
#[diagnostic::on_unimplemented(
    message = "what is run over here, or what the method of this name does, is known for slices, arrays and `Vec`s only",
    label = "this is a `{Self}`",
    note = "run over a list in it, `value.items.iter()`, over what a differentiable method collects into a `Vec`, or over positions",
    note = "if no derivative is to flow from it: over `let items = ad::no_diff(|| value.iter().copied().collect::<Vec<_>>());`",
    note = "call a method of your own by its path, `Type::method(&value, ..)`; of options, write `.filter_map(|option| *option)` in place of `.flatten()`"
)]
pub trait Sequence {}

impl<T> Sequence for [T] {}
impl<T> Sequence for Vec<T> {}
impl<T> Sequence for VecDeque<T> {}
impl<T, const N: usize> Sequence for [T; N] {}
impl<S: Sequence + ?Sized> Sequence for &S {}
impl<S: Sequence + ?Sized> Sequence for &mut S {}
impl<S: Sequence + ?Sized> Sequence for Box<S> {}
impl<S: Sequence + ?Sized> Sequence for Rc<S> {}
impl<S: Sequence + ?Sized> Sequence for Arc<S> {}
impl<T: Clone> Sequence for Cow<'_, [T]> {}

/// What has no derivative and is flattened: a list, or an option, which is one of one element at most.
#[diagnostic::on_unimplemented(
    message = "what is flattened has to be a list or an option",
    label = "the items are of the type `{Self}`",
    note = "write two loops, one in the other"
)]
pub trait Flat {
    /// What its elements are told from by their positions.
    type List: Sequence + ?Sized;

    /// The elements.
    fn list(&self) -> &Self::List;
}

impl<T> Flat for Option<T> {
    type List = [T];

    fn list(&self) -> &[T] {
        self.as_slice()
    }
}

impl<S: Sequence + ?Sized> Flat for S {
    type List = S;

    fn list(&self) -> &S {
        self
    }
}

/// A type whose sums are folds with `+`.
#[diagnostic::on_unimplemented(
    message = "how values of `{Self}` are summed up is not known",
    label = "the sum of these",
    note = "put `#[differentiable]` on `impl Sum for {Self}`"
)]
pub trait AddsUp {}

impl<T: Arithmetic> AddsUp for T {}

/// A type whose products are folds with `*`.
#[diagnostic::on_unimplemented(
    message = "how values of `{Self}` are multiplied is not known",
    label = "the product of these",
    note = "put `#[differentiable]` on `impl Product for {Self}`"
)]
pub trait MultipliesUp {}

impl<T: Arithmetic> MultipliesUp for T {}

/// The sum of nothing, bit for bit that of the standard library.
#[inline(always)]
pub fn empty_sum<T: Sum + AddsUp>() -> T {
    empty().sum()
}

/// Tells the compiler that a sum or a product, of which nothing else tells the type, is of that of its items.
#[inline(always)]
pub fn is_of_items<T>(_total: &T, _item: &T) {}

/// The product of nothing.
#[inline(always)]
pub fn empty_product<T: Product + MultipliesUp>() -> T {
    empty().product()
}

/// What was saved for each element of a `Vec`, with the cotangent of the element: zero where that
/// of the `Vec` is shorter.
#[inline]
pub fn with_cotangents<R, T: Additive>(
    records: Vec<R>,
    mut cotangents: Vec<T>,
) -> impl DoubleEndedIterator<Item = (R, T)> {
    cotangents.resize_with(records.len(), T::zero);
    records.into_iter().zip(cotangents)
}

/// The best item so far, of the type of `_candidate`.
#[inline(always)]
pub fn held<'b, T>(best: &'b Option<T>, _candidate: &T) -> Option<&'b T> {
    best.as_ref()
}

/// An array of what `f` returns for each index, and what it saved.
#[inline(always)]
pub fn record<T, R, const N: usize>(mut f: impl FnMut(usize) -> (T, R)) -> ([T; N], [R; N]) {
    let mut records = [const { None }; N];
    let values = core::array::from_fn(|index| {
        let (value, record) = f(index);
        records[index] = Some(record);
        value
    });
    (values, records.map(|record| record.expect("every element was made")))
}

/// As [`record`], with as many elements as `_source` has.
#[inline(always)]
pub fn record_like<S, T, R, const N: usize>(
    _source: &[S; N],
    f: impl FnMut(usize) -> (T, R),
) -> ([T; N], [R; N]) {
    record(f)
}

/// An array of what `f` returns for each index, with as many elements as `_source` has.
#[inline(always)]
pub fn build_like<S, T, const N: usize>(_source: &[S; N], f: impl FnMut(usize) -> T) -> [T; N] {
    core::array::from_fn(f)
}
