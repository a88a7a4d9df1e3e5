//! Derivatives of `core::mem::{swap, replace, take}`.
//!
//! The pullbacks take the cotangents of what the places hold afterwards, and return those of what
//! they held before.

#![allow(non_camel_case_types)]

use crate::{Differentiable, Tangent};

/// The derivative of `core::mem::swap`.
pub enum swap {}

impl swap {
    /// The cotangents change places too.
    #[inline(always)]
    pub fn vjp<T: Differentiable>(
        a: &mut T,
        b: &mut T,
    ) -> ((), impl FnOnce((), Tangent<T>, Tangent<T>) -> (Tangent<T>, Tangent<T>) + use<T>) {
        core::mem::swap(a, b);
        ((), |(), a, b| (b, a))
    }

    /// The tangents change places too.
    #[inline(always)]
    pub fn jvp<T: Differentiable>(
        a: &mut T,
        b: &mut T,
        a_dot: &mut Tangent<T>,
        b_dot: &mut Tangent<T>,
    ) -> ((), ()) {
        core::mem::swap(a, b);
        core::mem::swap(a_dot, b_dot);
        ((), ())
    }
}

/// The derivative of `core::mem::replace`.
pub enum replace {}

impl replace {
    /// The pullback: what was there gets the cotangent of the result, the new value that of the place.
    #[inline(always)]
    pub fn vjp<T: Differentiable>(
        place: &mut T,
        value: T,
    ) -> (T, impl FnOnce(Tangent<T>, Tangent<T>) -> (Tangent<T>, Tangent<T>) + use<T>) {
        (core::mem::replace(place, value), |before, after| (before, after))
    }

    /// The tangent of what was there; that of the new value takes its place.
    #[inline(always)]
    pub fn jvp<T: Differentiable>(
        place: &mut T,
        value: T,
        place_dot: &mut Tangent<T>,
        value_dot: Tangent<T>,
    ) -> (T, Tangent<T>) {
        (core::mem::replace(place, value), core::mem::replace(place_dot, value_dot))
    }
}

/// The derivative of `core::mem::take`.
pub enum take {}

impl take {
    /// The pullback: what was there gets the cotangent of the result.
    #[inline(always)]
    pub fn vjp<T: Differentiable + Default>(
        place: &mut T,
    ) -> (T, impl FnOnce(Tangent<T>, Tangent<T>) -> Tangent<T> + use<T>) {
        (core::mem::take(place), |before, _| before)
    }

    /// The tangent of what was there.
    #[inline(always)]
    pub fn jvp<T: Differentiable + Default>(
        place: &mut T,
        place_dot: &mut Tangent<T>,
    ) -> (T, Tangent<T>) {
        let value = core::mem::take(place);
        (value, core::mem::replace(place_dot, crate::rt::zero_like(place)))
    }
}
