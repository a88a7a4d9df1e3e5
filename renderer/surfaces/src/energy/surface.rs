//! What the triangles of a mesh cost: edges of other lengths, and neighbours at angles.

use std::collections::BTreeMap;

use ad::differentiable;
use glam::DVec3;

use super::{add, vector};

/// The mean over the edges of the squared difference between their length and the mean length that the edges of
/// the mesh had, relative to that.
#[derive(Clone, Debug)]
pub struct EdgeLengths {
    edges: Vec<[usize; 2]>,
    mean: f64,
}

/// The mean, over the edges between two triangles, of one minus the cosine of the angle between their normals.
#[derive(Clone, Debug)]
pub struct NormalConsistency {
    /// The vertices of each edge and, of the triangle on its left and of that on its right, the third one.
    pairs: Vec<[usize; 4]>,
}

#[differentiable]
fn stretch(a: DVec3, b: DVec3, mean: f64) -> f64 {
    let off = (b - a).length() / mean - 1.0;
    off * off
}

#[differentiable]
fn bend(a: DVec3, b: DVec3, left: DVec3, right: DVec3) -> f64 {
    let first = (b - a).cross(left - a).normalize_or_zero();
    let second = (a - b).cross(right - b).normalize_or_zero();
    1.0 - first.dot(second)
}

/// The edges of triangles, each once, with the third vertex of every triangle that has it and whether that goes
/// along it from the smaller index to the larger one.
fn edges(triangles: &[[u32; 3]]) -> BTreeMap<[usize; 2], Vec<(usize, bool)>> {
    let mut edges: BTreeMap<_, Vec<_>> = BTreeMap::new();
    for triangle in triangles {
        let [a, b, c] = triangle.map(|vertex| vertex as usize);
        for [from, to, third] in [[a, b, c], [b, c, a], [c, a, b]] {
            edges.entry([from.min(to), from.max(to)]).or_default().push((third, from < to));
        }
    }
    edges
}

impl EdgeLengths {
    /// Of a mesh with these vertices and triangles.
    pub fn new(vertices: &[[f64; 3]], triangles: &[[u32; 3]]) -> Self {
        let edges: Vec<_> = edges(triangles).into_keys().collect();
        let length = |[a, b]: &[usize; 2]| DVec3::from(vertices[*a]).distance(vertices[*b].into());
        let mean = edges.iter().map(length).sum::<f64>() / edges.len().max(1) as f64;
        // A mesh without extent has no lengths to keep.
        Self { edges: if mean > 0.0 { edges } else { Vec::new() }, mean }
    }

    /// The energy of these numbers, and its gradient.
    pub fn energy(&self, x: &[f64]) -> (f64, Vec<f64>) {
        let (mut sum, mut gradient) = (0.0, vec![0.0; x.len()]);
        let part = 1.0 / self.edges.len().max(1) as f64;
        for &[a, b] in &self.edges {
            let (value, pullback) = stretch::vjp(vector(x, a), vector(x, b), self.mean);
            let (of_a, of_b, _) = pullback(part);
            sum += part * value;
            add(&mut gradient, a, of_a);
            add(&mut gradient, b, of_b);
        }
        (sum, gradient)
    }
}

impl NormalConsistency {
    /// Of a mesh with these triangles.
    pub fn new(triangles: &[[u32; 3]]) -> Self {
        let pair = |([a, b], thirds): ([usize; 2], Vec<(usize, bool)>)| match thirds[..] {
            [(left, true), (right, false)] | [(right, false), (left, true)] => {
                Some([a, b, left, right])
            }
            // Borders, and edges at which more triangles meet or two that face different ways.
            _ => None,
        };
        Self { pairs: edges(triangles).into_iter().filter_map(pair).collect() }
    }

    /// The energy of these numbers, and its gradient.
    pub fn energy(&self, x: &[f64]) -> (f64, Vec<f64>) {
        let (mut sum, mut gradient) = (0.0, vec![0.0; x.len()]);
        let part = 1.0 / self.pairs.len().max(1) as f64;
        for &pair in &self.pairs {
            let [a, b, left, right] = pair.map(|vertex| vector(x, vertex));
            let (value, pullback) = bend::vjp(a, b, left, right);
            let (a, b, left, right) = pullback(part);
            sum += part * value;
            for (vertex, cotangent) in pair.into_iter().zip([a, b, left, right]) {
                add(&mut gradient, vertex, cotangent);
            }
        }
        (sum, gradient)
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::agrees_with_differences;
    use super::*;

    /// A tetrahedron, out of shape.
    const VERTICES: [[f64; 3]; 4] =
        [[0.0, 0.1, 0.0], [1.3, 0.0, -0.2], [0.2, 0.9, 0.1], [0.3, 0.2, 1.1]];
    const TRIANGLES: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];

    #[test]
    fn gradients_are_those_of_the_energies() {
        let x: Vec<f64> = VERTICES.as_flattened().iter().map(|v| 1.1 * v + 0.05 * v * v).collect();
        let lengths = EdgeLengths::new(&VERTICES, &TRIANGLES);
        agrees_with_differences(&x, |x| lengths.energy(x));
        let normals = NormalConsistency::new(&TRIANGLES);
        assert_eq!(normals.pairs.len(), 6);
        agrees_with_differences(&x, |x| normals.energy(x));
    }

    /// Two squares that meet at a right angle: one of five inner edges is bent, by one.
    #[test]
    fn energies_have_known_values() {
        let vertices: Vec<[f64; 3]> = vec![
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [1.0, 1.0, 0.0],
            [0.0, 1.0, 0.0],
            [1.0, 0.0, 1.0],
            [1.0, 1.0, 1.0],
        ];
        let triangles = [[0, 1, 2], [0, 2, 3], [1, 4, 5], [1, 5, 2]];
        let normals = NormalConsistency::new(&triangles);
        let (value, _) = normals.energy(vertices.as_flattened());
        assert!((value - 1.0 / 3.0).abs() < 1e-12, "{value}");
        // Twice as large everywhere: each edge is off by its own length over the mean.
        let lengths = EdgeLengths::new(&vertices, &triangles);
        let twice: Vec<f64> = vertices.as_flattened().iter().map(|v| 2.0 * v).collect();
        let mean = (7.0 + 2.0 * 2.0_f64.sqrt()) / 9.0;
        let squared = |length: f64| (2.0 * length / mean - 1.0).powi(2);
        let expected = (7.0 * squared(1.0) + 2.0 * squared(2.0_f64.sqrt())) / 9.0;
        let (value, _) = lengths.energy(&twice);
        assert!((value - expected).abs() < 1e-12, "{value} {expected}");
    }

    /// Triangles and edges that have collapsed to a point have a value and a gradient.
    #[test]
    fn collapsed_triangles_are_finite() {
        let collapsed = [0.5; 12];
        for (value, gradient) in [
            EdgeLengths::new(&VERTICES, &TRIANGLES).energy(&collapsed),
            NormalConsistency::new(&TRIANGLES).energy(&collapsed),
        ] {
            assert!((value - 1.0).abs() < 1e-12);
            assert!(gradient.iter().all(|number| *number == 0.0));
        }
    }
}
