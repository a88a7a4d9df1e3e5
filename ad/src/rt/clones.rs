//! Whether a clone equals what it is a clone of.
//!
//! The derivative of `clone` is that of a copy, and what a pullback needs is kept by `Clone`. A `Clone` of
//! the user's may give another value. Debug builds compare the printed forms where the function itself
//! calls `clone`; of types that cannot be printed nothing is known, and bitwise copies are no question.

use core::fmt::Debug;

use super::Look;

/// What is copied bit by bit.
pub trait Copied {
    /// Asks nothing.
    #[inline(always)]
    fn same_as<O: ?Sized>(&self, _original: &O) {}
}

impl<T: Copy> Copied for &&&Look<'_, T> {}

/// A `Vec` of such, which would take long to print.
pub trait CopiedElements {
    /// Asks nothing.
    #[inline(always)]
    fn same_as<O: ?Sized>(&self, _original: &O) {}
}

impl<T: Copy> CopiedElements for &&Look<'_, Vec<T>> {}

/// What can be printed.
pub trait Comparable {
    /// Makes sure that the clone looks like its original.
    fn same_as<O: Debug + ?Sized>(&self, original: &O);
}

impl<T: Debug + ?Sized> Comparable for &Look<'_, T> {
    #[track_caller]
    fn same_as<O: Debug + ?Sized>(&self, original: &O) {
        assert!(
            format!("{:?}", self.0) == format!("{original:?}"),
            "a clone differs from its original, so that its derivative is not that of a copy: \
             give the operation another name than `clone`, and a derivative",
        );
    }
}

/// The fallback for types that cannot be compared.
pub trait NotComparable {
    /// Asks nothing.
    #[inline(always)]
    fn same_as<O: ?Sized>(&self, _original: &O) {}
}

impl<T: ?Sized> NotComparable for Look<'_, T> {}

/// In debug builds makes sure that `$copy` equals `$original`.
#[doc(hidden)]
#[macro_export]
macro_rules! check_clone {
    ($original:expr, $copy:expr) => {
        #[cfg(debug_assertions)]
        {
            #[allow(unused_imports)]
            use $crate::rt::{
                Comparable as _, Copied as _, CopiedElements as _, NotComparable as _,
            };
            (&&&$crate::rt::Look(&$copy)).same_as(&$original);
        }
    };
}
