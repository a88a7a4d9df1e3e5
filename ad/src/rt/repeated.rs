//! Whether what is computed a second time is what it was the first time.
//!
//! A checkpointed loop or function runs twice. One that draws random numbers, or reads what somebody
//! else changes, computes something else then, and its gradient belongs to neither run. Debug builds
//! compare the states between the segments of a loop, and the values of a function, by their printed
//! forms; of types that cannot be printed nothing is known.

use core::fmt::Debug;
#[cfg(debug_assertions)]
use core::fmt::Write;
#[cfg(debug_assertions)]
use std::hash::{DefaultHasher, Hasher};

/// What a state looks like; in release builds nothing is looked at.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Fingerprint(Print);

#[cfg(debug_assertions)]
type Print = u64;
#[cfg(not(debug_assertions))]
type Print = ();

/// Makes a [`Fingerprint`] of several variables.
#[derive(Default)]
pub struct Fingerprints {
    #[cfg(debug_assertions)]
    hasher: DefaultHasher,
}

impl Fingerprints {
    /// The fingerprint of all variables that were looked at.
    #[inline(always)]
    pub fn finish(self) -> Fingerprint {
        #[cfg(debug_assertions)]
        let print = self.hasher.finish();
        #[cfg(not(debug_assertions))]
        let print = ();
        Fingerprint(print)
    }
}

#[cfg(debug_assertions)]
impl Write for Fingerprints {
    fn write_str(&mut self, text: &str) -> core::fmt::Result {
        self.hasher.write(text.as_bytes());
        Ok(())
    }
}

/// A variable to look at.
pub struct Look<'a, T: ?Sized>(pub &'a T);

/// Variables that can be printed.
pub trait Printed {
    /// Looks at the variable.
    fn look(&self, prints: &mut Fingerprints);
}

impl<T: Debug + ?Sized> Printed for &Look<'_, T> {
    #[cfg(debug_assertions)]
    fn look(&self, prints: &mut Fingerprints) {
        write!(prints, "{:?};", self.0).expect("hashing does not fail");
    }

    #[cfg(not(debug_assertions))]
    #[inline(always)]
    fn look(&self, _: &mut Fingerprints) {}
}

/// The fallback for types that cannot be printed.
pub trait NotPrinted {
    /// Sees nothing.
    #[inline(always)]
    fn look(&self, _: &mut Fingerprints) {}
}

impl<T: ?Sized> NotPrinted for Look<'_, T> {}

/// Makes sure that a checkpointed computation does the same in both runs.
#[inline(always)]
#[track_caller]
pub fn same_again(first: Fingerprint, second: Fingerprint) {
    assert!(
        first == second,
        "a checkpointed computation gives something else when it runs the second time: draw random \
         numbers before it, and pass them in"
    );
}

/// The [`Fingerprint`] of variables.
#[doc(hidden)]
#[macro_export]
macro_rules! fingerprint {
    ($($variable:expr),*) => {{
        #[allow(unused_imports)]
        use $crate::rt::{NotPrinted as _, Printed as _};
        #[allow(unused_mut)]
        let mut prints = $crate::rt::Fingerprints::default();
        $((&&$crate::rt::Look(&$variable)).look(&mut prints);)*
        prints.finish()
    }};
}
