//! What rays meet: discrete, not differentiated, and as fast as it can be.
//!
//! The image is cut into tiles of 8 x 8 pixels, whose rays are traced as one packet, and into
//! strips of tiles side by side. Strips are worked on in parallel, and what they bring is put together
//! in their order, so that images, losses and gradients are the same bit for bit on any number of
//! threads. `sampling` says where within pixels rays go, the [`bvh`] or the rasteriser
//! which primitive they hit first, and whether something is in the way of a light. All of it is
//! `f32` whatever images are computed in.

pub(crate) mod adjacency;
pub mod bvh;
mod corners;
pub(crate) mod emitters;
pub(crate) mod layout;
pub(crate) mod random;
pub(crate) mod raster;
pub(crate) mod sampling;
pub(crate) mod sky;
pub(crate) mod sky_parts;
pub(crate) mod tile;
