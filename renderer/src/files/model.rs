//! What every mesh file gives.

use std::path::PathBuf;
use std::sync::Arc;

use glam::{DAffine2, DVec3};

use super::Warning;
use crate::kernels::material::Material;
use crate::scene::Wrap;

/// The name of the material of faces that their file gives none.
pub const DEFAULT_MATERIAL: &str = "default";

/// A grey, matt material: ambient 0, diffuse 0.7, specular 0, exponent 1, no mirror. Also what a material
/// library leaves open.
pub fn default_material() -> Material<f64> {
    Material {
        ambient: DVec3::ZERO,
        diffuse: DVec3::splat(0.7),
        specular: DVec3::ZERO,
        exponent: 1.0,
        reflection: DVec3::ZERO,
    }
}

/// What a mesh file holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    /// Its objects, one mesh each; at least one.
    pub meshes: Vec<Mesh>,
    /// Its materials in the order of their first use.
    pub materials: Vec<ModelMaterial>,
    /// What was left out of it and of the files that it names: one for each file and kind of
    /// statement.
    pub warnings: Vec<Warning>,
}

/// A triangle mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    /// Its name, unique within its model.
    pub name: String,
    /// Its vertices, in the order in which its triangles first use them.
    pub vertices: Vec<[f64; 3]>,
    /// Three indices into `vertices` for each triangle.
    pub triangles: Vec<[u32; 3]>,
    /// For each triangle an index into the model's materials.
    pub materials: Vec<u32>,
    /// Its texture coordinates, in the order in which its triangles first use them: to the right and
    /// upwards, as [`triangle_uv`](crate::kernels::texture::triangle_uv()) takes them.
    pub texture_coordinates: Vec<[f64; 2]>,
    /// For each triangle three indices into `texture_coordinates`, if it has any; empty if no
    /// triangle has.
    pub texture_triangles: Vec<Option<[u32; 3]>>,
}

/// A material of a model.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelMaterial {
    /// Its name, unique within its model.
    pub name: String,
    /// Its numbers; or that the files do not say, to be warned of unless a scene file does. What stands
    /// in for them is the [default material](default_material).
    pub material: Result<Material<f64>, Warning>,
    /// Its opacity, if it is transparent.
    pub opacity: Option<f64>,
    /// The textures of its colours and of its opacity.
    pub maps: ModelMaps,
}

/// The textures of a material's colours and of its opacity.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ModelMaps {
    /// That of `ambient`.
    pub ambient: Option<TextureSource>,
    /// That of `diffuse`.
    pub diffuse: Option<TextureSource>,
    /// That of `specular`.
    pub specular: Option<TextureSource>,
    /// That of the opacity.
    pub opacity: Option<TextureSource>,
    /// From the texture coordinates of the mesh to those at which the textures are looked up.
    pub placement: DAffine2,
}

/// A texture of a model.
#[derive(Clone, Debug, PartialEq)]
pub struct TextureSource {
    /// Where its texels are.
    pub image: TextureImage,
    /// What of them counts.
    pub channel: Channel,
    /// How it goes on beyond its edges.
    pub wrap: Wrap,
    /// The file, and the line or the part of it that names the texture.
    pub place: String,
}

/// What of an image a texture shows.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Channel {
    /// Its colours, whatever covers them.
    #[default]
    Color,
    /// How much its alpha covers; everything, where it has none. Where there is a cutoff, alpha from there
    /// on covers all, and nothing below.
    Alpha {
        /// See above.
        cutoff: Option<f64>,
    },
    /// Its alpha, or, where it has none, its brightness as it is stored: a mask.
    Mask,
}

/// An image that has not been read yet.
#[derive(Clone, Debug, PartialEq)]
pub enum TextureImage {
    /// An image file.
    File(PathBuf),
    /// An image file within the mesh file.
    Embedded {
        /// Its name, which may be empty.
        name: String,
        /// The bytes of the image file.
        bytes: Arc<[u8]>,
    },
}
