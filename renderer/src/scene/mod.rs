//! What is rendered: a continuous part ([`Parameters`]) and a discrete one (names, triangles, who
//! wears which material).
//!
//! The two are kept apart because a gradient has the shape of the continuous part alone, and one set of
//! paths reaches into both. Values are `f64`
//! whatever the renderer computes in, so that small steps of an optimiser are not lost.

use glam::DVec3;

use crate::kernels::camera::Camera;

mod custom;
mod framing;
mod lookup;
mod parameters;
mod texture;
mod validate;

pub use custom::{CustomLight, CustomLightObject, CustomShape, CustomShapeObject};
pub use parameters::{Differentiability, Light, ParameterId, Parameters};
pub use texture::{MaterialObject, MaterialTextures, TextureObject, Wrap};
pub use validate::Invalid;
#[cfg(feature = "files")]
pub(crate) use validate::LARGEST_EXPONENT;
#[cfg(feature = "files")]
pub(crate) use validate::MOST_PIXELS;

/// How many mirrors and transparent surfaces light meets at most, if a scene file does not say.
pub(crate) const DEFAULT_BOUNCES: u32 = 4;

/// A scene, complete: it needs no file to be rendered.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// The width of the image in pixels.
    pub width: u32,
    /// The height of the image in pixels.
    pub height: u32,
    /// How many mirrors and transparent surfaces light meets on its way to the camera at most.
    pub bounces: u32,
    /// Everything continuous.
    pub parameters: Parameters,
    /// The names of `parameters.lights`.
    pub light_names: Vec<String>,
    /// One entry for each of `parameters.materials`.
    pub materials: Vec<MaterialObject>,
    /// One entry for each of `parameters.textures`.
    pub textures: Vec<TextureObject>,
    /// One entry for each of `parameters.spheres`.
    pub spheres: Vec<SphereObject>,
    /// One entry for each of `parameters.vertices`.
    pub meshes: Vec<MeshObject>,
    /// One entry for each of `parameters.shapes`. Scene files do not know them.
    pub shapes: Vec<CustomShapeObject>,
    /// One entry for each of `parameters.custom_lights`. Scene files do not know them.
    pub custom_lights: Vec<CustomLightObject>,
}

impl Scene {
    /// A scene of one black pixel: nothing stands before the camera, which looks from +z to the origin.
    /// To be filled.
    pub fn empty() -> Self {
        let camera = Camera {
            look_from: DVec3::Z,
            look_at: DVec3::ZERO,
            up: DVec3::Y,
            vfov: 45.0,
            focus: 1.0,
        };
        let parameters = Parameters {
            camera,
            lights: Vec::new(),
            materials: Vec::new(),
            opacities: Vec::new(),
            spheres: Vec::new(),
            vertices: Vec::new(),
            texture_coordinates: Vec::new(),
            textures: Vec::new(),
            shapes: Vec::new(),
            custom_lights: Vec::new(),
        };
        Self {
            width: 1,
            height: 1,
            bounces: DEFAULT_BOUNCES,
            parameters,
            light_names: Vec::new(),
            materials: Vec::new(),
            textures: Vec::new(),
            spheres: Vec::new(),
            meshes: Vec::new(),
            shapes: Vec::new(),
            custom_lights: Vec::new(),
        }
    }
}

/// The discrete part of a sphere.
#[derive(Clone, Debug, PartialEq)]
pub struct SphereObject {
    /// Its name, unique among spheres.
    pub name: String,
    /// Index of its material.
    pub material: u32,
}

/// The discrete part of a triangle mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshObject {
    /// Its name, unique among meshes.
    pub name: String,
    /// Three indices into the mesh's vertices for each triangle.
    pub triangles: Vec<[u32; 3]>,
    /// The index of each triangle's material.
    pub materials: Vec<u32>,
    /// For each triangle three indices into the mesh's texture coordinates, if it has any; empty if
    /// no triangle has.
    pub texture_triangles: Vec<Option<[u32; 3]>>,
}
