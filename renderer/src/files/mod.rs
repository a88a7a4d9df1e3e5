//! Files: images, meshes and scenes, read and written.
//!
//! Reading checks everything: what leaves this room is finite, in range and consistent. Writing is
//! atomic: a reader finds the old file or the new one, never half of one.

pub mod images;
mod io;
pub mod obj;
pub(crate) mod scene_file;

pub use images::{LoadedImage, check_image_path, load_image, save_exr, save_image, save_png};
pub use obj::{Mesh, Model, load_obj, save_obj};
pub use scene_file::{save_experiment, save_scene};
