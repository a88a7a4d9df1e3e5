//! Files of meshes, images and cameras, read and written. Nothing here renders.
//!
//! The crate `renderer` gives out all of this as `renderer::files`, beside scene files, which know what is
//! to be recovered. What is here compiles apart from those: it runs over every byte of large files, and is
//! optimised as kernels are.
//!
//! Reading checks everything: what leaves this crate is finite, in range and consistent. What a file
//! holds that nothing here shows comes back as a [`Warning`]. Writing is atomic: a reader finds the
//! old file or the new one, never half of one.

mod cameras;
// For what `renderer` writes: scene files, checkpoints and reports.
#[doc(hidden)]
pub mod disk;
mod export;
#[cfg(feature = "gltf")]
mod gltf;
pub mod images;
mod load;
mod meshes;
// For the objects and files of scene files.
#[doc(hidden)]
pub mod names;
mod obj;
#[cfg(feature = "ply")]
mod ply;
#[cfg(feature = "stl")]
mod stl;
mod warning;

pub use cameras::{FoundView, load_cameras, save_cameras};
pub use export::save_meshes;
#[cfg(feature = "gltf")]
pub use gltf::{GltfFile, load_gltf};
#[doc(hidden)]
pub use images::png::png_bytes;
pub use images::{
    LoadedImage, check_image_path, load_image, load_mask, load_pass, save_exr, save_hdr,
    save_image, save_passes, save_png,
};
pub use load::{load_mesh, load_mesh_with};
pub use meshes::{
    Channel, DEFAULT_MATERIAL, FileNormals, FileObjects, FullMaterial, MeshFormat, Model,
    ModelMaps, ModelMaterial, TextureImage, TextureSource,
};
pub use obj::{load_obj, save_obj};
#[cfg(feature = "ply")]
pub use ply::load_ply;
#[cfg(feature = "stl")]
pub use stl::load_stl;
pub use warning::Warning;
#[doc(hidden)]
pub use warning::Warnings;
