//! Closures as objects.

use core::marker::PhantomData;

use super::{Callable, DifferentiableFn, ForwardFn, Parameters, Pullback};
use crate::{Additive, Differentiable, Tangent};

/// A closure: a function of whether the pullback is wanted and of the arguments. `T` is the cotangent
/// of what it captures.
pub struct Closure<T, F> {
    function: F,
    tangent: PhantomData<fn() -> T>,
}

impl<T, F: Clone> Clone for Closure<T, F> {
    fn clone(&self) -> Self {
        Self { function: self.function.clone(), tangent: self.tangent }
    }
}

impl<T, F: Copy> Copy for Closure<T, F> {}

/// The cotangent is not brought to the size of what is captured: it goes on to the variables that
/// were captured, whose own is.
impl<T: Additive, F> Differentiable for Closure<T, F> {
    type Tangent = T;
    type Shape = ();

    #[inline(always)]
    fn shape(&self) {}
}

impl<C, T, A, P: FnOnce(C) -> (T, A)> Pullback<C, T, A> for P {
    #[inline(always)]
    fn pull_back(self, cotangent: C) -> (T, A) {
        self(cotangent)
    }
}

#[diagnostic::do_not_recommend]
impl<Args, T, F, R, P> Callable<Args> for Closure<T, F>
where
    Args: Parameters,
    F: Clone + for<'a> Fn(bool, Args::Of<'a>) -> (R, Option<P>),
    R: Differentiable,
{
    type Output = R;

    #[inline(always)]
    fn call(&self, arguments: Args::Of<'_>) -> R {
        (self.function)(false, arguments).0
    }
}

#[diagnostic::do_not_recommend]
impl<Args, T, F, R, P> DifferentiableFn<Args> for Closure<T, F>
where
    Args: Parameters,
    T: Additive,
    F: Clone + for<'a> Fn(bool, Args::Of<'a>) -> (R, Option<P>),
    R: Differentiable,
    P: FnOnce(Tangent<R>) -> (T, Args::Tangents),
{
    type Pullback = P;

    #[inline(always)]
    fn call_vjp(&self, arguments: Args::Of<'_>) -> (R, P) {
        let (value, pullback) = (self.function)(true, arguments);
        (value, pullback.expect("a closure returns the pullback that is asked for"))
    }
}

/// The tangents of what a closure captures.
#[doc(hidden)]
pub struct Captured<T>(PhantomData<fn() -> T>);

impl<T: Additive> Captured<T> {
    /// The cotangents of what a closure captures.
    #[inline(always)]
    pub fn of<E: Differentiable<Tangent = T>>(_captured: &E) -> Self {
        Self(PhantomData)
    }

    /// A closure that captures this.
    #[inline(always)]
    pub fn closure<F>(self, function: F) -> Closure<T, F> {
        Closure { function, tangent: self.0 }
    }
}

/// The pullback of a closure that returned `_value`.
#[doc(hidden)]
#[inline(always)]
pub fn pullback<R: Differentiable, P, F: FnOnce(Tangent<R>) -> P>(
    _value: &R,
    pullback: F,
) -> Option<F> {
    Some(pullback)
}

/// A captured value through which no derivative flows.
#[doc(hidden)]
#[derive(Clone, Copy)]
pub struct Fixed<T>(pub T);

impl<T> Differentiable for Fixed<T> {
    type Tangent = ();
    type Shape = ();

    #[inline(always)]
    fn shape(&self) {}
}

/// A closure in forward mode: a function of the arguments and, where a tangent is wanted, of theirs.
#[derive(Clone, Copy)]
pub struct ForwardClosure<F>(F);

/// A closure in forward mode.
#[doc(hidden)]
#[inline(always)]
pub fn forward<F>(function: F) -> ForwardClosure<F> {
    ForwardClosure(function)
}

#[diagnostic::do_not_recommend]
impl<Args, F, R, T> Callable<Args> for ForwardClosure<F>
where
    Args: Parameters,
    F: Clone + for<'a> Fn(Args::Of<'a>, Option<Args::Dots<'a>>) -> (R, Option<T>),
    R: Differentiable,
{
    type Output = R;

    #[inline(always)]
    fn call(&self, arguments: Args::Of<'_>) -> R {
        (self.0)(arguments, None).0
    }
}

#[diagnostic::do_not_recommend]
impl<Args, F, R> ForwardFn<Args> for ForwardClosure<F>
where
    Args: Parameters,
    F: Clone + for<'a> Fn(Args::Of<'a>, Option<Args::Dots<'a>>) -> (R, Option<Tangent<R>>),
    R: Differentiable,
{
    #[inline(always)]
    fn call_jvp<'a>(&self, arguments: Args::Of<'a>, tangents: Args::Dots<'a>) -> (R, Tangent<R>) {
        let (value, tangent) = (self.0)(arguments, Some(tangents));
        (value, tangent.expect("a closure returns the tangent that is asked for"))
    }
}
