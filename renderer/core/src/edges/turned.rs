//! Triangles of smooth meshes that stand otherwise than their shading normals say.

use std::sync::OnceLock;

use super::geometry::Geometry;
use crate::transport::smooth::side_of;
use crate::transport::triangle::Triangle;

/// How the normals of the corners of a triangle stand to it.
#[derive(Clone, Copy, Default)]
pub struct Turned {
    /// A bit for each light that has the plane of the triangle between it and the side that a normal is on: the
    /// triangle may be in its own shadow.
    pub lights: u64,
    /// Whether the normals are [behind](mod@crate::transport::smooth) the side from which the corners stand
    /// anticlockwise.
    pub has_normals_behind: bool,
}

impl Turned {
    /// How a triangle is turned.
    pub fn of(geometry: &Geometry<'_>, triangle: u32) -> Self {
        let triangle = triangle as usize;
        let Some(normals) = geometry.normals(triangle) else { return Self::default() };
        let Triangle { a, b, c } = geometry.triangle(triangle);
        let outward = (b - a).cross(c - a);
        let has_normals_behind = side_of::<f64>(normals, outward) < 0.0;
        let side = if has_normals_behind { -1.0 } else { 1.0 };
        let is_between = |light: &usize| {
            let to_light = geometry.tracer.illuminate(*light, a).direction;
            let faces = side * outward.dot(to_light);
            normals.iter().any(|normal| faces * normal.dot(to_light) <= 0.0)
        };
        let lights = (0..geometry.edged_lights()).filter(is_between);
        let lights = lights.fold(0, |bits, light| bits | 1 << light);
        Self { lights, has_normals_behind }
    }
}

/// How the triangles of a scene are turned.
pub struct AllTurned<'a> {
    geometry: Geometry<'a>,
    /// By triangle, once it was asked for; none where nothing is smooth.
    triangles: Vec<OnceLock<Turned>>,
}

impl<'a> AllTurned<'a> {
    /// Of a scene.
    pub fn new(geometry: &Geometry<'a>) -> Self {
        let layout = geometry.layout;
        let count = if layout.normals.is_empty() { 0 } else { layout.triangles.len() };
        Self { geometry: *geometry, triangles: vec![OnceLock::new(); count] }
    }

    /// How a triangle is turned.
    #[inline]
    pub fn of(&self, triangle: u32) -> Turned {
        let find = || Turned::of(&self.geometry, triangle);
        let known = self.triangles.get(triangle as usize);
        known.map_or(Turned::default(), |turned| *turned.get_or_init(find))
    }
}
