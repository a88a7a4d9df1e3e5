//! Files: images, meshes and scenes, read and written.
//!
//! Reading checks everything: what leaves this room is finite, in range and consistent. What a file
//! holds that nothing here shows comes back as a [`Warning`]. Writing is atomic: a reader finds the
//! old file or the new one, never half of one.

mod cameras;
mod export;
#[cfg(feature = "gltf")]
mod gltf;
pub mod images;
mod load;
mod meshes;
mod names;
mod obj;
#[cfg(feature = "ply")]
mod ply;
mod png;
#[cfg(test)]
mod robustness;
mod scene_file;
#[cfg(feature = "stl")]
mod stl;

pub use crate::warning::Warning;
pub use cameras::{FoundView, load_cameras, save_cameras};
pub use export::save_meshes;
#[cfg(feature = "gltf")]
pub use gltf::{GltfFile, load_gltf};
pub use images::{
    LoadedImage, check_image_path, load_image, load_mask, load_pass, save_exr, save_hdr,
    save_image, save_passes, save_png,
};
pub use load::{load_mesh, load_mesh_with};
pub use meshes::{
    DEFAULT_MATERIAL, FileNormals, FullMaterial, MeshFormat, Model, ModelMaps, ModelMaterial,
    TextureImage, TextureSource,
};
#[cfg(feature = "cli")]
pub(crate) use names::file_stems;
pub use obj::{load_obj, save_obj};
#[cfg(feature = "ply")]
pub use ply::load_ply;
#[cfg(feature = "cli")]
pub(crate) use png::png_bytes;
pub use scene_file::{save_experiment, save_scene};
#[cfg(feature = "stl")]
pub use stl::load_stl;
