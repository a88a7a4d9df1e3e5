//! Triangles of smooth meshes that may be in their own shadow: they have turned their back to a light that shading
//! normals still face.

use std::ops::Range;

use super::geometry::Geometry;
use crate::parallel;

/// The triangles of a scene that may be in their own shadow.
pub struct TurnedAway {
    /// By triangle: a bit for each light; none where nothing is smooth.
    lights: Vec<u64>,
}

impl TurnedAway {
    /// Of a scene.
    pub fn new(geometry: &Geometry<'_>) -> Self {
        let layout = geometry.layout;
        let count = if layout.normals.is_empty() { 0 } else { layout.triangles.len() };
        let of_some = |triangles: Range<usize>| -> Vec<u64> {
            triangles.map(|triangle| geometry.may_shade_itself(triangle)).collect()
        };
        Self { lights: parallel::map_ranges(count, of_some).concat() }
    }

    /// A bit for each light from which a triangle may be in its own shadow.
    #[inline]
    pub fn of(&self, triangle: u32) -> u64 {
        self.lights.get(triangle as usize).copied().unwrap_or(0)
    }
}
