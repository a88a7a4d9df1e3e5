//! Cells to which code without derivative would give a number that has one.

use core::cell::{Cell, OnceCell, RefCell};
use std::rc::Rc;
use std::sync::mpsc::{Sender, SyncSender};
use std::sync::{Arc, Mutex, OnceLock, RwLock};
use std::thread::LocalKey;

use crate::NoDerivative;

/// What is given a number where none of its derivative is seen.
pub struct Holder<'a, T: ?Sized>(pub &'a T);

/// What does not keep a number for others to read.
#[diagnostic::on_unimplemented(
    message = "a `{Self}` is given here what has a derivative, which would be lost",
    label = "keeps what it is given",
    note = "return the number instead, or write `ad::stop_gradient(..)` around it if that is what you mean"
)]
pub trait HoldsNoNumber {}

/// The fallback for types of which nothing is known. Those that keep what they are given have a method of their own.
pub trait MayHold {
    /// Says that the type is given a number.
    #[inline(always)]
    fn holds_no_number(&self) {}
}

impl<T: ?Sized> MayHold for Holder<'_, T> {}

macro_rules! cells {
    ($($cell:ident)*) => {$(
        cells!(@each $cell: $cell<T>, &$cell<T>, Rc<$cell<T>>, &Rc<$cell<T>>, Arc<$cell<T>>,
            &Arc<$cell<T>>, LocalKey<$cell<T>>);
    )*};
    (@each $cell:ident: $($type:ty),*) => {
        #[diagnostic::do_not_recommend]
        impl<T: NoDerivative> HoldsNoNumber for $cell<T> {}
        $(impl<T> Holder<'_, $type> {
            /// Says that it keeps a number.
            #[inline(always)]
            pub fn holds_no_number(&self)
            where
                $cell<T>: HoldsNoNumber,
            {
            }
        })*
    };
}

cells!(Cell RefCell OnceCell Mutex RwLock OnceLock Sender SyncSender);

/// What does not change while it is shared, so that a copy may stand for it.
#[diagnostic::on_unimplemented(
    message = "a `{Self}` is captured by a closure that is passed on, which gets a copy of it: what it does to that is lost",
    note = "pass it to the function as a parameter of its own, marked `#[constant]`, or write the function without the closure"
)]
pub trait StaysWhileShared {}

#[diagnostic::do_not_recommend]
impl<T: Sync + ?Sized> StaysWhileShared for T {}

/// Compiles where what a closure does to its copy of a value cannot be missed.
#[inline(always)]
pub fn shared_by_a_copy<T: StaysWhileShared + ?Sized>(_: &T) {}
