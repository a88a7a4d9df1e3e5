//! Derivatives of the methods that take the content out of an `Option` or a `Result`.

#![allow(clippy::type_complexity)]

use core::fmt::Debug;

use crate::{Additive, Boxed, Differentiable, Tangent};

/// The `_vjp` siblings of the methods of options. The cotangent of an option is that of its content.
pub trait OptionRules: Differentiable<Tangent = Tangent<Self::Content>> + Sized {
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

    /// The cotangent of what is referred to.
    fn as_ref_vjp(&self) -> (Option<&Self::Content>, fn(Tangent<Self>) -> Tangent<Self>);

    /// To what was there; nothing to the place, which is empty then.
    fn take_vjp(&mut self) -> (Self, fn(Tangent<Self>, Tangent<Self>) -> Tangent<Self>);

    /// To what was there; that of the place to the new value.
    fn replace_vjp(
        &mut self,
        value: Self::Content,
    ) -> (Self, fn(Tangent<Self>, Tangent<Self>) -> (Tangent<Self>, Tangent<Self::Content>));

    /// The cotangent goes to the one that was taken.
    fn or_vjp(
        self,
        other: Self,
    ) -> (Self, impl FnOnce(Tangent<Self>) -> (Tangent<Self>, Tangent<Self>) + use<Self>);

    /// The cotangent goes to the one that was taken.
    fn xor_vjp(
        self,
        other: Self,
    ) -> (Self, impl FnOnce(Tangent<Self>) -> (Tangent<Self>, Tangent<Self>) + use<Self>);

    /// The cotangents of both, if there are both.
    fn zip_vjp<U: Differentiable>(
        self,
        other: Option<U>,
    ) -> (
        Option<(Self::Content, U)>,
        impl FnOnce((Tangent<Self::Content>, Tangent<U>)) -> (Tangent<Self>, Tangent<U>) + use<Self, U>,
    );

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
    fn as_ref_vjp(&self) -> (Option<&T>, fn(Tangent<T>) -> Tangent<T>) {
        (self.as_ref(), core::convert::identity)
    }

    #[inline(always)]
    fn take_vjp(&mut self) -> (Self, fn(Tangent<T>, Tangent<T>) -> Tangent<T>) {
        (self.take(), |taken, _| taken)
    }

    #[inline(always)]
    fn replace_vjp(
        &mut self,
        value: T,
    ) -> (Self, fn(Tangent<T>, Tangent<T>) -> (Tangent<T>, Tangent<T>)) {
        (self.replace(value), |before, after| (before, after))
    }

    #[inline(always)]
    fn or_vjp(
        self,
        other: Self,
    ) -> (Self, impl FnOnce(Tangent<T>) -> (Tangent<T>, Tangent<T>) + use<T>) {
        let is_some = self.is_some();
        (self.or(other), move |cotangent| match is_some {
            true => (cotangent, Additive::zero()),
            false => (Additive::zero(), cotangent),
        })
    }

    #[inline(always)]
    fn xor_vjp(
        self,
        other: Self,
    ) -> (Self, impl FnOnce(Tangent<T>) -> (Tangent<T>, Tangent<T>) + use<T>) {
        let are_some = (self.is_some(), other.is_some());
        (self.xor(other), move |cotangent| match are_some {
            (true, false) => (cotangent, Additive::zero()),
            (false, true) => (Additive::zero(), cotangent),
            _ => (Additive::zero(), Additive::zero()),
        })
    }

    #[inline(always)]
    fn zip_vjp<U: Differentiable>(
        self,
        other: Option<U>,
    ) -> (
        Option<(T, U)>,
        impl FnOnce((Tangent<T>, Tangent<U>)) -> (Tangent<T>, Tangent<U>) + use<T, U>,
    ) {
        let zipped = self.zip(other);
        let are_some = zipped.is_some();
        (zipped, move |cotangents| match are_some {
            true => cotangents,
            false => (Additive::zero(), Additive::zero()),
        })
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

/// The `_vjp` sibling of `flatten` on an option of an option.
pub trait FlattenRules: Sized {
    /// The inner option.
    type Inner: Differentiable;

    /// The cotangent of the content.
    fn flatten_vjp(self) -> (Self::Inner, fn(Tangent<Self::Inner>) -> Tangent<Self::Inner>);
}

impl<T: Differentiable> FlattenRules for Option<Option<T>> {
    type Inner = Option<T>;

    #[inline(always)]
    fn flatten_vjp(self) -> (Option<T>, fn(Tangent<T>) -> Tangent<T>) {
        (self.flatten(), core::convert::identity)
    }
}

/// The siblings of `as_deref` on an option of a box.
pub trait DerefRules: Differentiable<Tangent = Boxed<Tangent<Self::Target>>> {
    /// What is in the box.
    type Target: Differentiable;

    /// The cotangent of what is referred to, in a box.
    fn as_deref_vjp(&self) -> (Option<&Self::Target>, fn(Tangent<Self::Target>) -> Tangent<Self>);

    /// The tangent of what is referred to.
    #[inline(always)]
    fn as_deref_jvp(
        &self,
        tangent: &Tangent<Self>,
    ) -> (Option<&Self::Target>, Tangent<Self::Target>) {
        (self.as_deref_vjp().0, (**tangent).clone())
    }
}

impl<T: Differentiable> DerefRules for Option<Box<T>> {
    type Target = T;

    #[inline(always)]
    fn as_deref_vjp(&self) -> (Option<&T>, fn(Tangent<T>) -> Boxed<Tangent<T>>) {
        (self.as_deref(), Boxed::new)
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
