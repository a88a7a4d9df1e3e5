//! The forward mode of methods: siblings with the suffix `_jvp`.
//!
//! `x.sqrt_jvp(x_dot)` returns the value, bit for bit that of `x.sqrt()`, and its derivative along
//! `x_dot`; the tangents of receiver and arguments follow the arguments in their order.
//!
//! Few of these are rules of their own. Most functions of scalars, and of vectors element by
//! element, have symmetric Jacobians by each argument: there the derivative along a tangent is the
//! pullback of that tangent, at singular points, too. For a vector to a scalar it is the inner
//! product of the tangent with the pullback of 1. After inlining both are what one would have
//! written. What remains is written out: what is linear or bilinear in vectors.
//!
//! Turned down: a table of pushforwards beside that of pullbacks (two to keep in agreement, with
//! all their singular points); pulling unit vectors back for every function with a vector as result
//! (three pullbacks, and the zeros in them do not vanish from products with numbers that may be
//! infinite).

mod outcome;

pub use outcome::{CopiedForward, FlattenForward, OptionForward, ResultForward};
