//! A differentiable ray tracer: recovers lights, materials, cameras and shapes from images.
//!
//! Data flows one way: command line ([`cli`]) -> [`recovery`] -> [`optimize`] and [`integrator`] ->
//! [`kernels`], [`acceleration`], [`scene`]. Nothing below the integrator knows that an image
//! exists; nothing below recovery knows which loss is minimised; the optimiser knows nothing of
//! images at all.
//!
//! To start from Rust, see [`recovery`]; the scene file is described in [`experiment`].
//!
//! Kernels run on SIMD lanes. Building with `-C target-cpu=native` lets the compiler use the widest
//! instructions of the machine; this repository does, a crate that depends on this one has to say
//! so itself.

pub mod acceleration;
#[cfg(feature = "files")]
pub mod accuracy;
pub mod arithmetic;
#[cfg(feature = "files")]
pub mod atomic_file;
#[cfg(feature = "cli")]
pub mod cli;
pub mod counts;
#[cfg(feature = "files")]
pub mod demo;
pub mod display;
mod error;
#[cfg(feature = "files")]
pub mod experiment;
pub mod extremes;
#[cfg(feature = "files")]
pub mod files;
pub mod image;
pub mod integrator;
pub mod kernels;
pub mod loss;
#[cfg(feature = "files")]
pub mod optimize;
#[cfg(feature = "cli")]
pub mod palette;
pub mod precision;
#[cfg(feature = "files")]
pub mod recovery;
#[cfg(feature = "cli")]
pub mod report;
pub mod scene;
#[cfg(feature = "cli")]
pub mod tradeoff;

pub use error::Error;
