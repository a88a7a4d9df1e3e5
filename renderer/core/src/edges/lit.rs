//! What lights come through to both sides of crossings.
//!
//! At an edge shadow rays cannot tell one side from the other: where a transparent surface ends, or pierces the
//! surface that it takes light from. So it is asked a little to each side.

use super::crossing::{BEYOND, Crossing, Layer};
use super::geometry::{Geometry, Met};
use crate::primal::known::{KnownHit, Occluding};
use crate::trace::bvh::NO_PRIMITIVE;

/// How far from an edge it is asked what lights come through, in distances between samples.
pub const BESIDE: f64 = 1e-3;

/// The transparent surfaces that a light comes through to a surface on one side of a crossing.
pub struct LitThrough {
    /// 0 or 1.
    pub side: usize,
    pub depth: u32,
    pub light: usize,
    pub surfaces: Vec<Occluding>,
}

/// Finds the transparent surfaces that lights come through on the sides of crossings, whose paths are of these `hits`.
/// Samples are `length` pixels apart.
pub fn find_lit_through(
    geometry: &Geometry<'_>,
    crossings: &mut [Crossing],
    hits: &[KnownHit],
    length: f64,
) -> Vec<LitThrough> {
    let mut found = Vec::new();
    if !geometry.layout.has_transparency {
        return found;
    }
    for crossing in crossings {
        let start = found.len() as u32;
        for side in [0, 1] {
            let path: Vec<_> = crossing.sides[side].of(hits).collect();
            let surfaces = path.iter().take_while(|hit| hit.primitive != NO_PRIMITIVE);
            for (depth, known) in surfaces.enumerate() {
                let at = |distance: f64| {
                    lit_through(geometry, crossing, side, &path[..=depth], distance * length)
                };
                let is_as_seen = |lit: &Vec<LitThrough>| filters(geometry, lit) == known.filters;
                let mut lit = at(resolution(geometry, crossing, side, &path[..=depth], length));
                if matches!(crossing.layer, Layer::Surface(_)) && !is_as_seen(&lit) {
                    // The shadow of a light at the camera ends even closer to the edge that casts it.
                    lit = Some(at(BEYOND)).filter(is_as_seen).unwrap_or(lit);
                }
                found.extend(lit);
            }
        }
        crossing.lit_through = [start, found.len() as u32];
    }
    found
}

/// How far from a crossing one of its sides is looked at, in distances between samples: beside it, but not so close to it
/// that rays of single precision cannot tell them apart.
pub fn resolution(
    geometry: &Geometry<'_>,
    crossing: &Crossing,
    side: usize,
    path: &[KnownHit],
    length: f64,
) -> f64 {
    let ends = [0.0, length].map(|away| meet(geometry, crossing, path, (side, away)));
    BESIDE.max(geometry.resolution(&ends[0], &ends[1]))
}

/// Where the end of a path is met on one side of a crossing, so many pixels from it.
fn meet(
    geometry: &Geometry<'_>,
    crossing: &Crossing,
    path: &[KnownHit],
    (side, away): (usize, f64),
) -> Met {
    let depth = path.len() - 1;
    let ray = geometry.ray(&path[..depth], crossing.beside(side, away));
    geometry.meet(&path[depth], ray)
}

/// What each light that nothing opaque is in the way of comes through to the end of a path on one side of a crossing,
/// looked at from this distance in pixels.
fn lit_through(
    geometry: &Geometry<'_>,
    crossing: &Crossing,
    side: usize,
    path: &[KnownHit],
    distance: f64,
) -> Vec<LitThrough> {
    let depth = path.len() - 1;
    let known = &path[depth];
    let layer = crossing.layer;
    let meet = |side: usize| meet(geometry, crossing, path, (side, distance));
    let own = meet(side);
    // At the edge of a shadow nothing else changes, even if another shadow has an edge there.
    let of_others = match layer {
        Layer::Surface(_) => None,
        Layer::Shadow(..) => Some(meet(0)),
    };
    let depth = depth as u32;
    let lights = (0..geometry.edged_lights()).filter(|light| known.blocked >> light & 1 == 0);
    let lit = lights.map(|light| {
        let met = match &of_others {
            Some(of_others) if layer != Layer::Shadow(depth, light as u32) => of_others,
            _ => &own,
        };
        // What is opaque is in the way beside the edge, not at it.
        let (_, surfaces) = geometry.between(light, known, met);
        LitThrough { side, depth, light, surfaces }
    });
    lit.collect()
}

/// The number of the materials that lights come through, of all of them together.
fn filters(geometry: &Geometry<'_>, lit: &[LitThrough]) -> u32 {
    let of_light = |lit: &LitThrough| geometry.filters(lit.light, &lit.surfaces);
    lit.iter().map(of_light).fold(0, u32::wrapping_add)
}
