//! `#[differentiable]` on `impl` blocks of traits of the standard library, for types of one's own.

pub mod accumulation;
pub mod element;
pub mod hidden;
pub mod operator;
