//! The rule of `drop`.

#![allow(non_camel_case_types)]

use super::linear::{Linear, Maps};
use super::twin::twins;
use crate::{Additive, Differentiable, Tangent};

twins! {
    /// Nothing flows back, and the tangent is dropped, too.
    drop[T: Differentiable](value: T) -> () = core::mem::drop(value)
        => Maps(|_| (), |()| Additive::zero());
}

impl drop {
    /// The path of the function.
    pub fn named() -> &'static str {
        core::any::type_name_of_val(&core::mem::drop::<()>)
    }
}
