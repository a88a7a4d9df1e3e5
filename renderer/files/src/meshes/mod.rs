//! What all mesh formats share.
//!
//! The extension names the format. Each format gives the same thing, a [`Model`]: what a mesh file
//! may be used for does not depend on its format.

#![cfg_attr(
    not(all(feature = "gltf", feature = "ply", feature = "stl")),
    allow(dead_code, unused_imports, reason = "each format takes what it needs")
)]

mod build;
mod format;
mod model;
mod polygon;

pub(super) use build::{MeshBuilder, Triangles, check_normal, default_model, plain_material};
pub use format::{FileNormals, FileObjects, MeshFormat};
pub use model::{
    Channel, DEFAULT_MATERIAL, FullMaterial, Model, ModelMaps, ModelMaterial, TextureImage,
    TextureSource,
};
pub(super) use polygon::triangulate;
