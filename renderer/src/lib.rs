//! A differentiable ray tracer.
//!
//! Data flows one way: command line -> optimise -> integrator -> (kernels, acceleration structure,
//! scene). Nothing below the integrator knows that an image exists; nothing below `optimize`
//! knows that a loss exists.

pub mod acceleration;
pub mod atomic_file;
pub mod cli;
pub mod demo;
mod error;
pub mod experiment;
pub mod files;
pub mod image;
pub mod integrator;
pub mod kernels;
pub mod loss;
pub mod optimize;
pub mod precision;
pub mod recovery;
pub mod scene;

pub use error::Error;
