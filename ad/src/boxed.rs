//! The tangent of a box.

use core::fmt::{self, Debug};
use core::ops::{Deref, DerefMut};
use std::sync::OnceLock;

use crate::Additive;

/// The tangent of a `Box`, whose content is made when something flows to it: the zero of a type
/// that holds itself in boxes would have no end.
pub struct Boxed<T>(OnceLock<Box<T>>);

impl<T> Boxed<T> {
    /// A tangent in a box.
    pub fn new(tangent: T) -> Self {
        Self(OnceLock::from(Box::new(tangent)))
    }
}

impl<T: Additive> Boxed<T> {
    /// The tangent.
    pub fn into_inner(self) -> T {
        self.0.into_inner().map_or_else(T::zero, |tangent| *tangent)
    }
}

impl<T> From<T> for Boxed<T> {
    fn from(tangent: T) -> Self {
        Self::new(tangent)
    }
}

impl<T: Additive> Deref for Boxed<T> {
    type Target = T;

    fn deref(&self) -> &T {
        self.0.get_or_init(|| Box::new(T::zero()))
    }
}

impl<T: Additive> DerefMut for Boxed<T> {
    fn deref_mut(&mut self) -> &mut T {
        self.0.get_or_init(|| Box::new(T::zero()));
        self.0.get_mut().expect("made above")
    }
}

impl<T: Additive + AsMut<[E]>, E> AsMut<[E]> for Boxed<T> {
    fn as_mut(&mut self) -> &mut [E] {
        (**self).as_mut()
    }
}

impl<T: Clone> Clone for Boxed<T> {
    fn clone(&self) -> Self {
        Self(self.0.clone())
    }
}

impl<T: Debug> Debug for Boxed<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0.get() {
            Some(tangent) => tangent.fmt(f),
            None => f.write_str("0"),
        }
    }
}

impl<T: Additive> Additive for Boxed<T> {
    #[inline]
    fn zero() -> Self {
        Self(OnceLock::new())
    }

    fn accumulate(&mut self, other: Self) {
        match (self.0.get_mut(), other.0.into_inner()) {
            (Some(mine), Some(theirs)) => mine.accumulate(*theirs),
            (None, Some(theirs)) => self.0 = OnceLock::from(theirs),
            (_, None) => {}
        }
    }
}
