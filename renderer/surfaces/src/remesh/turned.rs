//! Triangles that face the wrong way.

use renderer_core::scene::Mesh;

use super::surface::{Edge, Surface};

/// How many triangles of a mesh are turned over: their normals point against those of two or three of their neighbours.
///
/// # Panics
///
/// If a triangle names a vertex that is not there.
pub fn turned_over(mesh: &Mesh) -> usize {
    let surface = Surface::new(mesh);
    let is_turned = |&[a, b, c]: &[u32; 3]| {
        let normal = surface.normal_of([a, b, c]);
        let is_against = |&[from, to]: &[u32; 2]| match surface.edge(from, to) {
            Edge::Inner(_, other) | Edge::Line(_, Some(other)) => {
                surface.normal(other.triangle).dot(normal) < 0.0
            }
            _ => false,
        };
        [[a, b], [b, c], [c, a]].iter().filter(|edge| is_against(edge)).count() >= 2
    };
    mesh.triangles.iter().filter(|corners| is_turned(corners)).count()
}
