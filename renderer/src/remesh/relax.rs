//! Vertices to the middle of their neighbours.

use glam::DVec3;

use super::surface::{Surface, are_alike};

/// Moves each vertex within its tangent plane to the mean of its neighbours, one after the other, unless a triangle
/// would turn over.
pub(super) fn relax(surface: &mut Surface) {
    for vertex in 0..surface.points.len() as u32 {
        if surface.is_fixed[vertex as usize] || surface.around(vertex).is_empty() {
            continue;
        }
        let old = surface.points[vertex as usize];
        let before: Vec<DVec3> =
            surface.around(vertex).iter().map(|&triangle| surface.normal(triangle)).collect();
        let normal = before.iter().sum::<DVec3>().normalize_or_zero();
        let neighbours = surface.neighbours(vertex);
        let sum: DVec3 =
            neighbours.iter().map(|&neighbour| surface.points[neighbour as usize] - old).sum();
        let way = sum / neighbours.len() as f64;
        surface.points[vertex as usize] = old + (way - normal * normal.dot(way));
        let mut after = surface.around(vertex).iter().map(|&triangle| surface.normal(triangle));
        if !before.iter().all(|&before| {
            after.next().is_some_and(|after| before == DVec3::ZERO || are_alike(before, after))
        }) {
            surface.points[vertex as usize] = old;
        }
    }
}
