//! A scene in the form that is rendered.

use ad::lanes::Lanes;
use ad::{Scalar, Vec3};
use glam::DVec3;
use rayon::prelude::*;

use super::view::film_offsets;
use crate::acceleration::{Acceleration, Shape, Shapes};
use crate::kernels::camera::{Frame, frame};
use crate::kernels::light::PointLight;
use crate::kernels::material::Material;
use crate::kernels::sphere::Sphere;
use crate::precision::{narrow, widen};
use crate::scene::{Light, Parameters, Scene};

/// A scene in the precision of the kernels, with its acceleration structure.
///
/// Positions are held relative to the middle of the scene as it was when it was prepared, so that
/// a scene far from the origin keeps its precision. Differences of positions, and with them
/// gradients, are not affected.
pub struct Prepared<'a, L: Lanes> {
    pub(super) scene: &'a Scene,
    pub(super) parameters: Parameters,
    middle: DVec3,
    pub(super) pinhole: DVec3,
    pub(super) frame: Frame<L>,
    pub(super) lights: Vec<Light<f64>>,
    pub(super) materials: Vec<Material<L::Element>>,
    /// Whether any of them reflects like a mirror.
    pub(super) has_mirrors: bool,
    pub(super) spheres: Vec<Sphere<L::Element>>,
    /// The vertices of all meshes, one mesh after the other.
    pub(super) vertices: Vec<Vec3<L::Element>>,
    /// The first vertex of each mesh.
    first_vertices: Vec<u32>,
    /// The triangles of all meshes, by index into `vertices`.
    pub(super) triangles: Vec<[u32; 3]>,
    /// The material of each primitive: of the triangles, then of the spheres.
    pub(super) material_of: Vec<u32>,
    pub(super) film_offsets: Vec<(L, L)>,
    pub(super) acceleration: Acceleration,
}

impl<'a, L: Lanes> Prepared<'a, L> {
    /// Prepares a scene. The scene has to be valid (see [`Scene::validate`]).
    pub fn new(scene: &'a Scene) -> Self {
        let bounding_box = scene.parameters.bounding_box();
        let middle = bounding_box.map_or(DVec3::ZERO, |(low, high)| low.midpoint(high));
        let mut triangles = Vec::new();
        let mut material_of = Vec::new();
        let mut first_vertices = Vec::new();
        let mut first_vertex = 0;
        for (mesh, vertices) in scene.meshes.iter().zip(&scene.parameters.vertices) {
            triangles.extend(mesh.triangles.iter().map(|t| t.map(|v| v + first_vertex)));
            material_of.extend(&mesh.materials);
            first_vertices.push(first_vertex);
            first_vertex += vertices.len() as u32;
        }
        material_of.extend(scene.spheres.iter().map(|sphere| sphere.material));

        let mut prepared = Self {
            scene,
            parameters: scene.parameters.clone(),
            middle,
            pinhole: DVec3::ZERO,
            frame: Frame::zero().narrow(),
            lights: Vec::new(),
            materials: Vec::new(),
            has_mirrors: false,
            spheres: Vec::new(),
            vertices: Vec::new(),
            first_vertices,
            triangles,
            material_of,
            film_offsets: film_offsets(),
            acceleration: Acceleration::new(&[][..]),
        };
        prepared.load_appearance();
        prepared.load_geometry();
        prepared
    }

    /// Moves to other values of the parameters. If geometry moved, the tree is fitted to
    /// it.
    ///
    /// # Panics
    ///
    /// If `parameters` has another shape than the scene's.
    pub fn set_parameters(&mut self, parameters: &Parameters) {
        let moved = self.parameters.vertices != parameters.vertices
            || self.parameters.spheres != parameters.spheres;
        self.parameters.clone_from(parameters);
        self.load_appearance();
        if moved {
            self.load_geometry();
        }
    }

    /// The width divided by the height of the image.
    pub(super) fn aspect(&self) -> f64 {
        f64::from(self.scene.width) / f64::from(self.scene.height)
    }

    fn load_appearance(&mut self) {
        let mut camera = self.parameters.camera;
        camera.look_from -= self.middle;
        camera.look_at -= self.middle;
        self.pinhole = camera.look_from;
        self.frame = frame::<f64>(camera, self.aspect()).narrow();
        self.lights = self
            .parameters
            .lights
            .iter()
            .map(|light| match light {
                Light::Point(light) => {
                    let position = light.position - self.middle;
                    Light::Point(PointLight { position, ..*light })
                }
                Light::Distant(light) => Light::Distant(*light),
            })
            .collect();
        self.materials = self.parameters.materials.iter().map(Material::narrow).collect();
        self.has_mirrors = (0..self.materials.len()).any(|material| self.is_mirror(material));
    }

    fn load_geometry(&mut self) {
        let middle = self.middle;
        self.vertices.clear();
        for vertices in &self.parameters.vertices {
            let relative =
                vertices.par_iter().map(|&v| narrow::<L::Element>(DVec3::from(v) - middle));
            self.vertices.par_extend(relative);
        }
        let spheres = self.parameters.spheres.iter();
        self.spheres = spheres
            .map(|sphere| Sphere { center: sphere.center - middle, ..*sphere }.narrow())
            .collect();
        let Self { vertices, triangles, spheres, .. } = self;
        self.acceleration.update(&Geometry { vertices, triangles, spheres });
    }

    /// The mesh of a vertex, and its index there.
    pub(super) fn vertex_of_mesh(&self, vertex: u32) -> (usize, usize) {
        let mesh = self.first_vertices.partition_point(|&first| first <= vertex) - 1;
        (mesh, (vertex - self.first_vertices[mesh]) as usize)
    }

    /// The index of a sphere among the spheres.
    pub(super) fn sphere_of(&self, primitive: usize) -> usize {
        primitive - self.triangles.len()
    }
}

/// The primitives as traversal takes them: the triangles, then the spheres.
struct Geometry<'a, S: Scalar> {
    vertices: &'a [Vec3<S>],
    triangles: &'a [[u32; 3]],
    spheres: &'a [Sphere<S>],
}

impl<S: Scalar> Shapes for Geometry<'_, S> {
    fn count(&self) -> usize {
        self.triangles.len() + self.spheres.len()
    }

    #[inline]
    fn shape(&self, index: u32) -> Shape {
        let index = index as usize;
        match self.triangles.get(index) {
            Some(corners) => {
                let corner = |vertex: u32| widen::<S>(self.vertices[vertex as usize]).as_vec3();
                Shape::Triangle(corners.map(corner))
            }
            None => {
                let Sphere { center, radius } = self.spheres[index - self.triangles.len()];
                Shape::Sphere(widen::<S>(center).as_vec3(), radius.to_f64() as f32)
            }
        }
    }
}
