//! The differentiable renderer proper: scenes, images of them, and their gradients. It reads no files.
//!
//! The crate `renderer` gives out all of this under its own name, beside files, recovery of parameters
//! and the command line. What is here compiles apart from those, so that neither waits for the other.

mod adjoint;
pub mod arithmetic;
mod boundary;
pub mod counts;
pub mod custom;
mod diagnose;
pub mod display;
mod edges;
mod error;
mod image;
pub mod loss;
pub mod memory;
mod number;
mod parallel;
mod primal;
pub mod render;
pub mod scene;
pub mod settings;
// For the example that compares with a tape at run time.
#[doc(hidden)]
pub mod tape;
// For benches and tests of traversal; scenes are rendered through `render`.
#[doc(hidden)]
pub mod trace;
pub mod transport;

pub use glam;

pub use arithmetic::{Arithmetic, Precision};
#[doc(hidden)]
pub use error::one_line;
pub use error::{Error, ErrorKind};
pub use image::Image;
pub use loss::{ImageLoss, LossKind, PixelLoss};
pub use render::{
    Gradient, LossAndGradient, NonFinite, Renderer, loss_and_gradient, render, render_jvp,
    render_vjp,
};
pub use scene::*;
pub use settings::{Edges, Pass, PrimaryVisibility, Samples, Sampling, Settings};
