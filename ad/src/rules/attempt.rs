//! Options and results alike, for the methods of both, and for `?`, where only the type tells which of
//! them a value is; and what else has `map`, [arrays](super::arranged) and vectors.
//!
//! Where `map` may be that of an array, the function is written twice: for a content, and for each of some
//! elements. Which of both runs `spread` tells, by its type: the other is given nothing, and the compiler drops it.
//! Turned down: one function for a list of contents, which needs the heap; and a question to the user, who has to
//! give arrays a name with a type then.

#![allow(non_camel_case_types)]

use core::marker::PhantomData;

use super::linear::{Linear, Maps};
use super::twin::twins;
use crate::{Additive, Differentiable, NoDerivative, Tangent};

/// What stands in place of a content: how something fails.
pub trait Failure: Differentiable {}

/// What can stand in place of such a content.
pub trait Holds<T: Differentiable>: Failure {
    /// What holds such a content, and fails like this.
    type Whole: Mapped<Content = T, Failure = Self>;

    /// One that did not fail.
    fn full(content: T) -> Self::Whole;

    /// One that did.
    fn again(self) -> Self::Whole;
}

/// What may stand in place of elements: the value of one.
#[diagnostic::on_unimplemented(
    message = "`{T}` is not `Clone`, and `map` copies the elements of an array here",
    note = "put `#[derive(Clone)]` on it, or write a loop"
)]
pub trait Takes<T: Differentiable>: Failure {
    /// A copy of an element, if there is one.
    fn taken(element: &T) -> T;
}

/// An option, a result, an array or a vector.
#[diagnostic::on_unimplemented(
    message = "a `{Self}` is taken for an option, a result, an array or a vector here",
    note = "call a method of another type by its path: `Type::method(value, ..)`"
)]
pub trait Mapped: Differentiable {
    /// What it may hold.
    type Content: Differentiable;
    /// What it holds else.
    type Failure: Failure;
    /// The elements of an array or a vector, or an array of none.
    type Elements: Differentiable;

    /// The one, the other, or the third.
    fn spread(self) -> Result<Result<Self::Content, Self::Failure>, Self::Elements>;
    /// One of elements.
    fn whole(elements: Self::Elements) -> Self;
    /// The tangent of all three.
    fn joined(
        content: Tangent<Self::Content>,
        failure: Tangent<Self::Failure>,
        elements: Tangent<Self::Elements>,
    ) -> Tangent<Self>;
    /// The tangents of each.
    #[allow(clippy::type_complexity)]
    fn apart(
        tangent: Tangent<Self>,
    ) -> (Tangent<Self::Content>, Tangent<Self::Failure>, Tangent<Self::Elements>);
}

/// An option or a result.
#[diagnostic::on_unimplemented(
    message = "a `{Self}` is taken for an option or a result here",
    note = "give an array a name and a type before: `let array: [f64; 3] = ..;`",
    note = "call a method of another type by its path: `Type::method(value, ..)`"
)]
pub trait Attempt: Mapped {}

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

/// How something fails that may have elements.
#[inline(always)]
pub fn mapped_kind<A: Mapped>(_: &A) -> Kind<A::Failure> {
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

impl Failure for Missing {}

impl<T: Differentiable> Holds<T> for Missing {
    type Whole = Option<T>;

    #[inline(always)]
    fn full(content: T) -> Option<T> {
        Some(content)
    }

    #[inline(always)]
    fn again(self) -> Option<T> {
        None
    }
}

impl<T: Differentiable> Takes<T> for Missing {
    #[inline(always)]
    fn taken(_: &T) -> T {
        unreachable!("an option has no elements")
    }
}

impl<T: Differentiable> Attempt for Option<T> {}

impl<T: Differentiable> Mapped for Option<T> {
    type Content = T;
    type Failure = Missing;
    type Elements = [T; 0];

    #[inline(always)]
    fn spread(self) -> Result<Result<T, Missing>, [T; 0]> {
        Ok(self.ok_or(Missing))
    }

    #[inline(always)]
    fn whole([]: [T; 0]) -> Self {
        None
    }

    #[inline(always)]
    fn joined(content: Tangent<T>, (): (), []: [Tangent<T>; 0]) -> Tangent<T> {
        content
    }

    #[inline(always)]
    fn apart(tangent: Tangent<T>) -> (Tangent<T>, (), [Tangent<T>; 0]) {
        (tangent, (), [])
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

impl<E: Differentiable> Failure for Failed<E> {}

impl<T: Differentiable, E: Differentiable> Holds<T> for Failed<E> {
    type Whole = Result<T, E>;

    #[inline(always)]
    fn full(content: T) -> Result<T, E> {
        Ok(content)
    }

    #[inline(always)]
    fn again(self) -> Result<T, E> {
        Err(self.0)
    }
}

impl<T: Differentiable, E: Differentiable> Takes<T> for Failed<E> {
    #[inline(always)]
    fn taken(_: &T) -> T {
        unreachable!("a result has no elements")
    }
}

impl<T: Differentiable, E: Differentiable> Attempt for Result<T, E> {}

impl<T: Differentiable, E: Differentiable> Mapped for Result<T, E> {
    type Content = T;
    type Failure = Failed<E>;
    type Elements = [T; 0];

    #[inline(always)]
    fn spread(self) -> Result<Result<T, Failed<E>>, [T; 0]> {
        Ok(self.map_err(Failed))
    }

    #[inline(always)]
    fn whole([]: [T; 0]) -> Self {
        unreachable!("a result has a content or a failure")
    }

    #[inline(always)]
    fn joined(
        content: Tangent<T>,
        failure: Tangent<E>,
        []: [Tangent<T>; 0],
    ) -> (Tangent<T>, Tangent<E>) {
        (content, failure)
    }

    #[inline(always)]
    fn apart(
        (content, failure): (Tangent<T>, Tangent<E>),
    ) -> (Tangent<T>, Tangent<E>, [Tangent<T>; 0]) {
        (content, failure, [])
    }
}

/// The content or the failure.
#[inline(always)]
pub fn split<A: Attempt>(attempt: A) -> Result<A::Content, A::Failure> {
    match attempt.spread() {
        Ok(parts) => parts,
        Err(_) => unreachable!("an option or a result has no elements"),
    }
}

/// The content, the failure, or the elements.
#[inline(always)]
pub fn spread<M: Mapped>(mapped: M) -> Result<Result<M::Content, M::Failure>, M::Elements> {
    mapped.spread()
}

/// What is made of these elements, of this kind.
#[inline(always)]
pub fn whole<T: Differentiable, F: Holds<T, Whole: Mapped<Elements = [T; N]>>, const N: usize>(
    _: Kind<F>,
    elements: [T; N],
) -> F::Whole {
    Mapped::whole(elements)
}

/// The value of an element of what is of this kind.
#[inline(always)]
pub fn taken<F: Takes<T>, T: Differentiable>(_: Kind<F>, element: &T) -> T {
    F::taken(element)
}

/// An attempt that did not fail, of this kind.
#[inline(always)]
pub fn full<F: Holds<T>, T: Differentiable>(_: Kind<F>, content: T) -> F::Whole {
    F::full(content)
}

/// An attempt that failed like this.
#[inline(always)]
pub fn again<F: Holds<T>, T: Differentiable>(failure: F) -> F::Whole {
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
    split[A: Attempt](attempt: A) -> Result<A::Content, A::Failure> = split(attempt)
        => Maps(
            |tangent| {
                let (content, failure, _) = A::apart(tangent);
                (content, failure)
            },
            |(content, failure)| A::joined(content, failure, Additive::zero()),
        );
    spread[M: Mapped](mapped: M) -> Result<Result<M::Content, M::Failure>, M::Elements>
        = mapped.spread()
        => Maps(
            |tangent| {
                let (content, failure, elements) = M::apart(tangent);
                ((content, failure), elements)
            },
            |((content, failure), elements)| M::joined(content, failure, elements),
        );
    whole[T: Differentiable, F: Holds<T, Whole: Mapped<Elements = [T; N]>>, const N: usize](
        kind: Kind<F>, elements: [T; N]
    ) -> F::Whole = whole(kind, elements)
        => Maps(
            |((), elements)| F::Whole::joined(Additive::zero(), Additive::zero(), elements),
            |whole| ((), F::Whole::apart(whole).2),
        );
    full[F: Holds<T>, T: Differentiable](kind: Kind<F>, content: T) -> F::Whole
        = full(kind, content)
        => Maps(
            |((), content)| F::Whole::joined(content, Additive::zero(), Additive::zero()),
            |whole| ((), F::Whole::apart(whole).0),
        );
    again[F: Holds<T>, T: Differentiable](failure: F) -> F::Whole = failure.again()
        => Maps(
            |failure| F::Whole::joined(Additive::zero(), failure, Additive::zero()),
            |whole| F::Whole::apart(whole).1,
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
