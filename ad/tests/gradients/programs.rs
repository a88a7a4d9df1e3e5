//! Programs as people write them, without a thought of this crate.

#![allow(
    clippy::needless_borrows_for_generic_args,
    clippy::needless_range_loop,
    clippy::excessive_precision,
    clippy::manual_memcpy,
    clippy::ptr_arg,
    clippy::unreadable_literal,
    reason = "these are the forms that people use"
)]

mod bar;
mod bodies;
mod distances;
mod filters;
mod geometry;
mod kalman;
mod layers;
mod markets;
mod methods;
mod networks;
mod perceptron;
mod pieces;
mod planets;
mod poses;
mod pricer;
mod recipes;
mod roots;
mod sequences;
mod solvers;
mod spline;
mod springs;
mod statistics;
