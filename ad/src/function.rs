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
//! The object owns what it captures, so passing a closure costs a copy of that; and each call of it
//! gathers the cotangent of all that it captures, as each call of a function does of what is passed
//! to it. References cannot stay: a pullback may outlive the variables that the closure was written
//! beside, and on stable Rust its type holds that of the closure, lifetimes included.
//!
//! Turned down: writing the function out at each call (its body is not known there, nor is a
//! function that calls itself ever written out); passing the captured variables on as further
//! arguments (their number is no part of a generic function's type); a boxed closure (an allocation
//! for each call of it).

use core::marker::PhantomData;

use crate::{Additive, Differentiable, Tangent};

/// A parameter of a function, by value or by reference.
pub trait Parameter {
    /// What is passed.
    type Of<'a>;
    /// The cotangent of it.
    type Tangent: Additive;
}

/// A parameter of type `T`.
pub struct Value<T>(PhantomData<T>);

/// A parameter of type `&T`.
pub struct Reference<T: ?Sized>(PhantomData<T>);

impl<T: Differentiable> Parameter for Value<T> {
    type Of<'a> = T;
    type Tangent = Tangent<T>;
}

impl<T: Differentiable + ?Sized + 'static> Parameter for Reference<T> {
    type Of<'a> = &'a T;
    type Tangent = Tangent<T>;
}

/// The parameters of a function: a tuple of [`Value`]s and [`Reference`]s.
pub trait Parameters {
    /// What is passed: the tuple of it.
    type Of<'a>;
    /// The cotangents of it.
    type Tangents;
}

/// A function that can be differentiated by its arguments and by what it captures.
#[diagnostic::on_unimplemented(
    message = "this function has no derivative that `#[differentiable]` could pass on",
    label = "has to be a closure that a differentiable function passes",
    note = "write a closure where the function is called, in place of its name: `|x: f64| f(x)`",
    note = "pass a closure by value, not `&f`, where the function called takes it by value",
    note = "from code without derivatives, call a `#[differentiable]` function that passes the closure"
)]
pub trait DifferentiableFn<Args: Parameters>: Differentiable + Clone {
    /// What it returns.
    type Output: Differentiable;

    /// From the cotangent of the result to those of what is captured and of the arguments.
    type Pullback: FnOnce(Tangent<Self::Output>) -> (Tangent<Self>, Args::Tangents);

    /// The value.
    fn call(&self, arguments: Args::Of<'_>) -> Self::Output;

    /// The value and the pullback.
    fn call_vjp(&self, arguments: Args::Of<'_>) -> (Self::Output, Self::Pullback);
}

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

#[diagnostic::do_not_recommend]
impl<Args, T, F, R, P> DifferentiableFn<Args> for Closure<T, F>
where
    Args: Parameters,
    T: Additive,
    F: Clone + for<'a> Fn(bool, Args::Of<'a>) -> (R, Option<P>),
    R: Differentiable,
    P: FnOnce(Tangent<R>) -> (T, Args::Tangents),
{
    type Output = R;
    type Pullback = P;

    #[inline(always)]
    fn call(&self, arguments: Args::Of<'_>) -> R {
        (self.function)(false, arguments).0
    }

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
    /// Those of what is captured.
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

macro_rules! arities {
    ($($call:ident $call_vjp:ident ($($argument:ident $parameter:ident),*);)*) => {$(
        impl<$($parameter: Parameter),*> Parameters for ($($parameter,)*) {
            type Of<'a> = ($($parameter::Of<'a>,)*);
            type Tangents = ($($parameter::Tangent,)*);
        }

        /// The value of a function for these arguments.
        #[doc(hidden)]
        #[inline(always)]
        #[allow(clippy::extra_unused_lifetimes, reason = "used where there are arguments")]
        pub fn $call<'a, F: DifferentiableFn<($($parameter,)*)>, $($parameter: Parameter),*>(
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
                let (captured, ($($argument,)*)) = pullback(cotangent);
                arities!(@cotangents captured $($argument)*)
            })
        }
    )*};
    (@parts $function:ident) => { Tangent<$function> };
    (@parts $function:ident $($parameter:ident)+) => {
        (Tangent<$function>, $($parameter::Tangent),+)
    };
    (@cotangents $captured:ident) => { $captured };
    (@cotangents $captured:ident $($argument:ident)+) => { ($captured, $($argument),+) };
}

arities! {
    call_0 call_0_vjp ();
    call_1 call_1_vjp (a A);
    call_2 call_2_vjp (a A, b B);
    call_3 call_3_vjp (a A, b B, c C);
    call_4 call_4_vjp (a A, b B, c C, d D);
}
