//! Exact gradients of ordinary Rust functions, written at compile time.
extern crate self as ad;

pub mod check;
mod differentiable;
mod dual;
mod real;
#[doc(hidden)]
pub mod rt;
pub mod rules;
pub mod vector;

pub use ad_macros::{Differentiable, differentiable};
pub use differentiable::{Additive, Differentiable, NoDerivative, NoTangent, Tangent};
pub use dual::Dual;
pub use real::{Mask, Real, Scalar, Select};
pub use rules::{select, stop_gradient};

/// The vector of three scalars `S`.
pub type Vec3<S> = <S as Real>::Vec3;
