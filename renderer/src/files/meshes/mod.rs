//! Mesh files of every format.
//!
//! The extension names the format. Each format gives the same thing, a [`Model`]: what a mesh file
//! may be used for does not depend on its format.

#![cfg_attr(
    not(all(feature = "gltf", feature = "ply", feature = "stl")),
    allow(dead_code, unused_imports, reason = "each format takes what it needs")
)]

mod build;
mod polygon;

use std::path::Path;

use super::model::Model;
use super::obj::load_obj;
use crate::Error;

pub(super) use build::{MeshBuilder, default_model, plain_material};
pub(super) use polygon::triangulate;

/// A format of mesh files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshFormat {
    /// Wavefront OBJ.
    Obj,
    /// Polygon File Format (Stanford), ASCII or binary; with the feature `ply`.
    Ply,
    /// Stereolithography, ASCII or binary; with the feature `stl`.
    Stl,
    /// glTF 2.0, `.gltf` or `.glb`; with the feature `gltf`.
    Gltf,
}

impl MeshFormat {
    /// The format that the extension of `path` names, or nothing. It may be one that this build
    /// does not read.
    pub fn of(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?.to_ascii_lowercase();
        match extension.as_str() {
            "obj" => Some(Self::Obj),
            "ply" => Some(Self::Ply),
            "stl" => Some(Self::Stl),
            "gltf" | "glb" => Some(Self::Gltf),
            _ => None,
        }
    }
}

/// Reads a mesh file: OBJ, PLY, STL or glTF, as its extension says.
///
/// # Errors
///
/// If the extension is another one, the format is one that this build leaves out, or the file is
/// refused by its format: [`load_obj`], [`load_ply`](super::load_ply),
/// [`load_stl`](super::load_stl), [`load_gltf`](super::load_gltf).
pub fn load_mesh(path: &Path) -> Result<Model, Error> {
    let format = MeshFormat::of(path).ok_or_else(|| {
        Error::new(path.display(), "is no mesh file: one of .obj, .ply, .stl, .gltf, .glb")
    })?;
    match format {
        MeshFormat::Obj => load_obj(path),
        #[cfg(feature = "ply")]
        MeshFormat::Ply => super::ply::load_ply(path),
        #[cfg(feature = "stl")]
        MeshFormat::Stl => super::stl::load_stl(path),
        #[cfg(feature = "gltf")]
        MeshFormat::Gltf => super::gltf::load_gltf(path).map(|file| file.model),
        #[cfg(not(all(feature = "ply", feature = "stl", feature = "gltf")))]
        _ => Err(left_out(path, format)),
    }
}

/// The error of a format that this build does not read.
#[cfg(not(all(feature = "ply", feature = "stl", feature = "gltf")))]
pub(super) fn left_out(path: &Path, format: MeshFormat) -> Error {
    let feature = format!("{format:?}").to_ascii_lowercase();
    let problem =
        format!("this build reads no {feature} files; build it with the feature `{feature}`");
    Error::new(path.display(), problem)
}
