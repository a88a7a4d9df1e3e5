//! The derivative of `drop`.

#![allow(non_camel_case_types)]

use crate::{Additive, Differentiable, Tangent};

/// The derivative of `core::mem::drop`.
#[doc(hidden)]
pub enum drop {}

impl drop {
    /// Nothing flows back.
    #[inline(always)]
    pub fn vjp<T: Differentiable>(value: T) -> ((), impl FnOnce(()) -> Tangent<T> + use<T>) {
        core::mem::drop(value);
        ((), |()| Additive::zero())
    }

    /// The tangent is dropped, too.
    #[inline(always)]
    pub fn jvp<T: Differentiable>(value: T, _tangent: Tangent<T>) -> ((), ()) {
        core::mem::drop(value);
        ((), ())
    }

    /// The path of the function.
    pub fn named() -> &'static str {
        core::any::type_name_of_val(&core::mem::drop::<()>)
    }
}
