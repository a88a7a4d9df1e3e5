//! Triangles that go through others.

use std::time::Duration;

use glam::DVec3;
use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb;
use obvhs::bvh2::builder::build_bvh2;
use rayon::prelude::*;
use renderer_core::scene::Mesh;
use robust::{Coord3D, orient3d};

/// How many triangles of a mesh intersect another one that they share no vertex with: an edge of one of the two goes
/// through the other, or through its border. What merely touches a plane, with a vertex or all of itself, goes through
/// nothing; so seams whose vertices a mesh has twice count for nothing. The signs that decide are exact.
///
/// # Panics
///
/// If a triangle names a vertex that is not there.
pub fn self_intersecting(mesh: &Mesh) -> usize {
    let places = |corners: &[u32; 3]| corners.map(|corner| mesh.vertices[corner as usize].into());
    let triangles: Vec<[DVec3; 3]> = mesh.triangles.iter().map(places).collect();
    // Boxes that overlap still do when they are rounded.
    let bounds = |corners: &[DVec3; 3]| Aabb::from_points(&corners.map(|place| place.as_vec3a()));
    let boxes: Vec<Aabb> = triangles.iter().map(bounds).collect();
    let hierarchy = build_bvh2(&boxes, BvhBuildParams::fastest_build(), &mut Duration::default());
    let is_crossed = |&index: &usize| {
        let crosses = |other: usize| {
            let own = &mesh.triangles[index];
            !mesh.triangles[other].iter().any(|corner| own.contains(corner))
                && do_cross(&triangles[index], &triangles[other])
        };
        let mut is_found = false;
        hierarchy.aabb_traverse(boxes[index], |hierarchy, node| {
            let node = &hierarchy.nodes[node as usize];
            let members = node.first_index as usize..(node.first_index + node.prim_count) as usize;
            let mut members = hierarchy.primitive_indices[members].iter();
            is_found = members.any(|&other| crosses(other as usize));
            !is_found
        });
        is_found
    };
    (0..triangles.len()).into_par_iter().filter(is_crossed).count()
}

/// Whether an edge of one triangle goes through the other.
fn do_cross(one: &[DVec3; 3], other: &[DVec3; 3]) -> bool {
    let edges = |[a, b, c]: [DVec3; 3]| [[a, b], [b, c], [c, a]];
    edges(*one).into_iter().any(|edge| goes_through(edge, other))
        || edges(*other).into_iter().any(|edge| goes_through(edge, one))
}

/// Whether the ends of an edge are on both sides of the plane of a triangle, and it goes through that or its border.
fn goes_through([p, q]: [DVec3; 2], &[a, b, c]: &[DVec3; 3]) -> bool {
    let (above, below) = (side(a, b, c, p), side(a, b, c, q));
    if !(above > 0.0 && below < 0.0 || above < 0.0 && below > 0.0) {
        return false;
    }
    let turns = [side(p, q, a, b), side(p, q, b, c), side(p, q, c, a)];
    turns.iter().all(|&turn| turn >= 0.0) || turns.iter().all(|&turn| turn <= 0.0)
}

/// The side of the plane through three points that another is on: above 0, below it, or 0 in the plane.
fn side(a: DVec3, b: DVec3, c: DVec3, point: DVec3) -> f64 {
    let [a, b, c, point] = [a, b, c, point].map(|DVec3 { x, y, z }| Coord3D { x, y, z });
    orient3d(a, b, c, point)
}
