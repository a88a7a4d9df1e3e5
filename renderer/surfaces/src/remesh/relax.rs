//! Vertices to the middle of their neighbours.

use glam::DVec3;

use super::surface::{LEAST_WIDTH, Surface, are_alike, normal, width};

/// Moves each vertex within its tangent plane to the mean of its neighbours, one after the other, unless a triangle
/// would turn over or become narrow, or the surface fold.
pub(super) fn relax(surface: &mut Surface) {
    for vertex in 0..surface.points.len() as u32 {
        if surface.is_fixed[vertex as usize] || surface.around(vertex).is_empty() {
            continue;
        }
        let old = surface.points[vertex as usize];
        let around = surface.around(vertex);
        let corners: Vec<[u32; 3]> =
            around.iter().map(|&triangle| surface.triangles[triangle as usize]).collect();
        let normals = corners.iter().map(|&corners| surface.normal_of(corners));
        let upwards = normals.sum::<DVec3>().normalize_or_zero();
        let neighbours = surface.neighbours(vertex);
        let sum: DVec3 =
            neighbours.iter().map(|&neighbour| surface.points[neighbour as usize] - old).sum();
        let way = sum / neighbours.len() as f64;
        let place = old + (way - upwards * upwards.dot(way));
        let then =
            |corner: u32| if corner == vertex { place } else { surface.points[corner as usize] };
        let is_kept = |&corners: &[u32; 3]| {
            let [before, after] = [surface.places(corners), corners.map(then)];
            let [was, is] = [before, after].map(normal);
            (was == DVec3::ZERO || are_alike(was, is))
                && width(after) >= width(before).min(LEAST_WIDTH)
        };
        if corners.iter().all(is_kept) && !surface.adds_folds(around, &corners, then) {
            surface.points[vertex as usize] = place;
        }
    }
}
