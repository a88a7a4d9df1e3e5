//! The rules of the methods of an `Option` and of a `Result`. The tangent of an option is that of its
//! content, the tangent of a result the pair of those of content and error.

use core::fmt::Debug;
use core::mem::replace;

use super::linear::{Linear, Maps};
use crate::{Additive, Boxed, Differentiable, Tangent};

/// Rules of methods that take an outcome apart. A row names the method, the receiver, and an argument with its
/// type and that of its tangent; it gives the value with the linear map from the tangents of receiver and
/// argument to that of the value.
macro_rules! outcomes {
    ($(
        $(#[$doc:meta])*
        $method:ident $(<$U:ident>)? ($whole:ident $(, $argument:ident: $type:ty | $dot:ty)?) -> $R:ty
            $(where $bounded:ty: $bound:ident)? => $rule:expr;
    )*) => { pastey::paste! {$(
        #[doc = concat!("The pullback of `", stringify!($method), "`.")]
        #[doc = ""]
        $(#[$doc])*
        #[inline(always)]
        #[track_caller]
        #[allow(unused_parens)]
        fn [<$method _vjp>] $(<$U: Differentiable>)? (
            self $(, $argument: $type)?
        ) -> ($R, impl FnOnce(Tangent<$R>) -> (Tangent<Self> $(, $dot)?) + use<Self $(, $U)?>)
        $(where $bounded: $bound)?
        {
            let $whole = self.whole();
            let (value, map) = $rule;
            (value, move |cotangent| map.pull(cotangent))
        }

        #[doc = concat!("The derivative along tangents of `", stringify!($method), "`.")]
        #[inline(always)]
        #[track_caller]
        #[allow(unused_parens)]
        fn [<$method _jvp>] $(<$U: Differentiable>)? (
            self $(, $argument: $type)?, tangent: Tangent<Self> $(, dot: outcomes!(@of $argument $dot))?
        ) -> ($R, Tangent<$R>)
        $(where $bounded: $bound)?
        {
            let $whole = self.whole();
            let (value, map) = $rule;
            let tangents = (tangent $(, outcomes!(@dot $argument dot))?);
            (value, map.push(tangents))
        }
    )*}};
    (@of $argument:ident $dot:ty) => { $dot };
    (@dot $argument:ident $dot:ident) => { $dot };
}

/// Rules of methods that give the content of an outcome. A row names the method, the receiver, and an argument with
/// its type and that of its tangent; it gives the value, its tangent from those of receiver and argument, and the
/// cotangents of these.
///
/// The type of a pullback says nothing of the outcome: that may hold a reference to what lives shorter.
macro_rules! contents {
    ($(
        $(#[$doc:meta])*
        $method:ident ($whole:ident $(, $argument:ident: $type:ty | $dot:ty)?) -> $R:ty
            $(where $bounded:ty: $bound:ident)? => $value:expr, $push:expr, $pull:expr;
    )*) => { pastey::paste! {$(
        #[doc = concat!("The pullback of `", stringify!($method), "`.")]
        #[doc = ""]
        $(#[$doc])*
        #[inline(always)]
        #[track_caller]
        #[allow(unused_parens, clippy::type_complexity)]
        fn [<$method _vjp>](self $(, $argument: $type)?)
            -> ($R, fn(Tangent<$R>) -> (Tangent<Self> $(, $dot)?))
        $(where $bounded: $bound)?
        {
            let $whole = self.whole();
            ($value, $pull)
        }

        #[doc = concat!("The derivative along tangents of `", stringify!($method), "`.")]
        #[inline(always)]
        #[track_caller]
        #[allow(unused_parens)]
        fn [<$method _jvp>](
            self $(, $argument: $type)?, tangent: Tangent<Self> $(, dot: outcomes!(@of $argument $dot))?
        ) -> ($R, Tangent<$R>)
        $(where $bounded: $bound)?
        {
            let $whole = self.whole();
            let push: fn(_) -> _ = $push;
            let tangents = (tangent $(, outcomes!(@dot $argument dot))?);
            ($value, push(tangents))
        }
    )*}};
}

/// Both tangents of a pair, or one of them, or none: what was not taken does not count.
#[derive(Clone, Copy)]
struct Taken {
    first: bool,
    second: bool,
}

impl Taken {
    /// Either the first one or the second one.
    #[inline(always)]
    fn first_if(first: bool) -> Self {
        Self { first, second: !first }
    }

    /// What was taken of a pair; zero of the rest.
    #[inline(always)]
    fn of<A: Additive, B: Additive>(self, (a, b): (A, B)) -> (A, B) {
        (if self.first { a } else { A::zero() }, if self.second { b } else { B::zero() })
    }

    /// The tangent of a constant, if that is what was taken.
    fn zero_of_second<T: Differentiable>(self, constant: &T) -> Tangent<T> {
        if self.second { constant.zero_tangent() } else { Additive::zero() }
    }
}

impl<T: Additive> Linear<(T, T), T> for Taken {
    #[inline(always)]
    fn push(self, (first, second): (T, T)) -> T {
        match self {
            Self { first: true, .. } => first,
            Self { second: true, .. } => second,
            _ => T::zero(),
        }
    }

    #[inline(always)]
    fn pull(self, cotangent: T) -> (T, T) {
        match self {
            Self { first: true, .. } => (cotangent, T::zero()),
            Self { second: true, .. } => (T::zero(), cotangent),
            _ => (T::zero(), T::zero()),
        }
    }
}

/// The rules of the methods of options.
pub trait OptionRules: Differentiable<Tangent = Tangent<Self::Content>> + Sized {
    /// What the option may hold.
    type Content: Differentiable;

    /// The option.
    fn whole(self) -> Option<Self::Content>;
    /// The option, to read.
    fn view(&self) -> &Option<Self::Content>;
    /// The option, to change.
    fn place(&mut self) -> &mut Option<Self::Content>;

    contents! {
        /// Panics on `None`, as `unwrap` does.
        unwrap(option) -> Self::Content
            => option.unwrap(), |content| content, |content| content;
        /// Panics on `None`, as `expect` does.
        expect(option, message: &str | ()) -> Self::Content
            => option.expect(message), |(content, ())| content, |content| (content, ());
    }

    outcomes! {
        /// To the one that was taken.
        or(option, other: Self | Tangent<Self>) -> Option<Self::Content> => {
            let taken = Taken::first_if(option.is_some());
            (option.or(other.whole()), taken)
        };
        /// To the one that was taken.
        xor(option, other: Self | Tangent<Self>) -> Option<Self::Content> => {
            let other = other.whole();
            let (first, second) = (option.is_some(), other.is_some());
            (option.xor(other), Taken { first: first && !second, second: second && !first })
        };
        /// To both, if there are both.
        zip<U>(option, other: Option<U> | Tangent<U>) -> Option<(Self::Content, U)> => {
            let zipped = option.zip(other);
            let taken = Taken { first: zipped.is_some(), second: zipped.is_some() };
            (zipped, Maps(|pair| pair, move |pair| taken.of(pair)))
        };
        /// To what was taken.
        unwrap_or(option, default: Self::Content | Tangent<Self::Content>) -> Self::Content => {
                let taken = Taken::first_if(option.is_some());
                (option.unwrap_or(default), taken)
            };
        /// To what was taken; the default is a constant.
        unwrap_or_default(option) -> Self::Content
            where Self::Content: Default => {
                let taken = Taken::first_if(option.is_some());
                let content = option.unwrap_or_default();
                let still = taken.zero_of_second(&content);
                (content, Maps(move |t| taken.push((t, still)), move |g| taken.pull(g).0))
            };
    }

    /// The cotangent of what is referred to.
    #[inline(always)]
    fn as_ref_vjp(&self) -> (Option<&Self::Content>, fn(Tangent<Self>) -> Tangent<Self>) {
        (self.view().as_ref(), core::convert::identity)
    }

    /// The tangent of what is referred to.
    #[inline(always)]
    fn as_ref_jvp(&self, tangent: &Tangent<Self>) -> (Option<&Self::Content>, Tangent<Self>) {
        (self.view().as_ref(), tangent.clone())
    }

    /// To what was there; nothing to the place, which is empty then.
    #[inline(always)]
    fn take_vjp(
        &mut self,
    ) -> (Option<Self::Content>, fn(Tangent<Self>, Tangent<Self>) -> Tangent<Self>) {
        (self.place().take(), |taken, _| taken)
    }

    /// The tangent of what was there.
    #[inline(always)]
    fn take_jvp(&mut self, tangent: &mut Tangent<Self>) -> (Option<Self::Content>, Tangent<Self>) {
        (self.place().take(), replace(tangent, Additive::zero()))
    }

    /// To what was there; that of the place to the new value.
    #[inline(always)]
    fn replace_vjp(
        &mut self,
        value: Self::Content,
    ) -> (
        Option<Self::Content>,
        fn(Tangent<Self>, Tangent<Self>) -> (Tangent<Self>, Tangent<Self::Content>),
    ) {
        (self.place().replace(value), |before, after| (before, after))
    }

    /// The tangent of what was there; that of the new value takes its place.
    #[inline(always)]
    fn replace_jvp(
        &mut self,
        value: Self::Content,
        tangent: &mut Tangent<Self>,
        value_tangent: Tangent<Self::Content>,
    ) -> (Option<Self::Content>, Tangent<Self>) {
        (self.place().replace(value), replace(tangent, value_tangent))
    }
}

impl<T: Differentiable> OptionRules for Option<T> {
    type Content = T;

    #[inline(always)]
    fn whole(self) -> Self {
        self
    }

    #[inline(always)]
    fn view(&self) -> &Self {
        self
    }

    #[inline(always)]
    fn place(&mut self) -> &mut Self {
        self
    }
}

/// The rules of the methods of results.
pub trait ResultRules:
    Differentiable<Tangent = (Tangent<Self::Value>, Tangent<Self::Error>)> + Sized
{
    /// What a success holds.
    type Value: Differentiable;
    /// What a failure holds.
    type Error: Differentiable;

    /// The result.
    fn whole(self) -> Result<Self::Value, Self::Error>;

    /// The result, to read.
    fn view(&self) -> &Result<Self::Value, Self::Error>;

    contents! {
        /// Panics on `Err`, as `unwrap` does.
        unwrap(result) -> Self::Value where Self::Error: Debug
            => result.unwrap(), |(content, _)| content, |content| (content, Additive::zero());
        /// Panics on `Err`, as `expect` does.
        expect(result, message: &str | ()) -> Self::Value where Self::Error: Debug
            => result.expect(message), |((content, _), ())| content,
            |content| ((content, Additive::zero()), ());
    }

    /// The cotangents of what is referred to.
    #[inline(always)]
    #[allow(clippy::type_complexity)]
    fn as_ref_vjp(
        &self,
    ) -> (Result<&Self::Value, &Self::Error>, fn(Tangent<Self>) -> Tangent<Self>) {
        (self.view().as_ref(), core::convert::identity)
    }

    /// The tangents of what is referred to.
    #[inline(always)]
    fn as_ref_jvp(
        &self,
        tangent: &Tangent<Self>,
    ) -> (Result<&Self::Value, &Self::Error>, Tangent<Self>) {
        (self.view().as_ref(), tangent.clone())
    }

    outcomes! {
        /// To what was taken.
        unwrap_or(result, default: Self::Value | Tangent<Self::Value>) -> Self::Value => {
                let taken = Taken::first_if(result.is_ok());
                let map = Maps(move |((content, _), default)| taken.push((content, default)), move |g| {
                    let (content, default) = taken.pull(g);
                    ((content, Additive::zero()), default)
                });
                (result.unwrap_or(default), map)
            };
        /// To what was taken; the default is a constant.
        unwrap_or_default(result) -> Self::Value
            where Self::Value: Default => {
                let taken = Taken::first_if(result.is_ok());
                let content = result.unwrap_or_default();
                let still = taken.zero_of_second(&content);
                let map = Maps(move |(t, _)| taken.push((t, still)), move |g| {
                    (taken.pull(g).0, Additive::zero())
                });
                (content, map)
            };
    }
}

impl<T: Differentiable, E: Differentiable> ResultRules for Result<T, E> {
    type Value = T;
    type Error = E;

    #[inline(always)]
    fn whole(self) -> Self {
        self
    }

    #[inline(always)]
    fn view(&self) -> &Self {
        self
    }
}

/// Rules of methods that look at an option in another way: the tangent is the same.
macro_rules! views {
    ($($(#[$doc:meta])* $rules:ident for [$($generics:tt)*] $type:ty, $content:ident = $T:ty {
        $($method:ident -> $R:ty $(where $bounded:ty: $bound:ident)?;)*
    })*) => { pastey::paste! {$(
        $(#[$doc])*
        pub trait $rules: Sized {
            /// What is referred to.
            type $content: Differentiable;

            $(
                /// The cotangent of what is referred to.
                fn [<$method _vjp>](self) -> ($R, fn(Tangent<Self::$content>) -> Tangent<Self::$content>)
                $(where $bounded: $bound)?;

                /// The tangent of what is referred to.
                fn [<$method _jvp>](self, tangent: Tangent<Self::$content>) -> ($R, Tangent<Self::$content>)
                $(where $bounded: $bound)?;
            )*
        }

        impl<$($generics)*> $rules for $type {
            type $content = $T;

            $(
                #[inline(always)]
                fn [<$method _vjp>](self) -> ($R, fn(Tangent<Self::$content>) -> Tangent<Self::$content>)
                $(where $bounded: $bound)?
                {
                    (self.$method(), core::convert::identity)
                }

                #[inline(always)]
                fn [<$method _jvp>](self, tangent: Tangent<Self::$content>) -> ($R, Tangent<Self::$content>)
                $(where $bounded: $bound)?
                {
                    (self.$method(), tangent)
                }
            )*
        }
    )*}};
}

views! {
    /// The rules of the methods of options of references.
    CopiedRules for [T: Differentiable] Option<&T>, Target = T {
        copied -> Option<Self::Target> where Self::Target: Copy;
        cloned -> Option<Self::Target> where Self::Target: Clone;
    }

    /// The rules of `flatten` on an option of an option.
    FlattenRules for [T: Differentiable] Option<Option<T>>, Inner = Option<T> {
        flatten -> Self::Inner;
    }
}

/// The rules of `as_deref` on an option of a box.
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
