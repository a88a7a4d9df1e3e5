//! Triangles of smooth meshes that may be in their own shadow: they have turned their back to a light that shading
//! normals still face.

use std::sync::OnceLock;

use super::geometry::Geometry;

/// The triangles of a scene that may be in their own shadow.
pub struct TurnedAway<'a> {
    geometry: Geometry<'a>,
    /// By triangle: a bit for each light, once it was asked for; none where nothing is smooth.
    lights: Vec<OnceLock<u64>>,
}

impl<'a> TurnedAway<'a> {
    /// Of a scene.
    pub fn new(geometry: &Geometry<'a>) -> Self {
        let layout = geometry.layout;
        let count = if layout.normals.is_empty() { 0 } else { layout.triangles.len() };
        Self { geometry: *geometry, lights: vec![OnceLock::new(); count] }
    }

    /// A bit for each light from which a triangle may be in its own shadow.
    #[inline]
    pub fn of(&self, triangle: u32) -> u64 {
        let find = || self.geometry.may_shade_itself(triangle as usize);
        self.lights.get(triangle as usize).map_or(0, |lights| *lights.get_or_init(find))
    }
}
