//! Methods that take the content out of an `Option` or a `Result`.

use core::fmt::Debug;

use crate::rules::{CopiedRules, FlattenRules, OptionRules, ResultRules};
use crate::{Additive, Differentiable, Tangent};

/// The `_jvp` siblings of the methods of options. The tangent of an option is that of its content.
pub trait OptionForward: OptionRules {
    /// Panics on `None`, as `unwrap` does.
    fn unwrap_jvp(self, tangent: Tangent<Self::Content>)
    -> (Self::Content, Tangent<Self::Content>);

    /// Panics on `None`, as `expect` does.
    fn expect_jvp(
        self,
        message: &str,
        tangent: Tangent<Self::Content>,
        _: &(),
    ) -> (Self::Content, Tangent<Self::Content>);

    /// The tangent of what is referred to.
    #[inline(always)]
    fn as_ref_jvp(
        &self,
        tangent: &Tangent<Self::Content>,
    ) -> (Option<&Self::Content>, Tangent<Self::Content>) {
        (self.as_ref_vjp().0, tangent.clone())
    }

    /// The tangent of what was there.
    #[inline(always)]
    fn take_jvp(&mut self, tangent: &mut Tangent<Self::Content>) -> (Self, Tangent<Self::Content>) {
        (self.take_vjp().0, core::mem::replace(tangent, Additive::zero()))
    }

    /// The tangent of what was there; that of the new value takes its place.
    #[inline(always)]
    fn replace_jvp(
        &mut self,
        value: Self::Content,
        tangent: &mut Tangent<Self::Content>,
        value_tangent: Tangent<Self::Content>,
    ) -> (Self, Tangent<Self::Content>) {
        (self.replace_vjp(value).0, core::mem::replace(tangent, value_tangent))
    }

    /// The tangent of the one that was taken.
    fn or_jvp(
        self,
        other: Self,
        tangent: Tangent<Self::Content>,
        other_tangent: Tangent<Self::Content>,
    ) -> (Self, Tangent<Self::Content>);

    /// The tangent of the one that was taken.
    fn xor_jvp(
        self,
        other: Self,
        tangent: Tangent<Self::Content>,
        other_tangent: Tangent<Self::Content>,
    ) -> (Self, Tangent<Self::Content>);

    /// The tangents of both.
    #[inline(always)]
    #[allow(clippy::type_complexity)]
    fn zip_jvp<U: Differentiable>(
        self,
        other: Option<U>,
        tangent: Tangent<Self::Content>,
        other_tangent: Tangent<U>,
    ) -> (Option<(Self::Content, U)>, (Tangent<Self::Content>, Tangent<U>)) {
        (self.zip_vjp(other).0, (tangent, other_tangent))
    }

    /// The tangent of what was taken.
    fn unwrap_or_jvp(
        self,
        default: Self::Content,
        tangent: Tangent<Self::Content>,
        default_tangent: Tangent<Self::Content>,
    ) -> (Self::Content, Tangent<Self::Content>);

    /// The tangent of what was taken, zero for the default.
    fn unwrap_or_default_jvp(
        self,
        tangent: Tangent<Self::Content>,
    ) -> (Self::Content, Tangent<Self::Content>)
    where
        Self::Content: Default;
}

impl<T: Differentiable> OptionForward for Option<T> {
    #[inline(always)]
    #[track_caller]
    fn unwrap_jvp(self, tangent: Tangent<T>) -> (T, Tangent<T>) {
        (self.unwrap(), tangent)
    }

    #[inline(always)]
    #[track_caller]
    fn expect_jvp(self, message: &str, tangent: Tangent<T>, _: &()) -> (T, Tangent<T>) {
        (self.expect(message), tangent)
    }

    #[inline(always)]
    fn or_jvp(
        self,
        other: Self,
        tangent: Tangent<T>,
        other_tangent: Tangent<T>,
    ) -> (Self, Tangent<T>) {
        match self.is_some() {
            true => (self, tangent),
            false => (other, other_tangent),
        }
    }

    #[inline(always)]
    fn xor_jvp(
        self,
        other: Self,
        tangent: Tangent<T>,
        other_tangent: Tangent<T>,
    ) -> (Self, Tangent<T>) {
        match (self.is_some(), other.is_some()) {
            (true, false) => (self, tangent),
            (false, true) => (other, other_tangent),
            _ => (None, Additive::zero()),
        }
    }

    #[inline(always)]
    fn unwrap_or_jvp(
        self,
        default: T,
        tangent: Tangent<T>,
        default_tangent: Tangent<T>,
    ) -> (T, Tangent<T>) {
        match self {
            Some(content) => (content, tangent),
            None => (default, default_tangent),
        }
    }

    #[inline(always)]
    fn unwrap_or_default_jvp(self, tangent: Tangent<T>) -> (T, Tangent<T>)
    where
        T: Default,
    {
        match self {
            Some(content) => (content, tangent),
            None => still(T::default()),
        }
    }
}

/// A value that does not move.
fn still<T: Differentiable>(value: T) -> (T, Tangent<T>) {
    let tangent = value.zero_tangent();
    (value, tangent)
}

/// The `_jvp` sibling of `flatten`.
pub trait FlattenForward: FlattenRules {
    /// The tangent of the content.
    #[inline(always)]
    fn flatten_jvp(self, tangent: Tangent<Self::Inner>) -> (Self::Inner, Tangent<Self::Inner>) {
        (self.flatten_vjp().0, tangent)
    }
}

impl<T: Differentiable> FlattenForward for Option<Option<T>> {}

/// The `_jvp` siblings of the methods of results.
pub trait ResultForward: ResultRules {
    /// Panics on `Err`, as `unwrap` does.
    fn unwrap_jvp(self, tangent: Tangent<Self>) -> (Self::Value, Tangent<Self::Value>)
    where
        Self::Error: Debug;

    /// Panics on `Err`, as `expect` does.
    fn expect_jvp(
        self,
        message: &str,
        tangent: Tangent<Self>,
        _: &(),
    ) -> (Self::Value, Tangent<Self::Value>)
    where
        Self::Error: Debug;

    /// The tangent of what was taken.
    fn unwrap_or_jvp(
        self,
        default: Self::Value,
        tangent: Tangent<Self>,
        default_tangent: Tangent<Self::Value>,
    ) -> (Self::Value, Tangent<Self::Value>);

    /// The tangent of what was taken, zero for the default.
    fn unwrap_or_default_jvp(self, tangent: Tangent<Self>) -> (Self::Value, Tangent<Self::Value>)
    where
        Self::Value: Default;
}

impl<T: Differentiable, E: Differentiable> ResultForward for Result<T, E> {
    #[inline(always)]
    #[track_caller]
    fn unwrap_jvp(self, tangent: Tangent<Self>) -> (T, Tangent<T>)
    where
        E: Debug,
    {
        (self.unwrap(), tangent.0)
    }

    #[inline(always)]
    #[track_caller]
    fn expect_jvp(self, message: &str, tangent: Tangent<Self>, _: &()) -> (T, Tangent<T>)
    where
        E: Debug,
    {
        (self.expect(message), tangent.0)
    }

    #[inline(always)]
    fn unwrap_or_jvp(
        self,
        default: T,
        tangent: Tangent<Self>,
        default_tangent: Tangent<T>,
    ) -> (T, Tangent<T>) {
        match self {
            Ok(content) => (content, tangent.0),
            Err(_) => (default, default_tangent),
        }
    }

    #[inline(always)]
    fn unwrap_or_default_jvp(self, tangent: Tangent<Self>) -> (T, Tangent<T>)
    where
        T: Default,
    {
        match self {
            Ok(content) => (content, tangent.0),
            Err(_) => still(T::default()),
        }
    }
}

/// The `_jvp` siblings of the methods of options of references.
pub trait CopiedForward: CopiedRules {
    /// The tangent of what is referred to.
    fn copied_jvp(
        self,
        tangent: Tangent<Self::Target>,
    ) -> (Option<Self::Target>, Tangent<Self::Target>)
    where
        Self::Target: Copy;

    /// The tangent of what is referred to.
    fn cloned_jvp(
        self,
        tangent: Tangent<Self::Target>,
    ) -> (Option<Self::Target>, Tangent<Self::Target>)
    where
        Self::Target: Clone;
}

impl<T: Differentiable> CopiedForward for Option<&T> {
    #[inline(always)]
    fn copied_jvp(self, tangent: Tangent<T>) -> (Option<T>, Tangent<T>)
    where
        T: Copy,
    {
        (self.copied(), tangent)
    }

    #[inline(always)]
    fn cloned_jvp(self, tangent: Tangent<T>) -> (Option<T>, Tangent<T>)
    where
        T: Clone,
    {
        (self.cloned(), tangent)
    }
}
