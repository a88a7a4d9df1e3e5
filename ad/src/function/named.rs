//! Functions that are passed by their names.

use super::{Callable, DifferentiableFn, ForwardFn, Parameter, Pullback};
use crate::{Differentiable, Tangent};

/// A function that has a name, and its derivative in either mode.
#[derive(Clone, Copy)]
pub struct Named<F, D> {
    function: F,
    derivative: D,
}

/// A function and its derivative.
#[doc(hidden)]
#[inline(always)]
pub fn named<F, D>(function: F, derivative: D) -> Named<F, D> {
    #[cfg(debug_assertions)]
    crate::rt::check_mode_of(&function, &derivative);
    Named { function, derivative }
}

/// It captures nothing.
impl<F, D> Differentiable for Named<F, D> {
    type Tangent = ();
    type Shape = ();

    #[inline(always)]
    fn shape(&self) {}
}

/// The pullback of a function that captures nothing.
pub struct NamedPullback<P>(P);

macro_rules! arities {
    ($(($($argument:ident $dot:ident $parameter:ident),*);)*) => {$(
        #[diagnostic::do_not_recommend]
        impl<F, G, R, $($parameter: Parameter),*> Callable<($($parameter,)*)> for Named<F, G>
        where
            F: Clone + for<'a> Fn($($parameter::Of<'a>),*) -> R,
            G: Clone,
            R: Differentiable,
        {
            type Output = R;

            #[inline(always)]
            fn call<'a>(&self, ($($argument,)*): ($($parameter::Of<'a>,)*)) -> R {
                (self.function)($($argument),*)
            }
        }

        #[diagnostic::do_not_recommend]
        #[allow(unused_parens, reason = "the cotangent of one argument is no tuple")]
        impl<Seed, P, $($parameter),*> Pullback<Seed, (), ($($parameter,)*)> for NamedPullback<P>
        where
            P: FnOnce(Seed) -> ($($parameter),*),
        {
            #[inline(always)]
            fn pull_back(self, cotangent: Seed) -> ((), ($($parameter,)*)) {
                let ($($argument),*) = (self.0)(cotangent);
                ((), ($($argument,)*))
            }
        }

        #[diagnostic::do_not_recommend]
        #[allow(unused_parens, reason = "the cotangent of one argument is no tuple")]
        impl<F, G, R, P, $($parameter: Parameter),*> DifferentiableFn<($($parameter,)*)> for Named<F, G>
        where
            F: Clone + for<'a> Fn($($parameter::Of<'a>),*) -> R,
            G: Clone + for<'a> Fn($($parameter::Of<'a>),*) -> (R, P),
            P: FnOnce(Tangent<R>) -> ($($parameter::Tangent),*),
            R: Differentiable,
        {
            type Pullback = NamedPullback<P>;

            #[inline(always)]
            fn call_vjp<'a>(
                &self,
                ($($argument,)*): ($($parameter::Of<'a>,)*),
            ) -> (R, NamedPullback<P>) {
                let (value, pullback) = (self.derivative)($($argument),*);
                (value, NamedPullback(pullback))
            }
        }

        #[diagnostic::do_not_recommend]
        impl<F, G, R, $($parameter: Parameter),*> ForwardFn<($($parameter,)*)> for Named<F, G>
        where
            F: Clone + for<'a> Fn($($parameter::Of<'a>),*) -> R,
            G: Clone + for<'a> Fn($($parameter::Of<'a>,)* $($parameter::Dot<'a>),*) -> (R, Tangent<R>),
            R: Differentiable,
        {
            #[inline(always)]
            fn call_jvp<'a>(
                &self,
                ($($argument,)*): ($($parameter::Of<'a>,)*),
                ($($dot,)*): ($($parameter::Dot<'a>,)*),
            ) -> (R, Tangent<R>) {
                (self.derivative)($($argument,)* $($dot),*)
            }
        }
    )*};
}

arities! {
    (a a_dot A);
    (a a_dot A, b b_dot B);
    (a a_dot A, b b_dot B, c c_dot C);
    (a a_dot A, b b_dot B, c c_dot C, d d_dot D);
}
