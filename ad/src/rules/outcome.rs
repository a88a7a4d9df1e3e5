//! Derivatives of the methods that take the content out of an `Option` or a `Result`.

#![allow(clippy::type_complexity)]

use core::fmt::Debug;

use crate::{Additive, Differentiable, Tangent};

/// The `_vjp` siblings of the methods of options. The cotangent of an option is that of its content.
pub trait OptionRules: Differentiable<Tangent = Tangent<Self::Content>> {
    /// What the option may hold.
    type Content: Differentiable;

    /// Panics on `None`, as `unwrap` does.
    fn unwrap_vjp(
        self,
    ) -> (Self::Content, impl FnOnce(Tangent<Self::Content>) -> Tangent<Self> + use<Self>);

    /// Panics on `None`, as `expect` does.
    fn expect_vjp(
        self,
        message: &str,
    ) -> (Self::Content, impl FnOnce(Tangent<Self::Content>) -> (Tangent<Self>, ()) + use<Self>);

    /// The cotangent goes to what was taken.
    fn unwrap_or_vjp(
        self,
        default: Self::Content,
    ) -> (
        Self::Content,
        impl FnOnce(Tangent<Self::Content>) -> (Tangent<Self>, Tangent<Self::Content>) + use<Self>,
    );

    /// The cotangent goes to what was taken; the default is a constant.
    fn unwrap_or_default_vjp(
        self,
    ) -> (Self::Content, impl FnOnce(Tangent<Self::Content>) -> Tangent<Self> + use<Self>)
    where
        Self::Content: Default;
}

impl<T: Differentiable> OptionRules for Option<T> {
    type Content = T;

    #[inline(always)]
    #[track_caller]
    fn unwrap_vjp(self) -> (T, impl FnOnce(Tangent<T>) -> Tangent<T> + use<T>) {
        (self.unwrap(), |cotangent| cotangent)
    }

    #[inline(always)]
    #[track_caller]
    fn expect_vjp(
        self,
        message: &str,
    ) -> (T, impl FnOnce(Tangent<T>) -> (Tangent<T>, ()) + use<T>) {
        (self.expect(message), |cotangent| (cotangent, ()))
    }

    #[inline(always)]
    fn unwrap_or_vjp(
        self,
        default: T,
    ) -> (T, impl FnOnce(Tangent<T>) -> (Tangent<T>, Tangent<T>) + use<T>) {
        let is_some = self.is_some();
        (self.unwrap_or(default), move |cotangent| match is_some {
            true => (cotangent, Additive::zero()),
            false => (Additive::zero(), cotangent),
        })
    }

    #[inline(always)]
    fn unwrap_or_default_vjp(self) -> (T, impl FnOnce(Tangent<T>) -> Tangent<T> + use<T>)
    where
        T: Default,
    {
        let is_some = self.is_some();
        (self.unwrap_or_default(), move |cotangent| match is_some {
            true => cotangent,
            false => Additive::zero(),
        })
    }
}

/// The `_vjp` siblings of the methods of options of references, whose tangents are those of what is
/// referred to.
pub trait CopiedRules: Sized {
    /// What is referred to.
    type Target: Differentiable;

    /// The cotangent of the copy.
    fn copied_vjp(
        self,
    ) -> (Option<Self::Target>, fn(Tangent<Self::Target>) -> Tangent<Self::Target>)
    where
        Self::Target: Copy;

    /// The cotangent of the clone.
    fn cloned_vjp(
        self,
    ) -> (Option<Self::Target>, fn(Tangent<Self::Target>) -> Tangent<Self::Target>)
    where
        Self::Target: Clone;
}

impl<T: Differentiable> CopiedRules for Option<&T> {
    type Target = T;

    #[inline(always)]
    fn copied_vjp(self) -> (Option<T>, fn(Tangent<T>) -> Tangent<T>)
    where
        T: Copy,
    {
        (self.copied(), core::convert::identity)
    }

    #[inline(always)]
    fn cloned_vjp(self) -> (Option<T>, fn(Tangent<T>) -> Tangent<T>)
    where
        T: Clone,
    {
        (self.cloned(), core::convert::identity)
    }
}

/// The `_vjp` siblings of the methods of results.
pub trait ResultRules:
    Differentiable<Tangent = (Tangent<Self::Value>, Tangent<Self::Error>)>
{
    /// What a success holds.
    type Value: Differentiable;
    /// What a failure holds.
    type Error: Differentiable;

    /// Panics on `Err`, as `unwrap` does.
    fn unwrap_vjp(
        self,
    ) -> (Self::Value, impl FnOnce(Tangent<Self::Value>) -> Tangent<Self> + use<Self>)
    where
        Self::Error: Debug;

    /// Panics on `Err`, as `expect` does.
    fn expect_vjp(
        self,
        message: &str,
    ) -> (Self::Value, impl FnOnce(Tangent<Self::Value>) -> (Tangent<Self>, ()) + use<Self>)
    where
        Self::Error: Debug;

    /// The cotangent goes to what was taken.
    fn unwrap_or_vjp(
        self,
        default: Self::Value,
    ) -> (
        Self::Value,
        impl FnOnce(Tangent<Self::Value>) -> (Tangent<Self>, Tangent<Self::Value>) + use<Self>,
    );

    /// The cotangent goes to what was taken; the default is a constant.
    fn unwrap_or_default_vjp(
        self,
    ) -> (Self::Value, impl FnOnce(Tangent<Self::Value>) -> Tangent<Self> + use<Self>)
    where
        Self::Value: Default;
}

impl<T: Differentiable, E: Differentiable> ResultRules for Result<T, E> {
    type Value = T;
    type Error = E;

    #[inline(always)]
    #[track_caller]
    fn unwrap_vjp(self) -> (T, impl FnOnce(Tangent<T>) -> Tangent<Self> + use<T, E>)
    where
        E: Debug,
    {
        (self.unwrap(), |cotangent| (cotangent, Additive::zero()))
    }

    #[inline(always)]
    #[track_caller]
    fn expect_vjp(
        self,
        message: &str,
    ) -> (T, impl FnOnce(Tangent<T>) -> (Tangent<Self>, ()) + use<T, E>)
    where
        E: Debug,
    {
        (self.expect(message), |cotangent| ((cotangent, Additive::zero()), ()))
    }

    #[inline(always)]
    fn unwrap_or_vjp(
        self,
        default: T,
    ) -> (T, impl FnOnce(Tangent<T>) -> (Tangent<Self>, Tangent<T>) + use<T, E>) {
        let is_ok = self.is_ok();
        (self.unwrap_or(default), move |cotangent| match is_ok {
            true => ((cotangent, Additive::zero()), Additive::zero()),
            false => (Additive::zero(), cotangent),
        })
    }

    #[inline(always)]
    fn unwrap_or_default_vjp(self) -> (T, impl FnOnce(Tangent<T>) -> Tangent<Self> + use<T, E>)
    where
        T: Default,
    {
        let is_ok = self.is_ok();
        (self.unwrap_or_default(), move |cotangent| match is_ok {
            true => (cotangent, Additive::zero()),
            false => Additive::zero(),
        })
    }
}
