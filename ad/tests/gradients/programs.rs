//! Programs as people write them, without a thought of this crate.

#![allow(
    clippy::needless_range_loop,
    clippy::excessive_precision,
    clippy::manual_memcpy,
    clippy::ptr_arg,
    clippy::unreadable_literal,
    reason = "these are the forms that people use"
)]

mod geometry;
mod methods;
mod networks;
mod poses;
mod recipes;
mod solvers;
mod statistics;
