//! How forward mode hands tangents on.
//!
//! Generated code knows no types: not whether a method takes its receiver by value, not whether a
//! field is `#[constant]`. What the callee's signature or the variable's type says decides here,
//! through the parameter `Kind` of these traits, which is inferred.

use super::cotangent::{Constant, Content, Length, Same};
use crate::{Additive, Boxed, Differentiable, NoTangent, Tangent};

/// The zero tangent of a value, of its size.
#[inline(always)]
pub fn zero_like<T: Differentiable + ?Sized>(value: &T) -> Tangent<T> {
    value.zero_tangent()
}

/// A zero of the tangents of a value, whose parts are all to be replaced.
#[inline(always)]
pub fn zero_of<T: Differentiable + ?Sized>(_value: &T) -> Tangent<T> {
    Additive::zero()
}

/// A constant with its tangent.
#[inline(always)]
pub fn with_zero<T: Differentiable>(value: T) -> (T, Tangent<T>) {
    let zero = zero_like(&value);
    (value, zero)
}

/// A tangent, of which `_value` tells the type.
#[inline(always)]
pub fn tangent_of<T: Differentiable>(_value: &T, tangent: Tangent<T>) -> Tangent<T> {
    tangent
}

/// A copy of a tangent.
#[inline(always)]
pub fn copy<T: Clone>(tangent: &T) -> T {
    tangent.clone()
}

/// The tangent of an array of equal elements.
#[inline(always)]
pub fn repeated<V, T: Clone, const N: usize>(_value: &[V; N], tangent: T) -> [T; N] {
    core::array::from_fn(|_| tangent.clone())
}

/// Makes sure that a tangent has as many elements as what it is the tangent of.
#[inline(always)]
#[track_caller]
pub fn same_length(value: usize, tangent: usize) {
    assert_eq!(value, tangent, "a tangent has as many elements as what it is the tangent of");
}

/// Copied from behind a reference.
pub enum Copied {}

/// Lent as `&`.
pub enum Lent {}

/// Lent as `&mut`.
pub enum LentExclusively {}

/// Made from a `#[constant]` field, by `Kind`.
pub struct FromConstant<Kind>(Kind);

/// A tangent, as the function it is passed to takes it, or the place that it is assigned to.
#[diagnostic::on_unimplemented(
    message = "forward mode cannot pass a tangent on here: `{Self}` is not what is expected",
    note = "to leave forward mode out, write `#[differentiable(reverse)]`"
)]
pub trait Pass<T, Kind>: Sized {
    /// The conversion.
    fn pass(self) -> T;
}

/// The tangent in the form that is wanted.
#[inline(always)]
pub fn pass<S: Pass<T, Kind>, T, Kind>(tangent: S) -> T {
    tangent.pass()
}

impl<T: Additive> Pass<T, Same> for T {
    #[inline(always)]
    fn pass(self) -> T {
        self
    }
}

impl<T: Additive, U: ?Sized> Pass<NoTangent<U>, Constant> for T {
    #[inline(always)]
    fn pass(self) -> NoTangent<U> {
        NoTangent::new()
    }
}

impl<T: Additive> Pass<T, Content> for Boxed<T> {
    #[inline(always)]
    fn pass(self) -> T {
        self.into_inner()
    }
}

impl<T: Additive> Pass<Boxed<T>, Content> for T {
    #[inline(always)]
    fn pass(self) -> Boxed<T> {
        Boxed::new(self)
    }
}

impl<T: Additive, const N: usize> Pass<Vec<T>, Length> for [T; N] {
    #[inline(always)]
    fn pass(self) -> Vec<T> {
        self.into()
    }
}

macro_rules! from_references {
    ($(($($reference:tt)*))*) => {$(
        impl<T: Additive> Pass<T, Copied> for $($reference)* T {
            #[inline(always)]
            fn pass(self) -> T {
                self.clone()
            }
        }

        impl<T: Additive> Pass<T, (Copied, Content)> for $($reference)* Boxed<T> {
            #[inline(always)]
            fn pass(self) -> T {
                (**self).clone()
            }
        }

        impl<T: Additive> Pass<Boxed<T>, (Copied, Content)> for $($reference)* T {
            #[inline(always)]
            fn pass(self) -> Boxed<T> {
                Boxed::new(self.clone())
            }
        }

        impl<T: Additive> Pass<Vec<T>, (Copied, Length)> for $($reference)* [T] {
            #[inline(always)]
            fn pass(self) -> Vec<T> {
                self.to_vec()
            }
        }

        impl<T: Additive, const N: usize> Pass<[T; N], (Copied, Length)> for $($reference)* [T] {
            #[inline(always)]
            fn pass(self) -> [T; N] {
                core::array::from_fn(|index| self[index].clone())
            }
        }

        impl<T: Additive, const N: usize> Pass<Vec<T>, (Copied, Length)> for $($reference)* [T; N] {
            #[inline(always)]
            fn pass(self) -> Vec<T> {
                self.to_vec()
            }
        }
    )*};
}

from_references!((&)(&mut));

/// What nothing uses but the function that it is passed to, which may take it.
pub struct Last<'a, T: ?Sized>(pub &'a mut T);

impl<T: Additive> Pass<T, Copied> for Last<'_, T> {
    #[inline(always)]
    fn pass(self) -> T {
        core::mem::replace(self.0, T::zero())
    }
}

impl<T: Additive> Pass<T, (Copied, Content)> for Last<'_, Boxed<T>> {
    #[inline(always)]
    fn pass(self) -> T {
        core::mem::replace(self.0, Boxed::zero()).into_inner()
    }
}

impl<T: Additive> Pass<Boxed<T>, (Copied, Content)> for Last<'_, T> {
    #[inline(always)]
    fn pass(self) -> Boxed<T> {
        Boxed::new(core::mem::replace(self.0, T::zero()))
    }
}

impl<T: Additive, const N: usize> Pass<Vec<T>, (Copied, Length)> for Last<'_, [T; N]> {
    #[inline(always)]
    fn pass(self) -> Vec<T> {
        self.0.to_vec()
    }
}

macro_rules! lent {
    ($([$($generics:tt)*] $from:ty => $to:ty, $shared:ty, $exclusive:ty;)*) => {$(
        impl<'a, $($generics)*> Pass<&'a $to, $shared> for &'a $from {
            #[inline(always)]
            fn pass(self) -> &'a $to {
                self
            }
        }

        impl<'a, $($generics)*> Pass<&'a $to, $shared> for &'a mut $from {
            #[inline(always)]
            fn pass(self) -> &'a $to {
                self
            }
        }

        impl<'a, $($generics)*> Pass<&'a mut $to, $exclusive> for &'a mut $from {
            #[inline(always)]
            fn pass(self) -> &'a mut $to {
                self
            }
        }

        impl<'a, $($generics)*> Pass<&'a $to, $shared> for Last<'a, $from> {
            #[inline(always)]
            fn pass(self) -> &'a $to {
                self.0
            }
        }

        impl<'a, $($generics)*> Pass<&'a mut $to, $exclusive> for Last<'a, $from> {
            #[inline(always)]
            fn pass(self) -> &'a mut $to {
                self.0
            }
        }
    )*};
}

lent! {
    [T: ?Sized] T => T, Lent, LentExclusively;
    [T] Vec<T> => [T], (Lent, Length), (LentExclusively, Length);
    [T, const N: usize] [T; N] => [T], (Lent, Length), (LentExclusively, Length);
    [T: Additive] Boxed<T> => T, (Lent, Content), (LentExclusively, Content);
    [T: Additive] Boxed<Vec<T>> => [T], (Lent, Content), (LentExclusively, Content);
}

/// The tangent that a reference refers to, for what owns its tangents.
#[inline(always)]
pub fn target<T: ToOwned + ?Sized>(tangent: &T) -> T::Owned {
    tangent.to_owned()
}

/// The tangent of a value that was read from a place, of whose tangent this is a reference.
#[diagnostic::on_unimplemented(
    message = "forward mode cannot pass a tangent on here: `{Self}` is not what is expected",
    note = "to leave forward mode out, write `#[differentiable(reverse)]`"
)]
pub trait Read<V: ?Sized, T, Kind> {
    /// The tangent of `value`.
    fn read(self, value: &V) -> T;
}

impl<V: ?Sized, T, S: Pass<T, Kind>, Kind> Read<V, T, (Kind,)> for S {
    #[inline(always)]
    fn read(self, _: &V) -> T {
        self.pass()
    }
}

impl<V, T, U> Read<V, T, Constant> for &NoTangent<U>
where
    V: Differentiable<Tangent = T> + ?Sized,
    T: Additive,
    U: ?Sized,
{
    #[inline(always)]
    fn read(self, value: &V) -> T {
        zero_like(value)
    }
}

impl<V, T, U> Read<V, T, Constant> for NoTangent<U>
where
    V: Differentiable<Tangent = T> + ?Sized,
    T: Additive,
    U: ?Sized,
{
    #[inline(always)]
    fn read(self, value: &V) -> T {
        zero_like(value)
    }
}

/// The tangent of `value`, from that of the place it was read from.
#[inline(always)]
pub fn read<V, S, Kind>(value: &V, tangent: S) -> Tangent<V>
where
    V: Differentiable + ?Sized,
    S: Read<V, Tangent<V>, Kind>,
{
    tangent.read(value)
}

/// Room for a zero tangent that is passed by reference.
pub struct Slot<T>(Option<T>);

impl<T> Slot<T> {
    /// Nothing yet.
    #[inline(always)]
    #[allow(clippy::new_without_default)]
    pub fn new() -> Self {
        Self(None)
    }

    #[inline(always)]
    fn fill(&mut self, tangent: T) -> &mut T {
        self.0.insert(tangent)
    }
}

/// A zero tangent of a value of type `V`, as the function it is passed to takes it.
#[diagnostic::on_unimplemented(
    message = "forward mode cannot pass a tangent on here: `{Self}` is not what is expected",
    note = "to leave forward mode out, write `#[differentiable(reverse)]`"
)]
pub trait Still<'s, V: ?Sized, S, Kind> {
    /// The zero.
    fn still(value: &V, slot: &'s mut Slot<S>) -> Self;
}

impl<'s, V: Differentiable<Tangent = T> + ?Sized, T: Additive> Still<'s, V, T, Same> for T {
    #[inline(always)]
    fn still(value: &V, _: &'s mut Slot<T>) -> T {
        zero_like(value)
    }
}

impl<'s, V: Differentiable<Tangent = Boxed<T>> + ?Sized, T: Additive> Still<'s, V, T, Content>
    for T
{
    #[inline(always)]
    fn still(value: &V, _: &'s mut Slot<T>) -> T {
        zero_like(value).into_inner()
    }
}

/// What is marked `#[constant]` takes no tangent.
impl<'s, V: ?Sized, U: ?Sized> Still<'s, V, (), Constant> for NoTangent<U> {
    #[inline(always)]
    fn still(_: &V, _: &'s mut Slot<()>) -> Self {
        Self::new()
    }
}

impl<'s, V: Differentiable<Tangent = T> + ?Sized, T> Still<'s, V, T, Lent> for &'s T {
    #[inline(always)]
    fn still(value: &V, slot: &'s mut Slot<T>) -> &'s T {
        slot.fill(zero_like(value))
    }
}

impl<'s, V: Differentiable<Tangent = T> + ?Sized, T> Still<'s, V, T, LentExclusively>
    for &'s mut T
{
    #[inline(always)]
    fn still(value: &V, slot: &'s mut Slot<T>) -> &'s mut T {
        slot.fill(zero_like(value))
    }
}

impl<'s, V: Differentiable<Tangent = Boxed<T>> + ?Sized, T: Additive>
    Still<'s, V, T, (Lent, Content)> for &'s T
{
    #[inline(always)]
    fn still(value: &V, slot: &'s mut Slot<T>) -> &'s T {
        slot.fill(zero_like(value).into_inner())
    }
}

impl<'s, V: Differentiable<Tangent = Boxed<T>> + ?Sized, T: Additive>
    Still<'s, V, T, (LentExclusively, Content)> for &'s mut T
{
    #[inline(always)]
    fn still(value: &V, slot: &'s mut Slot<T>) -> &'s mut T {
        slot.fill(zero_like(value).into_inner())
    }
}

impl<'s, V, T> Still<'s, V, Tangent<V>, (Lent, Length)> for &'s [T]
where
    V: Differentiable<Tangent: AsMut<[T]> + 's> + ?Sized,
{
    #[inline(always)]
    fn still(value: &V, slot: &'s mut Slot<Tangent<V>>) -> &'s [T] {
        slot.fill(zero_like(value)).as_mut()
    }
}

impl<'s, V, T> Still<'s, V, Tangent<V>, (LentExclusively, Length)> for &'s mut [T]
where
    V: Differentiable<Tangent: AsMut<[T]> + 's> + ?Sized,
{
    #[inline(always)]
    fn still(value: &V, slot: &'s mut Slot<Tangent<V>>) -> &'s mut [T] {
        slot.fill(zero_like(value)).as_mut()
    }
}

/// The zero tangent of `value` in the form that is wanted.
#[inline(always)]
pub fn still<'s, V, S, T, Kind>(value: &V, slot: &'s mut Slot<S>) -> T
where
    V: ?Sized,
    T: Still<'s, V, S, Kind>,
{
    T::still(value, slot)
}

/// The tangent of a part of a struct that is passed to a function: zero, where the part is a
/// `#[constant]` field.
#[diagnostic::on_unimplemented(
    message = "forward mode cannot pass a tangent on here: `{Self}` is not what is expected",
    note = "to leave forward mode out, write `#[differentiable(reverse)]`"
)]
pub trait PassPart<'s, V: Differentiable + ?Sized, T, Kind> {
    /// The conversion.
    fn pass_part(self, value: &V, slot: &'s mut Slot<Tangent<V>>) -> T;
}

impl<'s, V: Differentiable + ?Sized, T, S: Pass<T, Kind>, Kind> PassPart<'s, V, T, (Kind,)> for S {
    #[inline(always)]
    fn pass_part(self, _: &V, _: &'s mut Slot<Tangent<V>>) -> T {
        self.pass()
    }
}

macro_rules! from_constants {
    ($($reference:ty),*) => {$(
        impl<'s, V, T, U, Kind> PassPart<'s, V, T, FromConstant<Kind>> for $reference
        where
            V: Differentiable + ?Sized,
            T: Still<'s, V, Tangent<V>, Kind>,
            U: ?Sized,
        {
            #[inline(always)]
            fn pass_part(self, value: &V, slot: &'s mut Slot<Tangent<V>>) -> T {
                T::still(value, slot)
            }
        }
    )*};
}

from_constants!(&NoTangent<U>, &mut NoTangent<U>);

/// The tangent of a part of `value` in the form that is wanted.
#[inline(always)]
pub fn pass_part<'s, V, S, T, Kind>(value: &V, tangent: S, slot: &'s mut Slot<Tangent<V>>) -> T
where
    V: Differentiable + ?Sized,
    S: PassPart<'s, V, T, Kind>,
{
    tangent.pass_part(value, slot)
}

/// What a `#[constant]` field holds is indexed as it is itself.
impl<U: core::ops::Index<I> + ?Sized, I> core::ops::Index<I> for NoTangent<U> {
    type Output = NoTangent<U::Output>;

    #[inline(always)]
    fn index(&self, _: I) -> &NoTangent<U::Output> {
        NoTangent::anywhere()
    }
}

impl<U: core::ops::Index<I> + ?Sized, I> core::ops::IndexMut<I> for NoTangent<U> {
    #[inline(always)]
    fn index_mut(&mut self, _: I) -> &mut NoTangent<U::Output> {
        NoTangent::anywhere()
    }
}
