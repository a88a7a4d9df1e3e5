//! Triangles of smooth meshes that stand otherwise than their shading normals say.

use std::sync::OnceLock;

use super::geometry::Geometry;

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
        let find = || self.geometry.turned(triangle as usize);
        let known = self.triangles.get(triangle as usize);
        known.map_or(Turned::default(), |turned| *turned.get_or_init(find))
    }
}
