//! The continuous part of a scene, and the paths that reach into it.

use std::fmt;
use std::slice;

use glam::DVec3;

use super::{MaterialObject, Scene};
use crate::kernels::camera::Camera;
use crate::kernels::light::{DistantLight, PointLight};
use crate::kernels::material::Material;
use crate::kernels::sphere::Sphere;

/// Every number of a scene that can vary continuously; also the shape of a gradient.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameters {
    /// The camera.
    pub camera: Camera<f64>,
    /// The lights.
    pub lights: Vec<Light<f64>>,
    /// The materials.
    pub materials: Vec<Material<f64>>,
    /// The opacities of the materials that are transparent, see
    /// [`MaterialObject::opacity`](super::MaterialObject::opacity): what a surface takes away of the light
    /// that comes from behind it, and the part of its own that it shows; from 0 to 1.
    pub opacities: Vec<f64>,
    /// The spheres.
    pub spheres: Vec<Sphere<f64>>,
    /// The vertices of each mesh.
    pub vertices: Vec<Vec<[f64; 3]>>,
    /// The texture coordinates of each mesh: to the right and upwards, from 0 to 1 over the texture.
    /// None if the mesh wears no texture.
    pub texture_coordinates: Vec<Vec<[f64; 2]>>,
    /// The texels of each texture, linear RGB, row by row from the top left.
    pub textures: Vec<Vec<[f64; 3]>>,
    /// The numbers of each shape that a user adds.
    pub shapes: Vec<Vec<f64>>,
    /// The numbers of each light that a user adds.
    pub custom_lights: Vec<Vec<f64>>,
}

/// A light of one of the known kinds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Light<S: ad::Real> {
    /// Shines from a point.
    Point(PointLight<S>),
    /// Shines from infinitely far.
    Distant(DistantLight<S>),
}

impl Light<f64> {
    /// Whether it sends nothing.
    pub fn is_black(&self) -> bool {
        let (color, intensity) = match self {
            Self::Point(light) => (light.color, light.intensity),
            Self::Distant(light) => (light.color, light.intensity),
        };
        color * intensity == DVec3::ZERO
    }
}

/// What the gradient of a parameter is worth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Differentiability {
    /// The image depends smoothly on it, and the gradient is all there is.
    Smooth,
    /// It also moves silhouettes or the edges of shadows. The gradient holds the interior term; the
    /// jumps at these edges are missing from it.
    Interior,
}

/// One parameter of a scene: a block of numbers that a path such as `light.key.position` names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ParameterId {
    /// `camera.look_from`
    LookFrom,
    /// `camera.look_at`
    LookAt,
    /// `camera.up`
    Up,
    /// `camera.vfov`
    Vfov,
    /// `camera.focus`
    Focus,
    /// `light.NAME.position`, of a point light
    LightPosition(usize),
    /// `light.NAME.direction`, of a distant light
    LightDirection(usize),
    /// `light.NAME.color`
    LightColor(usize),
    /// `light.NAME.intensity`
    LightIntensity(usize),
    /// `material.NAME.ambient`
    Ambient(usize),
    /// `material.NAME.diffuse`
    Diffuse(usize),
    /// `material.NAME.specular`
    Specular(usize),
    /// `material.NAME.exponent`
    Exponent(usize),
    /// `material.NAME.reflection`, of an opaque material
    Reflection(usize),
    /// `material.NAME.opacity`, of a transparent material; by index of the material's opacity
    Opacity(usize),
    /// `sphere.NAME.center`
    SphereCenter(usize),
    /// `sphere.NAME.radius`
    SphereRadius(usize),
    /// `mesh.NAME.vertices`
    Vertices(usize),
    /// `mesh.NAME.vertices[INDEX]`, one vertex, counted from 0: a part of `mesh.NAME.vertices`
    Vertex {
        /// The index of the mesh.
        mesh: usize,
        /// The index of the vertex in the mesh.
        vertex: usize,
    },
    /// `mesh.NAME.texture_coordinates`
    TextureCoordinates(usize),
    /// `texture.NAME.texels`
    Texels(usize),
    /// `shape.NAME.parameters`, of a shape that a user adds
    ShapeParameters(usize),
    /// `light.NAME.parameters`, of a light that a user adds
    LightParameters(usize),
}

impl ParameterId {
    /// What a gradient with respect to it is worth.
    pub fn differentiability(self) -> Differentiability {
        use ParameterId::*;
        match self {
            LightColor(_)
            | LightIntensity(_)
            | Ambient(_)
            | Diffuse(_)
            | Specular(_)
            | Exponent(_)
            | Reflection(_)
            | Opacity(_)
            | TextureCoordinates(_)
            | Texels(_) => Differentiability::Smooth,
            LookFrom
            | LookAt
            | Up
            | Vfov
            | Focus
            | LightPosition(_)
            | LightDirection(_)
            | SphereCenter(_)
            | SphereRadius(_)
            | Vertices(_)
            | Vertex { .. }
            | ShapeParameters(_)
            | LightParameters(_) => Differentiability::Interior,
        }
    }

    /// Whether the two have numbers in common: they are the same, or one is a vertex of the other.
    pub fn overlaps(self, other: Self) -> bool {
        let whole = |id| match id {
            Self::Vertex { mesh, .. } => Self::Vertices(mesh),
            id => id,
        };
        self == other || whole(self) == other || self == whole(other)
    }
}

impl Scene {
    /// Every parameter of the scene, in a fixed order. Single vertices are not among them: they are parts
    /// of others.
    pub fn parameter_ids(&self) -> Vec<ParameterId> {
        use ParameterId::*;
        let mut ids = vec![LookFrom, LookAt, Up, Vfov, Focus];
        for (i, light) in self.parameters.lights.iter().enumerate() {
            ids.push(match light {
                Light::Point(_) => LightPosition(i),
                Light::Distant(_) => LightDirection(i),
            });
            ids.extend([LightColor(i), LightIntensity(i)]);
        }
        for (i, material) in self.materials.iter().enumerate() {
            ids.extend([Ambient(i), Diffuse(i), Specular(i), Exponent(i)]);
            ids.push(match material.opacity {
                None => Reflection(i),
                Some(opacity) => Opacity(opacity as usize),
            });
        }
        for i in 0..self.parameters.spheres.len() {
            ids.extend([SphereCenter(i), SphereRadius(i)]);
        }
        ids.extend((0..self.parameters.vertices.len()).map(Vertices));
        let coordinates = self.parameters.texture_coordinates.iter().enumerate();
        let given = coordinates.filter(|(_, coordinates)| !coordinates.is_empty());
        ids.extend(given.map(|(i, _)| TextureCoordinates(i)));
        ids.extend((0..self.parameters.textures.len()).map(Texels));
        ids.extend((0..self.parameters.shapes.len()).map(ShapeParameters));
        ids.extend((0..self.parameters.custom_lights.len()).map(LightParameters));
        ids
    }

    /// The lowest and the highest corner of the box around all geometry; nothing if there is none.
    pub fn bounding_box(&self) -> Option<(DVec3, DVec3)> {
        let Parameters { vertices, spheres, shapes, .. } = &self.parameters;
        // A vertex is a sphere without extent.
        let vertices = vertices.iter().flatten().map(|&v| (DVec3::from_array(v), 0.0));
        let spheres = spheres.iter().map(|sphere| (sphere.center, sphere.radius));
        let boxes = vertices.chain(spheres).map(|(center, r)| (center - r, center + r));
        let custom = self.shapes.iter().zip(shapes).map(|(object, p)| object.shape.bounds(p));
        boxes.chain(custom).reduce(|(low, high), (a, b)| (low.min(a), high.max(b)))
    }

    /// The shape of a parameter: empty for a number, `[3]` for a vector, `[n, 3]` for vertices,
    /// `[n, 2]` for texture coordinates, `[height, width, 3]` for texels.
    pub fn shape(&self, id: ParameterId) -> Vec<usize> {
        match (id, self.parameters.get(id).len()) {
            (ParameterId::Vertices(_), numbers) => vec![numbers / 3, 3],
            (ParameterId::TextureCoordinates(_), numbers) => vec![numbers / 2, 2],
            (ParameterId::Texels(i), _) => {
                vec![self.textures[i].height as usize, self.textures[i].width as usize, 3]
            }
            (ParameterId::ShapeParameters(_) | ParameterId::LightParameters(_), numbers) => {
                vec![numbers]
            }
            (_, 1) => Vec::new(),
            (_, numbers) => vec![numbers],
        }
    }

    /// The path of a parameter: `light.key.position`.
    pub fn path(&self, id: ParameterId) -> ParameterPath<'_> {
        ParameterPath { scene: self, id }
    }

    /// The parameter that a path names, or nothing.
    pub fn parameter(&self, path: &str) -> Option<ParameterId> {
        let named = |path: &str| {
            self.parameter_ids().into_iter().find(|&id| self.path(id).to_string() == path)
        };
        named(path).or_else(|| {
            let (whole, index) = split_index(path)?;
            let ParameterId::Vertices(mesh) = named(whole)? else { return None };
            let vertex = index.parse().ok()?;
            let exists = vertex < self.parameters.vertices[mesh].len();
            exists.then_some(ParameterId::Vertex { mesh, vertex })
        })
    }
}

/// `a[b]` as `a` and `b`.
pub(super) fn split_index(path: &str) -> Option<(&str, &str)> {
    path.strip_suffix(']')?.rsplit_once('[')
}

/// Displays as the path of a parameter.
pub struct ParameterPath<'a> {
    scene: &'a Scene,
    id: ParameterId,
}

impl fmt::Display for ParameterPath<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        use ParameterId::*;
        let scene = self.scene;
        let light = |i: usize| &scene.light_names[i];
        let material = |i: usize| &scene.materials[i].name;
        match self.id {
            LookFrom => write!(f, "camera.look_from"),
            LookAt => write!(f, "camera.look_at"),
            Up => write!(f, "camera.up"),
            Vfov => write!(f, "camera.vfov"),
            Focus => write!(f, "camera.focus"),
            LightPosition(i) => write!(f, "light.{}.position", light(i)),
            LightDirection(i) => write!(f, "light.{}.direction", light(i)),
            LightColor(i) => write!(f, "light.{}.color", light(i)),
            LightIntensity(i) => write!(f, "light.{}.intensity", light(i)),
            Ambient(i) => write!(f, "material.{}.ambient", material(i)),
            Diffuse(i) => write!(f, "material.{}.diffuse", material(i)),
            Specular(i) => write!(f, "material.{}.specular", material(i)),
            Exponent(i) => write!(f, "material.{}.exponent", material(i)),
            Reflection(i) => write!(f, "material.{}.reflection", material(i)),
            Opacity(i) => {
                let wears = |material: &&MaterialObject| material.opacity == Some(i as u32);
                let name = scene.materials.iter().find(wears).map_or("", |material| &material.name);
                write!(f, "material.{name}.opacity")
            }
            SphereCenter(i) => write!(f, "sphere.{}.center", scene.spheres[i].name),
            SphereRadius(i) => write!(f, "sphere.{}.radius", scene.spheres[i].name),
            Vertices(i) => write!(f, "mesh.{}.vertices", scene.meshes[i].name),
            Vertex { mesh, vertex } => {
                write!(f, "mesh.{}.vertices[{vertex}]", scene.meshes[mesh].name)
            }
            TextureCoordinates(i) => {
                write!(f, "mesh.{}.texture_coordinates", scene.meshes[i].name)
            }
            Texels(i) => write!(f, "texture.{}.texels", scene.textures[i].name),
            ShapeParameters(i) => write!(f, "shape.{}.parameters", scene.shapes[i].name),
            LightParameters(i) => write!(f, "light.{}.parameters", scene.custom_lights[i].name),
        }
    }
}

/// Reaches the numbers of one parameter, for `&` and `&mut` alike.
macro_rules! reach {
    ($parameters:ident, $id:ident, $one:path, $as_slice:ident, $flatten:ident, $($reference:tt)+) => {{
        use ParameterId::*;
        let Parameters {
            camera,
            lights,
            materials,
            opacities,
            spheres,
            vertices,
            texture_coordinates,
            textures,
            shapes,
            custom_lights,
        } = $parameters;
        match $id {
            LookFrom => camera.look_from.$as_slice(),
            LookAt => camera.look_at.$as_slice(),
            Up => camera.up.$as_slice(),
            Vfov => $one($($reference)+ camera.vfov),
            Focus => $one($($reference)+ camera.focus),
            LightPosition(i) => match $($reference)+ lights[i] {
                Light::Point(light) => light.position.$as_slice(),
                Light::Distant(_) => panic!("a distant light has no position"),
            },
            LightDirection(i) => match $($reference)+ lights[i] {
                Light::Distant(light) => light.direction.$as_slice(),
                Light::Point(_) => panic!("a point light has no direction"),
            },
            LightColor(i) => match $($reference)+ lights[i] {
                Light::Point(light) => light.color.$as_slice(),
                Light::Distant(light) => light.color.$as_slice(),
            },
            LightIntensity(i) => match $($reference)+ lights[i] {
                Light::Point(light) => $one($($reference)+ light.intensity),
                Light::Distant(light) => $one($($reference)+ light.intensity),
            },
            Ambient(i) => materials[i].ambient.$as_slice(),
            Diffuse(i) => materials[i].diffuse.$as_slice(),
            Specular(i) => materials[i].specular.$as_slice(),
            Exponent(i) => $one($($reference)+ materials[i].exponent),
            Reflection(i) => materials[i].reflection.$as_slice(),
            Opacity(i) => $one($($reference)+ opacities[i]),
            SphereCenter(i) => spheres[i].center.$as_slice(),
            SphereRadius(i) => $one($($reference)+ spheres[i].radius),
            Vertices(i) => vertices[i].$flatten(),
            Vertex { mesh, vertex } => $($reference)+ vertices[mesh][vertex][..],
            TextureCoordinates(i) => texture_coordinates[i].$flatten(),
            Texels(i) => textures[i].$flatten(),
            ShapeParameters(i) => $($reference)+ shapes[i][..],
            LightParameters(i) => $($reference)+ custom_lights[i][..],
        }
    }};
}

impl Parameters {
    /// The numbers of one parameter.
    ///
    /// # Panics
    ///
    /// If `id` is not a parameter of the scene that this belongs to.
    pub fn get(&self, id: ParameterId) -> &[f64] {
        reach!(self, id, slice::from_ref, as_ref, as_flattened, &)
    }

    /// The numbers of one parameter, to be changed.
    ///
    /// # Panics
    ///
    /// If `id` is not a parameter of the scene that this belongs to.
    pub fn get_mut(&mut self, id: ParameterId) -> &mut [f64] {
        reach!(self, id, slice::from_mut, as_mut, as_flattened_mut, &mut)
    }
}
