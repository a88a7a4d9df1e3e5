//! How much the vertices of a mesh differ from their neighbours.
//!
//! A gradient moves each vertex by itself, as far as pixels say and no farther: thousands of vertices become
//! shards. The Laplacian of the mesh ties neighbours, as a term of the loss ([`energy`](Laplacian::energy)) or
//! as a change of coordinates ([`System`]) that has the same minima and smoother ways there.

mod system;

use std::collections::BTreeMap;

use glam::DVec3;
use serde::{Deserialize, Serialize};

pub use system::System;

/// How neighbours count.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Weights {
    /// All the same: what differs is the mesh, and triangles become alike.
    #[default]
    Uniform,
    /// By half of the sum of the cotangents of the angles that face the edge (Pinkall and Polthier, "Computing
    /// Discrete Minimal Surfaces and Their Conjugates", 1993), of the vertices as they are given: what differs
    /// is the surface, and triangles keep their shapes. Weights below zero, of edges between obtuse angles,
    /// count as zero, as do those of triangles without area.
    Cotangent,
}

/// The edges of a mesh with their weights.
#[derive(Clone, Debug, PartialEq)]
pub struct Laplacian {
    count: usize,
    /// Each edge once: two vertices and a weight, 0 or more.
    edges: Vec<(u32, u32, f64)>,
    /// By vertex: the sum of the weights of its edges.
    degrees: Vec<f64>,
}

impl Laplacian {
    /// Of a mesh with these vertices.
    ///
    /// # Panics
    ///
    /// If a triangle names a vertex that is not there.
    pub fn new(vertices: &[[f64; 3]], triangles: &[[u32; 3]], weights: Weights) -> Self {
        let mut edges: BTreeMap<(u32, u32), f64> = BTreeMap::new();
        for &[a, b, c] in triangles {
            for [from, to, across] in [[a, b, c], [b, c, a], [c, a, b]] {
                let sum = edges.entry((from.min(to), from.max(to))).or_default();
                match weights {
                    Weights::Uniform => *sum = 1.0,
                    Weights::Cotangent => {
                        let at = |vertex: u32| DVec3::from(vertices[vertex as usize]);
                        let (u, v) = (at(from) - at(across), at(to) - at(across));
                        let sine = u.cross(v).length();
                        *sum += if sine > 0.0 { 0.5 * u.dot(v) / sine } else { 0.0 };
                    }
                }
            }
        }
        let count = vertices.len();
        let edges: Vec<_> =
            edges.into_iter().map(|((a, b), weight)| (a, b, weight.max(0.0))).collect();
        let mut degrees = vec![0.0; count];
        for &(a, b, weight) in &edges {
            degrees[a as usize] += weight;
            degrees[b as usize] += weight;
        }
        Self { count, edges, degrees }
    }

    /// The mean over the vertices of the squared distance between a vertex and the weighted mean of its
    /// neighbours, and its gradient by `x`, the coordinates of all vertices. A vertex without neighbours
    /// counts as being in their middle.
    ///
    /// # Panics
    ///
    /// If there are not three numbers for each vertex.
    pub fn energy(&self, x: &[f64]) -> (f64, Vec<f64>) {
        assert_eq!(x.len(), 3 * self.count, "three numbers for each vertex");
        let mut differences = self.apply(x);
        let of_vertex = |index: usize| self.degrees[index / 3];
        for (index, difference) in differences.iter_mut().enumerate() {
            let degree = of_vertex(index);
            *difference = if degree > 0.0 { *difference / degree } else { 0.0 };
        }
        let scale = 1.0 / self.count.max(1) as f64;
        let value = scale * differences.iter().map(|value| value * value).sum::<f64>();
        for (index, difference) in differences.iter_mut().enumerate() {
            let degree = of_vertex(index);
            *difference = if degree > 0.0 { 2.0 * scale * *difference / degree } else { 0.0 };
        }
        // The matrix is symmetric.
        (value, self.apply(&differences))
    }

    /// Of every vertex the weighted sum of its differences from its neighbours.
    fn apply(&self, x: &[f64]) -> Vec<f64> {
        let mut sums = vec![0.0; x.len()];
        for &(a, b, weight) in &self.edges {
            for axis in 0..3 {
                let (a, b) = (3 * a as usize + axis, 3 * b as usize + axis);
                let difference = weight * (x[a] - x[b]);
                sums[a] += difference;
                sums[b] -= difference;
            }
        }
        sums
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A bent strip, and a vertex that no triangle has.
    pub(super) fn strip() -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
        let vertex =
            |i: usize| [(i / 2) as f64, (i % 2) as f64 + 0.1 * i as f64, (0.7 * i as f64).sin()];
        let triangles =
            (0..7).map(|i| if i % 2 == 0 { [i, i + 1, i + 2] } else { [i + 1, i, i + 2] });
        (((0..10).map(vertex)).collect(), triangles.collect())
    }

    #[test]
    fn the_gradient_is_that_of_the_energy() {
        let (vertices, triangles) = strip();
        for weights in [Weights::Uniform, Weights::Cotangent] {
            let laplacian = Laplacian::new(&vertices, &triangles, weights);
            let x: Vec<f64> =
                vertices.iter().flatten().map(|v| 1.1 * v + 0.2 * (3.0 * v).sin()).collect();
            let (value, gradient) = laplacian.energy(&x);
            assert!(value > 0.0);
            for index in 0..x.len() {
                let at = |by: f64| {
                    let mut x = x.clone();
                    x[index] += by;
                    laplacian.energy(&x).0
                };
                let difference = (at(1e-5) - at(-1e-5)) / 2e-5;
                let error = (gradient[index] - difference).abs();
                assert!(error < 1e-9, "{weights:?} {index}: {} {difference}", gradient[index]);
            }
        }
    }

    /// Cotangents know a plane when they see one, however its triangles lie; equal weights know equal ones.
    #[test]
    fn a_plane_costs_nothing_in_its_middle() {
        let corners = [[0.0, 0.0], [2.0, 0.1], [2.2, 1.7], [0.3, 2.0], [1.1, 0.8]];
        let vertices: Vec<[f64; 3]> = corners.map(|[x, y]| [x, y, 0.5 * x - y]).to_vec();
        let triangles = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];
        let laplacian = Laplacian::new(&vertices, &triangles, Weights::Cotangent);
        let x: Vec<f64> = vertices.iter().flatten().copied().collect();
        let middle = |laplacian: &Laplacian| {
            let edges = laplacian.edges.iter().filter(|(_, b, _)| *b == 4);
            let pull = |axis: usize| -> f64 {
                edges.clone().map(|&(a, _, w)| w * (x[3 * a as usize + axis] - x[12 + axis])).sum()
            };
            DVec3::new(pull(0), pull(1), pull(2)).length()
        };
        assert!(middle(&laplacian) < 1e-12);
        assert!(middle(&Laplacian::new(&vertices, &triangles, Weights::Uniform)) > 0.01);
    }
}
