//! What lights come through to both sides of crossings.
//!
//! At an edge shadow rays cannot tell one side from the other: where a transparent surface ends, or pierces the
//! surface that it takes light from. So it is asked a little to each side.

use super::band::Band;
use super::crossing::{Crossing, Layer};
use super::geometry::{Geometry, Shadow};
use crate::number::Plain;
use crate::primal::known::Occluding;
use crate::trace::bvh::NO_PRIMITIVE;

/// How far from an edge it is asked what lights come through, in distances between samples.
pub const BESIDE: f64 = 1e-3;

/// The transparent surfaces that a light comes through to a surface on one side of a crossing.
pub struct LitThrough {
    /// 0 or 1.
    pub side: usize,
    pub depth: u32,
    pub light: usize,
    /// From the point on.
    pub surfaces: Vec<Occluding>,
}

impl Band {
    /// Finds the transparent surfaces that lights come through on the sides of crossings. Samples are `length` pixels
    /// apart.
    pub(super) fn find_lit_through<L: Plain>(&mut self, geometry: &Geometry<'_, L>, length: f64) {
        if !geometry.integrator.layout.has_transparency {
            return;
        }
        for index in 0..self.crossings.len() {
            let Crossing { place, normal, sides, layer, .. } = self.crossings[index];
            let start = self.lit_through.len() as u32;
            let beside = [-1.0, 1.0]
                .map(|sign| [0, 1].map(|axis| place[axis] + sign * BESIDE * length * normal[axis]));
            for side in [0, 1] {
                let path: Vec<_> = sides[side].of(&self.hits).collect();
                let surfaces = path.iter().take_while(|hit| hit.primitive != NO_PRIMITIVE);
                for (depth, known) in surfaces.enumerate() {
                    let meet = |place| {
                        let ray = geometry.ray(&path[..depth], place);
                        (ray, geometry.meet(known, ray))
                    };
                    let met = beside.map(meet);
                    let lights = 0..geometry.edged_lights();
                    for light in lights.filter(|light| known.blocked >> light & 1 == 0) {
                        // At the edge of a shadow nothing else changes, even if another shadow has an edge there.
                        let is_of_other = match layer {
                            Layer::Surface(_) => false,
                            Layer::Shadow(at, of) => (at, of) != (depth as u32, light as u32),
                        };
                        let (ray, met) = &met[if is_of_other { 0 } else { side }];
                        if let Shadow::Through(surfaces) = geometry.shadow(light, known, ray, met) {
                            let depth = depth as u32;
                            self.lit_through.push(LitThrough { side, depth, light, surfaces });
                        }
                    }
                }
            }
            self.crossings[index].lit_through = [start, self.lit_through.len() as u32];
        }
    }

    /// What one side of a crossing is lit through.
    pub(super) fn lit_through(
        &self,
        crossing: &Crossing,
        side: usize,
    ) -> impl Iterator<Item = &LitThrough> {
        let [start, end] = crossing.lit_through.map(|at| at as usize);
        self.lit_through[start..end].iter().filter(move |lit| lit.side == side)
    }
}
