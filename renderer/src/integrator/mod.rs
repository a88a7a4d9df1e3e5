//! From a scene to radiance, and from cotangents of radiance back to a gradient.
//!
//! The image is cut into tiles of a fixed size. Tiles are worked on in parallel, and what they
//! bring is put together in their order, so that images, losses and gradients are the same bit for
//! bit on any number of threads. A gradient takes one pass: for each pixel the radiance, the
//! cotangent that the caller's loss gives it, and the pullbacks follow each other.

mod gradient;
mod prepared;
mod radiance;
mod shade;
mod shadows;
mod sharing;
mod sums;
mod tiles;
mod trace;
mod view;

pub use gradient::{GradientResult, Wanted, gradient};
pub use prepared::Prepared;
pub use radiance::{PixelLoss, loss, render, render_into};
pub use trace::{Rays, trace};

pub(crate) use gradient::{reduce, sweep};
