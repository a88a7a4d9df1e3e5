//! From a scene to radiance, and from cotangents of radiance back to a gradient.
//!
//! The image is cut into tiles of 8 x 8 pixels, whose rays are traced as one packet, and into strips
//! of tiles side by side. Strips are worked on in parallel, and what they bring is put together in
//! their order, so that images, losses and gradients are the same bit for bit on any number of
//! threads. A gradient takes one pass: for each group of pixels the radiance, the cotangents that the
//! caller's loss gives it, and the pullbacks follow each other.
//!
//! From the camera to the sums a pixel stays in the lane that its ray has in the packet, and a mask
//! says which lanes count. Turned down: moving the pixels that show something together. It fills the
//! lanes better at silhouettes, but taking single pixels out of lanes and putting them into others
//! took longer than tracing and shading them (27 ms instead of 9 on one thread, for a teapot of
//! 512 x 512 pixels). What lanes share, such as the triangle that neighbours show, is fetched once,
//! and what flows back to it is added once (`sharing`); sums by vertex, material and sphere are kept
//! sparse (`sums`), so that a strip costs what it touches, however large the scene is.

mod cause;
mod crossings;
mod custom;
mod gradient;
mod mirrors;
mod non_finite;
#[cfg(feature = "files")]
mod paths;
mod prepared;
mod radiance;
mod range;
mod raster;
mod sampling;
mod settings;
mod shade;
mod shadows;
mod sharing;
mod sums;
mod sweep;
mod textures;
mod tiles;
mod trace;
mod transparency;
mod vertices;
mod view;

pub use gradient::{Gradient, GradientResult, Wanted, gradient};
pub use non_finite::{NonFinite, find_non_finite, find_non_finite_radiance, gradient_of_finite};
pub use prepared::Prepared;
pub use radiance::{PixelLoss, loss, render, render_into};
pub use sampling::{GradientSamples, Samples, Sampling};
pub use settings::{Pass, RenderSettings, Visibility};
pub use trace::trace;

#[cfg(feature = "files")]
pub(crate) use paths::paths;
#[cfg(feature = "cli")]
pub(crate) use {
    crossings::Crossing, gradient::reduce, paths::Path, paths::Reached, sweep::sweep,
    textures::Texture,
};
