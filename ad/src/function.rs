//! Functions that take functions: `fn integrate<F: Fn(f64) -> f64>(f: F, a: f64, b: f64) -> f64`.
//!
//! A closure that is passed to a differentiable function has a derivative in two directions: by its
//! arguments, and by the variables that it captures. So the closure itself is a value with a
//! cotangent, the tuple of those of what it captures, which the pullback of the function that was
//! called returns at the place of the closure.
//!
//! In a derivative the bound `F: Fn(f64, &[f64]) -> f64` reads
//! `F: DifferentiableFn<(Value<f64>, Reference<[f64]>), Output = f64>`, and a call `f(x, y)` is
//! [`call_vjp`](DifferentiableFn::call_vjp). Where the closure is passed, `#[differentiable]` writes
//! an object with that trait: copies of what it captures, and a function with both sweeps of its
//! body.
//!
//! In forward mode the bound reads `F: ForwardFn<..>`, a call is
//! [`call_jvp`](ForwardFn::call_jvp), and the object holds the tangents of what it captures too: at its
//! place among the tangents that are passed stands `()`. A function that is passed by its name becomes
//! an object of it and its derivative, [`Named`].
//!
//! A closure whose parameters have no types gets them from the function that it is passed to, which
//! brings a function for each such parameter that makes the object (`f::argument_0`): the compiler takes
//! the types of a closure from a bound `Fn(..)` at the place where it is written, and there alone. Another
//! (`f::passed_0`) turns a reference to an object into what `f` takes: a copy of the object, or the
//! reference.
//!
//! The object owns what it captures, so passing a closure costs a copy of that; and each call of it
//! gathers the cotangent of all that it captures, as each call of a function does of what is passed
//! to it. References cannot stay: a pullback may outlive the variables that the closure was written
//! beside, and on stable Rust its type holds that of the closure, lifetimes included.
//!
//! Turned down: writing the function out at each call (its body is not known there, nor is a
//! function that calls itself ever written out); passing the captured variables on as further
//! arguments (their number is no part of a generic function's type); a boxed closure (an allocation
//! for each call of it).

mod closure;
mod named;

use core::marker::PhantomData;

use crate::{Additive, Differentiable, Tangent};

pub use closure::{Captured, Closure, Fixed, ForwardClosure, forward, pullback};
pub use named::{Named, NamedPullback, named};

/// What a reference in a function's parameters refers to.
pub trait Referent: Differentiable {
    /// What a reference to its tangent refers to.
    type Dot: ?Sized;
}

impl<T: Differentiable> Referent for T {
    type Dot = Tangent<T>;
}

impl<T> Referent for [T]
where
    T: Differentiable,
    [T]: Differentiable,
{
    type Dot = [Tangent<T>];
}

/// A parameter of a function, by value or by reference.
pub trait Parameter {
    /// What is passed.
    type Of<'a>;
    /// The cotangent of it.
    type Tangent: Additive;
    /// The tangent of it, as it is passed.
    type Dot<'a>;
}

/// A parameter of type `T`.
pub struct Value<T>(PhantomData<T>);

/// A parameter of type `&T`.
pub struct Reference<T: ?Sized>(PhantomData<T>);

impl<T: Differentiable> Parameter for Value<T> {
    type Of<'a> = T;
    type Tangent = Tangent<T>;
    type Dot<'a> = Tangent<T>;
}

impl<T: Referent + ?Sized + 'static> Parameter for Reference<T>
where
    T::Dot: 'static,
{
    type Of<'a> = &'a T;
    type Tangent = Tangent<T>;
    type Dot<'a> = &'a T::Dot;
}

/// The parameters of a function: a tuple of [`Value`]s and [`Reference`]s.
pub trait Parameters {
    /// What is passed: the tuple of it.
    type Of<'a>;
    /// The cotangents of it.
    type Tangents;
    /// The tangents of it, as they are passed.
    type Dots<'a>;
}

/// A function that generated code can call.
pub trait Callable<Args: Parameters>: Clone {
    /// What it returns.
    type Output: Differentiable;

    /// The value.
    fn call(&self, arguments: Args::Of<'_>) -> Self::Output;
}

/// From the cotangent `C` of the result of a function to those of what it captures, `T`, and of the
/// arguments, `A`.
pub trait Pullback<C, T, A> {
    /// The cotangents.
    fn pull_back(self, cotangent: C) -> (T, A);
}

/// A function that can be differentiated by its arguments and by what it captures.
#[diagnostic::on_unimplemented(
    message = "this function has no derivative that `#[differentiable]` could pass on",
    label = "has to be a closure, or the name of a differentiable function",
    note = "pass a function by value, not `&f`, where the method called takes it by value",
    note = "from code without derivatives, call a `#[differentiable]` function that passes the closure"
)]
pub trait DifferentiableFn<Args: Parameters>: Callable<Args> + Differentiable {
    /// From the cotangent of the result to those of what is captured and of the arguments.
    type Pullback: Pullback<Tangent<Self::Output>, Tangent<Self>, Args::Tangents>;

    /// The value and the pullback.
    fn call_vjp(&self, arguments: Args::Of<'_>) -> (Self::Output, Self::Pullback);
}

/// A function that holds the tangents of what it captures.
#[diagnostic::on_unimplemented(
    message = "this function has no derivative that `#[differentiable]` could pass on",
    label = "has to be a closure, or the name of a differentiable function",
    note = "pass a function by value, not `&f`, where the method called takes it by value",
    note = "from code without derivatives, call a `#[differentiable]` function that passes the closure"
)]
pub trait ForwardFn<Args: Parameters>: Callable<Args> {
    /// The value and its tangent.
    fn call_jvp<'a>(
        &self,
        arguments: Args::Of<'a>,
        tangents: Args::Dots<'a>,
    ) -> (Self::Output, Tangent<Self::Output>);
}

/// The function, to be passed on.
#[doc(hidden)]
#[inline(always)]
pub fn again<F: Clone>(function: &F) -> F {
    function.clone()
}

/// The value and the pullback of [`again`].
#[doc(hidden)]
#[inline(always)]
pub fn again_vjp<F: Differentiable + Clone>(
    function: &F,
) -> (F, impl FnOnce(Tangent<F>) -> Tangent<F> + use<F>) {
    (function.clone(), |cotangent| cotangent)
}

/// The forward mode of [`again`].
#[doc(hidden)]
#[inline(always)]
pub fn again_jvp<F: Clone>(function: &F, (): ()) -> (F, ()) {
    (function.clone(), ())
}

macro_rules! arities {
    ($($call:ident $call_vjp:ident $call_jvp:ident ($($argument:ident $dot:ident $parameter:ident),*);)*) => {$(
        impl<$($parameter: Parameter),*> Parameters for ($($parameter,)*) {
            type Of<'a> = ($($parameter::Of<'a>,)*);
            type Tangents = ($($parameter::Tangent,)*);
            type Dots<'a> = ($($parameter::Dot<'a>,)*);
        }

        /// The value of a function for these arguments.
        #[doc(hidden)]
        #[inline(always)]
        #[allow(clippy::extra_unused_lifetimes, reason = "used where there are arguments")]
        pub fn $call<'a, F: Callable<($($parameter,)*)>, $($parameter: Parameter),*>(
            function: &F,
            $($argument: $parameter::Of<'a>),*
        ) -> F::Output {
            function.call(($($argument,)*))
        }

        /// The value, and the cotangents of the function and of the arguments.
        #[doc(hidden)]
        #[inline(always)]
        #[allow(clippy::type_complexity)]
        #[allow(clippy::extra_unused_lifetimes, reason = "used where there are arguments")]
        pub fn $call_vjp<'a, F: DifferentiableFn<($($parameter,)*)>, $($parameter: Parameter),*>(
            function: &F,
            $($argument: $parameter::Of<'a>),*
        ) -> (
            F::Output,
            impl FnOnce(Tangent<F::Output>) -> arities!(@parts F $($parameter)*)
                + use<F, $($parameter),*>,
        ) {
            let (value, pullback) = function.call_vjp(($($argument,)*));
            (value, move |cotangent| {
                let (captured, ($($argument,)*)) = pullback.pull_back(cotangent);
                arities!(@cotangents captured $($argument)*)
            })
        }

        arities!(@forward $call_jvp ($($argument $dot $parameter),*));
    )*};
    (@forward $call_jvp:ident ()) => {
        /// The value and its tangent; a function that is passed has none of its own.
        #[doc(hidden)]
        #[inline(always)]
        pub fn $call_jvp<F: ForwardFn<()>>(
            function: &F,
            (): (),
        ) -> (F::Output, Tangent<F::Output>) {
            function.call_jvp((), ())
        }
    };
    (@forward $call_jvp:ident ($($argument:ident $dot:ident $parameter:ident),+)) => {
        /// The value and its tangent; a function that is passed has none of its own.
        #[doc(hidden)]
        #[inline(always)]
        #[allow(clippy::too_many_arguments, reason = "those of the function, and their tangents")]
        pub fn $call_jvp<'a, F: ForwardFn<($($parameter,)*)>, $($parameter: Parameter),*>(
            function: &F,
            $($argument: $parameter::Of<'a>,)*
            (): (),
            $($dot: $parameter::Dot<'a>),*
        ) -> (F::Output, Tangent<F::Output>) {
            function.call_jvp(($($argument,)*), ($($dot,)*))
        }
    };
    (@parts $function:ident) => { Tangent<$function> };
    (@parts $function:ident $($parameter:ident)+) => {
        (Tangent<$function>, $($parameter::Tangent),+)
    };
    (@cotangents $captured:ident) => { $captured };
    (@cotangents $captured:ident $($argument:ident)+) => { ($captured, $($argument),+) };
}

arities! {
    call_0 call_0_vjp call_0_jvp ();
    call_1 call_1_vjp call_1_jvp (a a_dot A);
    call_2 call_2_vjp call_2_jvp (a a_dot A, b b_dot B);
    call_3 call_3_vjp call_3_jvp (a a_dot A, b b_dot B, c c_dot C);
    call_4 call_4_vjp call_4_jvp (a a_dot A, b b_dot B, c c_dot C, d d_dot D);
}
