//! Surfaces made of triangles with edges of about one length.
//!
//! Vertices that move far stretch some triangles and crowd others. [`remesh`] gives the surface new ones (Botsch and
//! Kobbelt, "A Remeshing Approach to Multiresolution Modeling", 2004): in a few rounds, edges longer than 4/3 of the
//! length are split, those shorter than 3/5 collapse, edges are flipped where that brings vertices closer to six
//! neighbours, and vertices move within the surface to the middle of their neighbours. Halves of split edges are
//! longer than 3/5: they do not collapse again.
//!
//! What a surface is stays: a closed one stays closed, with as many handles and parts. An edge collapses or flips only
//! if no triangle turns over or becomes almost a line by that, none comes to lie on another, no two parts grow together, and
//! no neighbours face against each other unless some there did before. Turned down: as few as before, at most; where
//! vertices have folded a surface, that keeps its folds.

mod collapse;
mod crossing;
mod flip;
mod relax;
mod split;
mod surface;
#[cfg(test)]
mod tests;
mod turned;

use glam::DVec3;
use renderer_core::Error;
use renderer_core::memory;
use renderer_core::scene::{Mesh, Normals};
use surface::Surface;

pub use crossing::self_intersecting;
pub use turned::turned_over;

/// How often all edges and vertices have their turn.
const ROUNDS: usize = 5;
/// Bytes that a triangle takes on the way.
const TRIANGLE_BYTES: f64 = 400.0;

/// A mesh with new triangles.
#[derive(Clone, Debug, PartialEq)]
pub struct Remeshed {
    /// It has the name, the transform and the shading of the mesh that was given. Vertices that no triangle has are
    /// left out.
    pub mesh: Mesh,
    /// What each vertex is made of: given vertices, in ascending order, with weights that add up to 1.
    pub origins: Vec<Vec<(u32, f64)>>,
}

impl Remeshed {
    /// What each vertex has of something that the given vertices had, `N` numbers each, one after the other.
    pub fn carry<const N: usize>(&self, given: &[f64]) -> Vec<f64> {
        let mean = |origin: &Vec<(u32, f64)>| -> [f64; N] {
            let sum = |axis| origin.iter().map(|&(i, w)| w * given[N * i as usize + axis]).sum();
            std::array::from_fn(sum)
        };
        self.origins.iter().flat_map(mean).collect()
    }
}

/// The surface of a mesh, made of triangles whose edges are about `edge_length` long, in units of its vertices before
/// its transform.
///
/// Borders and lines between materials stay where they are: their vertices neither move nor vanish, and their edges may
/// only be split. Edges at which more than two triangles meet, or two that face different ways, are left as they are.
/// The result is the same bits on any number of threads.
///
/// # Errors
///
/// If the length is not above 0, a vertex is not finite or not there, the mesh has texture coordinates or normals of
/// its own, which new triangles would lack, or so many triangles need more memory than
/// [allowed](renderer_core::memory::limit).
pub fn remesh(mesh: &Mesh, edge_length: f64) -> Result<Remeshed, Error> {
    check(mesh, edge_length)
        .map_err(|problem| Error::new(format_args!("mesh.{}", mesh.name), problem))?;
    let mut surface = Surface::new(mesh);
    for _ in 0..ROUNDS {
        split::split_long(&mut surface, 4.0 / 3.0 * edge_length);
        collapse::collapse_short(&mut surface, 3.0 / 5.0 * edge_length, 4.0 / 3.0 * edge_length);
        flip::even_out(&mut surface);
        relax::relax(&mut surface);
    }
    Ok(surface.finish(mesh))
}

/// The mean length of the edges of a mesh; 0 if it has none.
#[doc(hidden)]
pub fn mean_edge_length(mesh: &Mesh) -> f64 {
    let surface = Surface::new(mesh);
    let edges = surface.edges();
    edges.iter().map(|&edge| surface.length(edge)).sum::<f64>() / edges.len().max(1) as f64
}

/// What is wrong with remeshing, if something is.
#[doc(hidden)]
pub fn check(mesh: &Mesh, edge_length: f64) -> Result<(), String> {
    if !(edge_length > 0.0 && edge_length.is_finite()) {
        return Err(format!("the length of edges must be above 0, is {edge_length}"));
    }
    if mesh.texture_triangles.iter().any(Option::is_some) {
        return Err("has texture coordinates, which new triangles would lack".to_owned());
    }
    if let Normals::Given { .. } = mesh.normals {
        return Err(
            "has normals of its own, which new triangles would lack; \"smooth\" computes them"
                .to_owned(),
        );
    }
    let count = mesh.vertices.len();
    if let Some(vertex) = mesh.triangles.as_flattened().iter().find(|v| **v as usize >= count) {
        return Err(format!("has no vertex {vertex}, which a triangle names"));
    }
    if let Some(vertex) = mesh.vertices.iter().position(|vertex| !DVec3::from(*vertex).is_finite())
    {
        return Err(format!("vertices[{vertex}] is not finite"));
    }
    let triangles: f64 =
        mesh.triangles.iter().map(|corners| pieces(mesh, corners, edge_length)).sum();
    memory::ask((triangles * TRIANGLE_BYTES) as u64).map_err(|problem| {
        format!("with edges {edge_length} long, about {triangles:.0e} triangles: {problem}")
    })
}

/// About how many triangles one becomes.
fn pieces(mesh: &Mesh, corners: &[u32; 3], edge_length: f64) -> f64 {
    let [a, b, c] = corners.map(|corner| DVec3::from(mesh.vertices[corner as usize]) / edge_length);
    let around = a.distance(b) + b.distance(c) + c.distance(a);
    1.0 + around + 2.0 * (b - a).cross(c - a).length()
}
