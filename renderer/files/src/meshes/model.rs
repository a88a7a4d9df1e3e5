//! What every mesh file gives.

use std::path::PathBuf;
use std::sync::Arc;

use glam::DAffine2;
use renderer_core::scene::{MaterialObject, Mesh, Slot, Wrap};

use crate::Warning;

/// The name of the material of faces that their file gives none.
pub const DEFAULT_MATERIAL: &str = "default";

/// What a mesh file holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    /// Its objects, one mesh each; at least one. Vertices and texture coordinates are in the order in which
    /// triangles first use them, materials are indices into those of the model.
    pub meshes: Vec<Mesh>,
    /// The materials of the file, in the order of their first use.
    pub materials: Vec<ModelMaterial>,
    /// What was left out of it and of the files that it names: one for each file and kind of
    /// statement.
    pub warnings: Vec<Warning>,
}

/// A material of a model.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelMaterial {
    /// The name of the material, unique within its model.
    pub name: String,
    /// Its numbers, without textures; or that the files do not say, to be warned of unless a scene file
    /// does. What stands in for them is the default material.
    pub material: Result<MaterialObject, Warning>,
    /// What it is where light takes all paths, if that is more.
    pub full: Option<FullMaterial>,
    /// The textures of its numbers.
    pub maps: ModelMaps,
}

/// A material that only light shows which takes all paths: where it comes straight from lights, metals and
/// glass would be black.
#[derive(Clone, Debug, PartialEq)]
pub struct FullMaterial {
    /// Its type and numbers, without textures.
    pub material: MaterialObject,
    /// What is left out of it elsewhere.
    pub left_out: Option<Warning>,
}

/// The textures of a material's numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ModelMaps {
    /// The texture of each number that one varies, by [`Slot`].
    pub sources: [Option<TextureSource>; Slot::ALL.len()],
    /// Maps the texture coordinates of the mesh to those at which the textures are looked up.
    pub placement: DAffine2,
}

impl ModelMaps {
    /// The texture of a slot.
    pub fn get(&self, slot: Slot) -> Option<&TextureSource> {
        self.sources[slot as usize].as_ref()
    }
}

/// A texture of a model.
#[derive(Clone, Debug, PartialEq)]
pub struct TextureSource {
    /// Where the texels are.
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
    /// Its channels as they are stored: numbers, and no colours.
    Data,
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
