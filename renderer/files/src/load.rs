//! Mesh files of every format.

use std::path::Path;

use renderer_core::Error;

use super::meshes::{FileNormals, FileObjects, MeshFormat, Model};
use super::obj::read_obj;

/// Reads a mesh file: OBJ, PLY, STL or glTF, as its extension says. Its meshes are flat.
///
/// # Errors
///
/// If the extension is another one, the format is one that this build leaves out, or the file is
/// refused by its format: [`load_obj`](super::load_obj), `load_ply`, `load_stl`, `load_gltf`.
pub fn load_mesh(path: &Path) -> Result<Model, Error> {
    load_mesh_with(path, FileNormals::Ignore, FileObjects::Apart)
}

/// [`load_mesh`], with the normals of the file if they are wanted, and with its objects as meshes or as one. STL files have
/// no normals of vertices; what holds several meshes that is no OBJ file has vertices of its own in each.
///
/// # Errors
///
/// As [`load_mesh`], and if a normal that is read is not finite, is zero, or is missing.
pub fn load_mesh_with(
    path: &Path,
    normals: FileNormals,
    objects: FileObjects,
) -> Result<Model, Error> {
    let format = MeshFormat::of(path).ok_or_else(|| {
        Error::new(path.display(), "is no mesh file: one of .obj, .ply, .stl, .gltf, .glb")
    })?;
    match format {
        MeshFormat::Obj => read_obj(path, normals, objects),
        #[cfg(feature = "ply")]
        MeshFormat::Ply => super::ply::read_ply(path, normals),
        #[cfg(feature = "stl")]
        MeshFormat::Stl => super::stl::load_stl(path),
        #[cfg(feature = "gltf")]
        MeshFormat::Gltf => super::gltf::read_gltf(path, normals).map(|file| file.model),
        #[cfg(not(all(feature = "ply", feature = "stl", feature = "gltf")))]
        _ => Err(left_out(path, format)),
    }
}

/// The error of a format that this build does not read.
#[cfg(not(all(feature = "ply", feature = "stl", feature = "gltf")))]
pub(crate) fn left_out(path: &Path, format: MeshFormat) -> Error {
    let feature = format!("{format:?}").to_ascii_lowercase();
    let problem =
        format!("this build reads no {feature} files; build it with the feature `{feature}`");
    Error::new(path.display(), problem)
}
