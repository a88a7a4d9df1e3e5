//! The reverse pass: from cotangents of radiance to a gradient.
//!
//! For each group of lanes the radiance, the cotangents that the caller's loss gives it, and the
//! pullbacks follow each other, so that a gradient takes one pass. The [`chain`] walks the path of a
//! tile backwards and calls the pullbacks of [`transport`](crate::transport), which the compiler
//! wrote; [`scatter`] adds what they return to sums in double precision. Everything here is linear:
//! it moves numbers, and holds no mathematics. A [request](request) says which parameters are
//! differentiated by; cotangents of others are not added up, and geometry that is not asked for has
//! no pullback.
//!
//! The loop over the depth of a path is written by hand on purpose: the functions of transport are free
//! of loops, so the residuals of their pullbacks stay in registers and on the stack, and what a path
//! has to remember is its wavefronts, which are reused from tile to tile.

mod boundary;
mod chain;
mod edges;
mod gradient;
mod normal_map;
mod occluder;
mod range;
mod reduce;
mod request;
mod scatter;
mod scattered;
mod scattered_edges;
mod selection;
mod sky;
mod smooth;
mod surfaces;

pub(crate) use chain::sweep;
pub use gradient::{Gradient, LossAndGradient};
pub(crate) use range::{Scaled, loss_and_gradient};
pub(crate) use request::Request;
