//! A scene in the form that is rendered.

use ad::{Scalar, Vec3};
use glam::DVec3;

use crate::acceleration::{Acceleration, Hit, Shape};
use crate::kernels::camera::{Frame, frame};
use crate::kernels::material::Material;
use crate::kernels::sphere::Sphere;
use crate::precision::{narrow, widen};
use crate::scene::{Light, Parameters, Scene};

/// A scene in the precision of the kernels, with its acceleration structure.
///
/// Positions are held relative to the middle of the scene as it was when it was prepared, so that
/// a scene far from the origin keeps its precision. Differences of positions, and with them
/// gradients, are not affected.
pub struct Prepared<'a, S: Scalar> {
    pub(super) scene: &'a Scene,
    pub(super) parameters: Parameters,
    middle: DVec3,
    pub(super) frame: Frame<S>,
    pub(super) lights: Vec<Light<S>>,
    pub(super) materials: Vec<Material<S>>,
    pub(super) spheres: Vec<Sphere<S>>,
    /// The vertices of all meshes, one mesh after the other.
    pub(super) vertices: Vec<Vec3<S>>,
    /// The triangles of all meshes, by index into `vertices`.
    pub(super) triangles: Vec<[u32; 3]>,
    /// The material of each triangle, then of each sphere.
    pub(super) material_of: Vec<u32>,
    acceleration: Acceleration,
}

/// A primitive of the scene.
#[derive(Clone, Copy)]
pub(super) enum Primitive {
    /// Index into the triangles.
    Triangle(usize),
    /// Index into the spheres.
    Sphere(usize),
}

impl<'a, S: Scalar> Prepared<'a, S> {
    /// Prepares a scene. The scene has to be valid (see [`Scene::validate`]).
    pub fn new(scene: &'a Scene) -> Self {
        let middle = middle(&scene.parameters);
        let mut triangles = Vec::new();
        let mut material_of = Vec::new();
        let mut first_vertex = 0;
        for (mesh, vertices) in scene.meshes.iter().zip(&scene.parameters.vertices) {
            triangles.extend(mesh.triangles.iter().map(|t| t.map(|v| v + first_vertex)));
            material_of.extend(&mesh.materials);
            first_vertex += vertices.len() as u32;
        }
        material_of.extend(scene.spheres.iter().map(|sphere| sphere.material));

        let mut prepared = Self {
            scene,
            parameters: scene.parameters.clone(),
            middle,
            frame: Frame::zero().narrow(),
            lights: Vec::new(),
            materials: Vec::new(),
            spheres: Vec::new(),
            vertices: Vec::new(),
            triangles,
            material_of,
            acceleration: Acceleration::new(&[]),
        };
        prepared.load_appearance();
        prepared.load_geometry();
        prepared
    }

    /// Moves to other values of the parameters. The tree is rebuilt if geometry moved.
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
        // Once per image, so in double precision.
        self.frame = frame::<f64>(camera, self.aspect()).narrow();
        self.lights = self
            .parameters
            .lights
            .iter()
            .map(|light| match light {
                Light::Point(light) => {
                    let position = light.position - self.middle;
                    Light::Point(crate::kernels::light::PointLight { position, ..*light }.narrow())
                }
                Light::Distant(light) => Light::Distant(light.narrow()),
            })
            .collect();
        self.materials = self.parameters.materials.iter().map(Material::narrow).collect();
    }

    fn load_geometry(&mut self) {
        let vertices = self.parameters.vertices.iter().flatten();
        self.vertices = vertices.map(|&v| narrow::<S>(DVec3::from(v) - self.middle)).collect();
        let spheres = self.parameters.spheres.iter();
        self.spheres = spheres
            .map(|sphere| Sphere { center: sphere.center - self.middle, ..*sphere }.narrow())
            .collect();

        let vertex = |index: u32| widen::<S>(self.vertices[index as usize]).as_vec3();
        let triangles = self.triangles.iter().map(|t| Shape::Triangle(t.map(vertex)));
        let spheres = self.spheres.iter().map(|sphere| {
            Shape::Sphere(widen::<S>(sphere.center).as_vec3(), sphere.radius.to_f64() as f32)
        });
        let shapes: Vec<_> = triangles.chain(spheres).collect();
        self.acceleration = Acceleration::new(&shapes);
    }

    /// The first primitive along a ray.
    pub(super) fn nearest(&self, origin: Vec3<S>, direction: Vec3<S>) -> Option<Hit> {
        self.acceleration.nearest(widen::<S>(origin).as_vec3(), widen::<S>(direction).as_vec3())
    }

    /// Whether something stands between a point of `hit` and `limit` along a direction.
    pub(super) fn is_shadowed(
        &self,
        hit: &Hit,
        point: Vec3<S>,
        normal: Vec3<S>,
        direction: Vec3<S>,
        limit: f64,
    ) -> bool {
        // A ray that leaves a triangle cannot come back to it.
        let from = match self.primitive(hit.primitive) {
            Primitive::Triangle(_) => Some(hit.primitive),
            Primitive::Sphere(_) => None,
        };
        let (point, normal) = (widen::<S>(point), widen::<S>(normal));
        let origin = point + normal * surface_error(point, hit.distance);
        let direction = widen::<S>(direction).as_vec3();
        self.acceleration.is_occluded(origin.as_vec3(), direction, limit as f32, from)
    }

    pub(super) fn primitive(&self, id: u32) -> Primitive {
        match (id as usize).checked_sub(self.triangles.len()) {
            None => Primitive::Triangle(id as usize),
            Some(sphere) => Primitive::Sphere(sphere),
        }
    }
}

/// How far a hit may be from the surface that traversal sees: coordinates of the surface and of the
/// point were rounded to single precision, and so was the distance along the ray (the error
/// analysis of Pharr, Jakob & Humphreys, "Physically Based Rendering", section 6.8).
fn surface_error(point: DVec3, distance: f32) -> f64 {
    let reach = point.abs().max_element().max(f64::from(distance));
    8.0 * f64::from(f32::EPSILON) * reach
}

/// The middle of the box around all geometry; the origin if there is none.
fn middle(parameters: &Parameters) -> DVec3 {
    let vertices = parameters.vertices.iter().flatten().map(|&v| DVec3::from(v));
    let corners = vertices.map(|v| (v, v));
    let spheres = parameters.spheres.iter().map(|s| (s.center - s.radius, s.center + s.radius));
    corners
        .chain(spheres)
        .reduce(|(low, high), (a, b)| (low.min(a), high.max(b)))
        .map_or(DVec3::ZERO, |(low, high)| low.midpoint(high))
}
