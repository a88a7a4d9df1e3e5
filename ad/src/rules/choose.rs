//! Functions of this crate with a twin written by hand: choosing, and cutting a derivative.

use crate::{Additive, Differentiable, Select, Tangent};

/// `if_true` where `mask` holds, else `if_false`.
///
/// Both are computed before the choice. The cotangent goes to the chosen one alone, and the other
/// one's computation gets a zero that no infinite or NaN partial derivative can spoil
/// (see [singular points](crate::rules#singular-points)).
///
/// ```
/// use ad::{differentiable, select};
///
/// #[differentiable]
/// fn entropy(p: f64) -> f64 {
///     select(p > 0.0, -p * p.ln(), 0.0)
/// }
///
/// assert_eq!(entropy::value_and_grad(0.0), (0.0, 0.0));
/// assert_eq!(entropy::grad(1.0), -1.0);
/// ```
#[inline(always)]
pub fn select<T: Select>(mask: T::Mask, if_true: T, if_false: T) -> T {
    T::select(mask, if_true, if_false)
}

/// The derivative of the function [`select`](fn@select).
#[allow(non_camel_case_types)]
pub enum select {}

impl select {
    /// The path of the function.
    #[doc(hidden)]
    pub fn named() -> &'static str {
        core::any::type_name::<Self>()
    }

    /// The value, and the pullback to mask, `if_true` and `if_false`.
    #[inline(always)]
    pub fn vjp<T>(
        mask: T::Mask,
        if_true: T,
        if_false: T,
    ) -> (T, impl FnOnce(Tangent<T>) -> ((), Tangent<T>, Tangent<T>))
    where
        T: Select + Differentiable<Tangent: Select<Mask = T::Mask>>,
    {
        (T::select(mask, if_true, if_false), move |cotangent| {
            let zero = <Tangent<T>>::zero();
            ((), Select::select(mask, cotangent, zero), Select::select(mask, zero, cotangent))
        })
    }

    /// The value, and the tangent of the chosen one.
    #[inline(always)]
    pub fn jvp<T>(
        mask: T::Mask,
        if_true: T,
        if_false: T,
        _: (),
        if_true_dot: Tangent<T>,
        if_false_dot: Tangent<T>,
    ) -> (T, Tangent<T>)
    where
        T: Select + Differentiable<Tangent: Select<Mask = T::Mask>>,
    {
        (T::select(mask, if_true, if_false), Select::select(mask, if_true_dot, if_false_dot))
    }
}

/// The value of `f`, as a constant: no derivative passes. Inside of a differentiable function the
/// closure may hold any Rust, also what cannot be differentiated; it may read the variables around
/// it and change none.
///
/// ```
/// use ad::{differentiable, no_diff};
///
/// #[differentiable]
/// fn f(x: f64) -> f64 {
///     let digits = no_diff(|| format!("{x:.0}", x = x).len());
///     x * x * digits as f64
/// }
///
/// assert_eq!(f::value_and_grad(12.0), (288.0, 48.0));
/// ```
#[inline(always)]
pub fn no_diff<R, F: Fn() -> R>(f: F) -> R {
    f()
}

/// `x`, as a constant: no derivative passes. The way to say that a cast to an integer, a
/// comparison or a part of a formula is meant not to be differentiated.
#[inline(always)]
pub fn stop_gradient<T>(x: T) -> T {
    x
}
