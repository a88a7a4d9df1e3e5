//! Files: images, meshes, cameras and scenes, read and written.
//!
//! Meshes, images and cameras are the crate `renderer-files`, all of which is given out here. Scene files stand
//! here: they hold what is recovered, and how.
//!
//! Reading checks everything: what leaves this room is finite, in range and consistent. What a file
//! holds that nothing here shows comes back as a [`Warning`]. Writing is atomic: a reader finds the
//! old file or the new one, never half of one.

#[cfg(test)]
mod robustness;
mod scene_file;

#[doc(inline)]
pub use renderer_files::*;
pub use scene_file::{save_experiment, save_scene};
