//! Triangles of smooth meshes that may be in their own shadow: they have turned their back to a light that shading
//! normals still face.

use rayon::prelude::*;

use super::geometry::Geometry;
use crate::number::Plain;

/// The triangles of a scene that may be in their own shadow.
pub struct TurnedAway {
    /// By triangle: a bit for each light; none where nothing is smooth.
    lights: Vec<u64>,
}

impl TurnedAway {
    /// Of a scene.
    pub fn new<L: Plain>(geometry: &Geometry<'_, L>) -> Self {
        let layout = geometry.integrator.layout;
        let count = if layout.normals.is_empty() { 0 } else { layout.triangles.len() };
        let lights = (0..count).into_par_iter().map(|triangle| geometry.may_shade_itself(triangle));
        Self { lights: lights.collect() }
    }

    /// A bit for each light from which a triangle may be in its own shadow.
    #[inline]
    pub fn of(&self, triangle: u32) -> u64 {
        self.lights.get(triangle as usize).copied().unwrap_or(0)
    }
}
