//! Scenes: objects that own their names and their numbers.
//!
//! A [`Scene`] holds a camera, lights, materials, textures, spheres, meshes and custom shapes.
//! Objects refer to materials and textures by index; [`add_material`](Scene::add_material) and its
//! siblings return the index and check what they add. Every block of numbers that may vary is a
//! parameter with a [path](ParameterId) such as `light.key.position`; what is known of parameters, their
//! ranges and natural scales and whether they move edges, stands in one table, `scene/table.rs`.
//!
//! ```
//! use glam::DVec3;
//! use renderer::scene::{Material, Mesh, PointLight, Scene};
//! use renderer::Camera;
//!
//! let mut scene = Scene::new(64, 48, Camera::looking(DVec3::new(0.0, 0.0, 4.0), DVec3::ZERO));
//! let paint = scene.add_material("paint", Material::lambertian(DVec3::new(0.8, 0.3, 0.2)))?;
//! let corners = vec![[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]];
//! scene.add_mesh(Mesh::new("roof", corners, vec![[0, 1, 2], [0, 2, 3]]).material(paint))?;
//! let position = DVec3::new(1.0, 2.0, 4.0);
//! scene.add_light("key", PointLight { position, color: DVec3::ONE, radiant_intensity: 60.0 })?;
//! let vertices = scene.parameter("mesh.roof.vertices")?;
//! assert_eq!(scene.get(vertices).len(), 12);
//! # Ok::<(), renderer::Error>(())
//! ```
//!
//! A scene has one camera without a name, [`camera`](Scene::camera), or any number of [views](View), which
//! are cameras with names: a scene with views is seen through one of them at a time,
//! [`look_through`](Scene::look_through), and the camera without a name plays no part. Objects, their
//! parameters and the tree of a [`Renderer`](crate::Renderer) are those of all views. So the cameras of views
//! are parameters as all others (`view.left.look_from`), an image depends on that of its own view alone, and
//! what matches several images adds up what each of them says. What an image should show is no part of a
//! scene. Turned down: views beside the scene that replace its camera in turn (their parameters would need
//! a second table), and every camera a view (a scene with one camera would have to name it).
//!
//! Values are `f64` whatever images are computed in, so that small steps of an optimiser are not lost.
//! Turned down: one structure of all numbers beside one of all names (parallel arrays, whose lengths
//! nothing ties together), and numbers behind shared references (a scene is cloned to be varied).

mod environment;
#[cfg(test)]
mod example;
mod framing;
mod integrator;
mod light;
mod lookup;
mod material;
mod mesh;
mod normals;
#[doc(hidden)]
pub mod numbers;
mod object;
mod parameter;
mod shape;
mod sphere;
#[doc(hidden)]
pub mod table;
mod texture;
mod validate;
mod view;

use glam::DVec3;

pub use crate::transport::area_light::AreaLight;
pub use crate::transport::camera::Camera;
pub use crate::transport::environment::Environment;
pub use crate::transport::light::{DistantLight, Light, PointLight, SpotLight};
pub use crate::transport::material::{Bsdf, Material};
pub use crate::transport::sphere::Sphere;
pub use crate::transport::transform::Transform;
pub use environment::EnvironmentObject;
pub use integrator::{Integrator, PathTracing};
pub(crate) use light::MOST_EDGED_LIGHTS;
pub use light::{LightObject, LightSource};
pub use material::{MaterialObject, MaterialTextures, Slot};
pub use mesh::Mesh;
pub use normals::Normals;
pub use object::{Object, ParameterId};
pub use parameter::ParameterPath;
pub use shape::ShapeObject;
pub use sphere::SphereObject;
pub use texture::{Texels, Texture, Wrap};
pub use validate::Invalid;
#[doc(hidden)]
pub use validate::MOST_PIXELS;
pub use view::View;

use crate::Error;
use crate::custom::{EmitterFamily, ShapeFamily};

/// How many mirrors and transparent surfaces a path has at most, if a scene does not say.
pub const DEFAULT_BOUNCES: u32 = 4;

/// By how many points each light with an area stands, if a scene does not say.
pub const DEFAULT_LIGHT_SAMPLES: u32 = 16;

/// The most points of a light with an area.
pub const MOST_LIGHT_SAMPLES: u32 = 1 << 12;

/// A scene, complete: it needs no file to be rendered.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// The width of the image in pixels, if the scene has no views.
    pub width: u32,
    /// The height of the image in pixels, if the scene has no views.
    pub height: u32,
    /// How many mirrors and transparent surfaces a path has at most.
    pub bounces: u32,
    /// By how many points each light with an area stands.
    pub light_samples: u32,
    /// Which paths of light count.
    pub integrator: Integrator,
    /// The camera, if the scene has no views.
    pub camera: Camera<f64>,
    /// What surrounds the scene, if it is not black.
    pub environment: Option<EnvironmentObject>,
    #[doc(hidden)]
    pub views: Vec<View>,
    /// The view that the scene is seen through, if it has any.
    #[doc(hidden)]
    pub shown: usize,
    #[doc(hidden)]
    pub lights: Vec<LightObject>,
    #[doc(hidden)]
    pub materials: Vec<MaterialObject>,
    #[doc(hidden)]
    pub textures: Vec<Texture>,
    #[doc(hidden)]
    pub spheres: Vec<SphereObject>,
    #[doc(hidden)]
    pub meshes: Vec<Mesh>,
    #[doc(hidden)]
    pub shapes: Vec<ShapeObject>,
}

impl Scene {
    /// A scene without objects, whose image has `width` by `height` pixels.
    pub fn new(width: u32, height: u32, camera: Camera<f64>) -> Self {
        Self {
            width,
            height,
            bounces: DEFAULT_BOUNCES,
            light_samples: DEFAULT_LIGHT_SAMPLES,
            integrator: Integrator::Direct,
            camera,
            environment: None,
            views: Vec::new(),
            shown: 0,
            lights: Vec::new(),
            materials: Vec::new(),
            textures: Vec::new(),
            spheres: Vec::new(),
            meshes: Vec::new(),
            shapes: Vec::new(),
        }
    }

    /// Adds a light; returns its index.
    ///
    /// # Errors
    ///
    /// If a number is out of its range, or another light has the name. The same holds, for their
    /// kinds, of all functions that add objects.
    pub fn add_light(
        &mut self,
        name: impl Into<String>,
        light: impl Into<Light<f64>>,
    ) -> Result<u32, Error> {
        let source = LightSource::Known(light.into());
        self.lights.push(LightObject { name: name.into(), source });
        self.added(|scene| &mut scene.lights, Object::Light)
    }

    /// Adds a custom light; returns its index.
    ///
    /// # Errors
    ///
    /// If a number is not finite, or another light has the name.
    pub fn add_emitter<T: EmitterFamily>(
        &mut self,
        name: impl Into<String>,
        light: T,
    ) -> Result<u32, Error> {
        let source = LightSource::custom(&light);
        self.lights.push(LightObject { name: name.into(), source });
        self.added(|scene| &mut scene.lights, Object::Light)
    }

    /// Adds a material, or a [`MaterialObject`] with textures or an opacity; returns its index.
    ///
    /// # Errors
    ///
    /// If a number is out of its range, another material has the name, or a texture is missing.
    pub fn add_material(
        &mut self,
        name: impl Into<String>,
        material: impl Into<MaterialObject>,
    ) -> Result<u32, Error> {
        self.materials.push(MaterialObject { name: name.into(), ..material.into() });
        self.added(|scene| &mut scene.materials, Object::Material)
    }

    /// Adds a texture; returns its index.
    ///
    /// # Errors
    ///
    /// If it has no texels or other than its size says, one is out of range, or another texture has
    /// the name.
    pub fn add_texture(&mut self, texture: Texture) -> Result<u32, Error> {
        self.textures.push(texture);
        self.added(|scene| &mut scene.textures, Object::Texture)
    }

    /// Adds a sphere; returns its index.
    ///
    /// # Errors
    ///
    /// If a number is out of its range, another sphere has the name, or its material is missing.
    pub fn add_sphere(&mut self, sphere: SphereObject) -> Result<u32, Error> {
        self.spheres.push(sphere);
        self.added(|scene| &mut scene.spheres, Object::Sphere)
    }

    /// Adds a mesh; returns its index.
    ///
    /// # Errors
    ///
    /// If a number is out of its range, another mesh has the name, or a vertex, texture coordinate, normal
    /// or material is missing.
    pub fn add_mesh(&mut self, mesh: Mesh) -> Result<u32, Error> {
        self.meshes.push(mesh);
        self.added(|scene| &mut scene.meshes, Object::Mesh)
    }

    /// Adds a custom shape with a material; returns its index.
    ///
    /// # Errors
    ///
    /// If a number is not finite, another shape has the name, or the material is missing, textured or
    /// transparent.
    pub fn add_shape<T: ShapeFamily>(
        &mut self,
        name: impl Into<String>,
        shape: T,
        material: u32,
    ) -> Result<u32, Error> {
        self.shapes.push(ShapeObject::new(name, &shape, material));
        self.added(|scene| &mut scene.shapes, Object::Shape)
    }

    /// Keeps the object that was added last if it is valid.
    fn added<T>(
        &mut self,
        objects: impl Fn(&mut Self) -> &mut Vec<T>,
        object: fn(usize) -> Object,
    ) -> Result<u32, Error> {
        let index = objects(self).len() - 1;
        if let Err(Invalid { path, problem }) = self.check_object(object(index)) {
            objects(self).pop();
            return Err(Error::new(path, problem));
        }
        Ok(index as u32)
    }

    /// The lights, in the order in which they were added; so it is with all objects.
    pub fn lights(&self) -> &[LightObject] {
        &self.lights
    }

    /// The materials.
    pub fn materials(&self) -> &[MaterialObject] {
        &self.materials
    }

    /// The textures.
    pub fn textures(&self) -> &[Texture] {
        &self.textures
    }

    /// The spheres.
    pub fn spheres(&self) -> &[SphereObject] {
        &self.spheres
    }

    /// The meshes.
    pub fn meshes(&self) -> &[Mesh] {
        &self.meshes
    }

    /// The custom shapes.
    pub fn shapes(&self) -> &[ShapeObject] {
        &self.shapes
    }

    /// The lowest and the highest corner of the box around all geometry in the world; nothing if there
    /// is none.
    pub fn bounding_box(&self) -> Option<(DVec3, DVec3)> {
        let meshes = self.meshes.iter().filter_map(Mesh::bounds);
        let spheres = self.spheres.iter().map(SphereObject::bounds);
        let shapes = self.shapes.iter().map(ShapeObject::bounds);
        let boxes = meshes.chain(spheres).chain(shapes);
        boxes.reduce(|(low, high), (a, b)| (low.min(a), high.max(b)))
    }
}
