//! Options and results alike, for the methods of both, and for `?`, where only the type tells which of
//! them a value is.

#![allow(non_camel_case_types)]

use core::marker::PhantomData;

use super::linear::{Linear, Maps};
use super::twin::twins;
use crate::{Additive, Differentiable, NoDerivative, Tangent};

/// What stands in place of a content.
pub trait Failure: Differentiable {
    /// An option or a result of some content, which fails like this.
    type With<T: Differentiable>: Attempt<Content = T, Failure = Self>;

    /// One that did not fail.
    fn full<T: Differentiable>(content: T) -> Self::With<T>;

    /// One that did.
    fn again<T: Differentiable>(self) -> Self::With<T>;
}

/// An option or a result.
#[diagnostic::on_unimplemented(
    message = "a `{Self}` is taken for an option or a result here",
    note = "give an array a name and a type before: `let array: [f64; 3] = ..;`",
    note = "call a method of another type by its path: `Type::method(value, ..)`"
)]
pub trait Attempt: Differentiable {
    /// What it may hold.
    type Content: Differentiable;
    /// What it holds else.
    type Failure: Failure;

    /// The one or the other.
    fn split(self) -> Result<Self::Content, Self::Failure>;
    /// The tangent of both.
    fn joined(content: Tangent<Self::Content>, failure: Tangent<Self::Failure>) -> Tangent<Self>;
    /// The tangents of each.
    fn apart(tangent: Tangent<Self>) -> (Tangent<Self::Content>, Tangent<Self::Failure>);
}

/// How a type fails.
pub struct Kind<F>(PhantomData<F>);

impl<F> Differentiable for Kind<F> {
    type Tangent = ();
    type Shape = ();

    #[inline(always)]
    fn shape(&self) {}
}

impl<F> Clone for Kind<F> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<F> Copy for Kind<F> {}

/// How something fails.
#[inline(always)]
pub fn kind<A: Attempt>(_: &A) -> Kind<A::Failure> {
    Kind(PhantomData)
}

/// `None`
pub struct Missing;

impl Differentiable for Missing {
    type Tangent = ();
    type Shape = ();

    #[inline(always)]
    fn shape(&self) {}
}

impl Failure for Missing {
    type With<T: Differentiable> = Option<T>;

    #[inline(always)]
    fn full<T: Differentiable>(content: T) -> Option<T> {
        Some(content)
    }

    #[inline(always)]
    fn again<T: Differentiable>(self) -> Option<T> {
        None
    }
}

impl<T: Differentiable> Attempt for Option<T> {
    type Content = T;
    type Failure = Missing;

    #[inline(always)]
    fn split(self) -> Result<T, Missing> {
        self.ok_or(Missing)
    }

    #[inline(always)]
    fn joined(content: Tangent<T>, (): ()) -> Tangent<T> {
        content
    }

    #[inline(always)]
    fn apart(tangent: Tangent<T>) -> (Tangent<T>, ()) {
        (tangent, ())
    }
}

/// What an `Err` holds.
pub struct Failed<E>(pub E);

impl<E: Differentiable> Differentiable for Failed<E> {
    type Tangent = Tangent<E>;
    type Shape = E::Shape;

    #[inline(always)]
    fn shape(&self) -> E::Shape {
        self.0.shape()
    }

    #[inline(always)]
    fn zero_tangent(&self) -> Tangent<E> {
        self.0.zero_tangent()
    }
}

impl<E: Differentiable> Failure for Failed<E> {
    type With<T: Differentiable> = Result<T, E>;

    #[inline(always)]
    fn full<T: Differentiable>(content: T) -> Result<T, E> {
        Ok(content)
    }

    #[inline(always)]
    fn again<T: Differentiable>(self) -> Result<T, E> {
        Err(self.0)
    }
}

impl<T: Differentiable, E: Differentiable> Attempt for Result<T, E> {
    type Content = T;
    type Failure = Failed<E>;

    #[inline(always)]
    fn split(self) -> Result<T, Failed<E>> {
        self.map_err(Failed)
    }

    #[inline(always)]
    fn joined(content: Tangent<T>, failure: Tangent<E>) -> (Tangent<T>, Tangent<E>) {
        (content, failure)
    }

    #[inline(always)]
    fn apart(tangent: (Tangent<T>, Tangent<E>)) -> (Tangent<T>, Tangent<E>) {
        tangent
    }
}

/// The content or the failure.
#[inline(always)]
pub fn split<A: Attempt>(attempt: A) -> Result<A::Content, A::Failure> {
    attempt.split()
}

/// An attempt that did not fail, of this kind.
#[inline(always)]
pub fn full<F: Failure, T: Differentiable>(_: Kind<F>, content: T) -> F::With<T> {
    F::full(content)
}

/// An attempt that failed like this.
#[inline(always)]
pub fn again<F: Failure, T: Differentiable>(failure: F) -> F::With<T> {
    failure.again()
}

/// What `?` can return for a failure.
#[diagnostic::on_unimplemented(
    message = "`?` cannot return this failure as a `{Self}`",
    note = "`?` is supported in functions that return an `Option` or a `Result`: use `match`"
)]
pub trait Fails<F>: Differentiable {
    /// The failure, as one of this type.
    fn failed(failure: F) -> Self;
}

impl<T: Differentiable> Fails<Missing> for Option<T> {
    #[inline(always)]
    fn failed(_: Missing) -> Self {
        None
    }
}

impl<T: Differentiable, E: NoDerivative, G: From<E> + Differentiable> Fails<Failed<E>>
    for Result<T, G>
{
    #[inline(always)]
    fn failed(failure: Failed<E>) -> Self {
        Err(failure.0.into())
    }
}

/// What `?` returns.
#[inline(always)]
pub fn failed<F: Failure, R: Fails<F>>(failure: F) -> R {
    R::failed(failure)
}

twins! {
    split[A: Attempt](attempt: A) -> Result<A::Content, A::Failure> = attempt.split()
        => Maps(A::apart, |(content, failure)| A::joined(content, failure));
    full[F: Failure, T: Differentiable](kind: Kind<F>, content: T) -> F::With<T>
        = full(kind, content)
        => Maps(
            |((), content)| F::With::<T>::joined(content, Additive::zero()),
            |tangent| ((), F::With::<T>::apart(tangent).0),
        );
    again[F: Failure, T: Differentiable](failure: F) -> F::With<T> = failure.again()
        => Maps(
            |failure| F::With::<T>::joined(Additive::zero(), failure),
            |tangent| F::With::<T>::apart(tangent).1,
        );
}

/// The derivative of [`failed`](fn@failed).
pub enum failed {}

impl failed {
    /// Nothing flows through `?` on the side of the failure.
    #[inline(always)]
    pub fn vjp<F: Failure, R: Fails<F>>(failure: F) -> (R, fn(Tangent<R>) -> Tangent<F>) {
        (R::failed(failure), |_| Additive::zero())
    }

    /// Nothing flows through `?` on the side of the failure.
    #[inline(always)]
    pub fn jvp<F: Failure, R: Fails<F>>(failure: F, _: Tangent<F>) -> (R, Tangent<R>) {
        crate::rt::with_zero(R::failed(failure))
    }
}
