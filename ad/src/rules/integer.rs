//! The rules of the methods of integers, which carry no derivative.
//!
//! Generated code does not always know an integer from a number: a pattern that takes a pair apart
//! does not tell.

use super::linear::Zero;
use super::row::rules;
use crate::Differentiable;

/// A type without a derivative.
pub trait Integer: Copy + Differentiable<Tangent = ()> {}

impl<T: Copy + Differentiable<Tangent = ()>> Integer for T {}

rules! {
    /// The rules of the methods of integers.
    IntegerRules: Integer for u8 u16 u32 u64 u128 usize i8 i16 i32 i64 i128 isize {
        min(x, other) => (Zero(), Zero());
        max(x, other) => (Zero(), Zero());
        clamp(x, low, high) => (Zero(), Zero(), Zero());
        pow(x, exponent: u32) -> Self => (Zero(), Zero());
        div_euclid(x, other) => (Zero(), Zero());
        rem_euclid(x, other) => (Zero(), Zero());
        saturating_add(x, other) => (Zero(), Zero());
        saturating_sub(x, other) => (Zero(), Zero());
        saturating_mul(x, other) => (Zero(), Zero());
        wrapping_add(x, other) => (Zero(), Zero());
        wrapping_sub(x, other) => (Zero(), Zero());
        wrapping_mul(x, other) => (Zero(), Zero());
    }
}

rules! {
    /// The rules of the methods of integers with a sign.
    SignedRules: Integer for i8 i16 i32 i64 i128 isize {
        abs(x) => Zero();
        signum(x) => Zero();
    }
}
