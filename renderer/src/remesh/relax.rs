//! Vertices to the middle of their neighbours.

use glam::DVec3;

use super::surface::{LEAST_WIDTH, Surface, are_alike, width};

/// Moves each vertex within its tangent plane to the mean of its neighbours, one after the other, unless a triangle
/// would turn over or become narrow, or the surface fold.
pub(super) fn relax(surface: &mut Surface) {
    for vertex in 0..surface.points.len() as u32 {
        if surface.is_fixed[vertex as usize] || surface.around(vertex).is_empty() {
            continue;
        }
        let old = surface.points[vertex as usize];
        let shapes = |surface: &Surface| -> Vec<(DVec3, f64)> {
            let shape = |&triangle: &u32| {
                let places = surface.places(surface.triangles[triangle as usize]);
                (surface.normal(triangle), width(places))
            };
            surface.around(vertex).iter().map(shape).collect()
        };
        let before = shapes(surface);
        let normal = before.iter().map(|(normal, _)| normal).sum::<DVec3>().normalize_or_zero();
        let neighbours = surface.neighbours(vertex);
        let sum: DVec3 =
            neighbours.iter().map(|&neighbour| surface.points[neighbour as usize] - old).sum();
        let way = sum / neighbours.len() as f64;
        let is_folded = |surface: &Surface| {
            let around = surface.around(vertex);
            let corners: Vec<_> =
                around.iter().map(|&triangle| surface.triangles[triangle as usize]).collect();
            surface.has_folds(around, &corners, |corner| surface.points[corner as usize])
        };
        let was_folded = is_folded(surface);
        surface.points[vertex as usize] = old + (way - normal * normal.dot(way));
        let is_kept = |(&(before, narrow), (after, wide)): (&(DVec3, f64), (DVec3, f64))| {
            (before == DVec3::ZERO || are_alike(before, after)) && wide >= narrow.min(LEAST_WIDTH)
        };
        if !before.iter().zip(shapes(surface)).all(is_kept) || !was_folded && is_folded(surface) {
            surface.points[vertex as usize] = old;
        }
    }
}
