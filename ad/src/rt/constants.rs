//! What may be stored in what has no derivative: in a `#[constant]` field, in a constant that a call
//! may change.
//!
//! The tangent of such a field says nothing, so what has a derivative would lose it there. It is
//! refused; what has none, or comes from another such field, is not.

use std::collections::VecDeque;

use super::Space;
use super::cotangent::{Constant, Content, Length, Same};
use crate::{Additive, Boxed, NoDerivative, NoTangent};

/// Tangents that are always zero.
#[diagnostic::on_unimplemented(
    message = "what has a derivative would be stored in what is `#[constant]`, which cuts it without a word",
    label = "this has a derivative",
    note = "write `ad::stop_gradient(..)` around it if that is what you mean, or take `#[constant]` off the field, the parameter or the variable"
)]
pub trait Vanishing: Additive {}

impl Vanishing for () {}
impl<T: ?Sized> Vanishing for NoTangent<T> {}
impl<T: Vanishing> Vanishing for Vec<T> {}
impl<T: Vanishing> Vanishing for VecDeque<T> {}
impl<T: Vanishing> Vanishing for Boxed<T> {}
impl<T: Vanishing, const N: usize> Vanishing for [T; N] where [T; N]: Additive {}
impl<A: Vanishing, B: Vanishing> Vanishing for (A, B) {}
impl<A: Vanishing, B: Vanishing, C: Vanishing> Vanishing for (A, B, C) {}

/// The cotangent of a constant that a call was given to be changed.
#[inline(always)]
pub fn of_constant<T: Vanishing>() -> T {
    T::zero()
}

impl<T: ?Sized> NoTangent<T> {
    /// Says that something with these tangents is stored in the field.
    #[doc(hidden)]
    #[inline(always)]
    pub fn accepts_tangents<C: Vanishing>(&self, _: Space<C>) {}
}

/// Tangents of places in which anything may be stored. `NoTangent` has a method of its own.
pub trait Accepts {
    /// Says that something with these tangents is stored in the place.
    #[inline(always)]
    fn accepts_tangents<C>(&self, _: Space<C>) {}
}

impl<T: ?Sized> Accepts for T {}

/// The kinds of conversion by which a call may change a place whose tangents are given to it as `T`.
pub trait OfChanged<T> {}

impl<T> OfChanged<T> for Same {}
impl<T> OfChanged<T> for Length {}
impl<T> OfChanged<T> for Content {}
impl<T: Vanishing> OfChanged<T> for Constant {}

/// What has no derivative, given to a call beside what has one.
pub struct Beside<'a, T: ?Sized>(pub &'a T);

/// What a call cannot store a derivative in.
#[diagnostic::on_unimplemented(
    message = "the call is given a `&mut {Self}` that is taken for a constant, and could store there what has a derivative",
    label = "is a `&mut`, by which the call may change what it refers to",
    note = "write `&mut place` for it here, with the name of the variable that it refers to"
)]
pub trait KeepsNothing {}

#[diagnostic::do_not_recommend]
impl<T: NoDerivative + ?Sized> KeepsNothing for T {}

impl<T: ?Sized> Beside<'_, &mut T> {
    /// Says that the call can store nothing in it.
    #[inline(always)]
    pub fn keeps_nothing(&self)
    where
        T: KeepsNothing,
    {
    }
}

/// The fallback for types of which nothing is asked. A `&mut` has a method of its own.
pub trait MayKeep {
    /// Says that the call can store nothing in it.
    #[inline(always)]
    fn keeps_nothing(&self) {}
}

impl<T: ?Sized> MayKeep for Beside<'_, T> {}
