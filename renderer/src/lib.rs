//! A differentiable ray tracer.
//!
//! Data flows one way: command line -> optimise -> integrator -> (kernels, acceleration structure,
//! scene). Nothing below the integrator knows that an image exists; nothing below `optimize`
//! knows that a loss exists.

pub mod atomic_file;
mod error;
pub mod image;
pub mod kernels;
pub mod optimize;
pub mod scene;

pub use error::Error;
