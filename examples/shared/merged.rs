//! All objects of a mesh file as one.

use std::path::Path;

use glam::DVec3;
use renderer::Error;
use renderer::files::load_mesh;

/// Vertices, and the indices of the corners of triangles.
pub type Shape = (Vec<[f64; 3]>, Vec<[u32; 3]>);

/// The vertices and triangles of all meshes of a file.
pub fn merged(path: &Path) -> Result<Shape, Error> {
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    for mesh in load_mesh(path)?.meshes {
        let first = vertices.len() as u32;
        vertices.extend(&mesh.vertices);
        triangles.extend(mesh.triangles.iter().map(|t| t.map(|corner| first + corner)));
    }
    Ok((vertices, triangles))
}

/// Moves the middle of the box around vertices to zero, and multiplies them by what a function makes of
/// half the diagonal of the box and of the farthest vertex.
pub fn normalize(vertices: &mut [[f64; 3]], factor: impl FnOnce(DVec3, f64) -> f64) {
    let corners = || vertices.iter().map(|&vertex| DVec3::from(vertex));
    let low = corners().fold(DVec3::INFINITY, DVec3::min);
    let high = corners().fold(DVec3::NEG_INFINITY, DVec3::max);
    let middle = low.midpoint(high);
    let reach = corners().map(|corner| corner.distance(middle)).fold(0.0, f64::max);
    let factor = factor(0.5 * (high - low), reach);
    for vertex in vertices {
        *vertex = ((DVec3::from(*vertex) - middle) * factor).to_array();
    }
}
