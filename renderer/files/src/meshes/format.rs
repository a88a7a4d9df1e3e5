//! The formats of mesh files, and what is read of them.

use std::path::Path;

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

/// Whether the normals of vertices that a mesh file holds are read. Where they are not, they are not
/// checked either: many files hold broken ones that nothing has ever shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileNormals {
    /// Meshes are flat.
    Ignore,
    /// Meshes have the normals of the file; triangles for which it has none are flat.
    Read,
}

/// Whether the objects of an OBJ file, which share the vertices of the file, are meshes of their own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileObjects {
    /// Each is a mesh with vertices of its own.
    Apart,
    /// All are one mesh, which has each vertex as often as the file.
    Joined,
}
