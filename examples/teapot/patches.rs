//! The Utah teapot (Newell 1975) as 32 bicubic Bezier patches, and triangles on them.
//!
//! The published control points are those of two profiles, which turn around the axis in quarter
//! circles, and of two tubes. Lengths are Newell's, the height scaled by 3/4 as Blinn did; y is up.

use glam::{DVec3, dvec3};

/// Distances of a cubic Bezier quarter circle's inner control points, as published.
const QUARTER_CIRCLE: f64 = 0.56;

/// The lid: radius and height of the control points of two curves, the last point of one being the
/// first of the next.
const LID: [[f64; 2]; 7] =
    [[0.0, 3.15], [0.8, 3.15], [0.0, 2.85], [0.2, 2.7], [0.4, 2.55], [1.3, 2.55], [1.3, 2.4]];

/// The rim, the body above and below its widest, and the bottom: four curves.
const BODY: [[f64; 2]; 13] = [
    [1.4, 2.4],
    [1.3375, 2.53125],
    [1.4375, 2.53125],
    [1.5, 2.4],
    [1.75, 1.875],
    [2.0, 1.35],
    [2.0, 0.9],
    [2.0, 0.45],
    [1.5, 0.225],
    [1.5, 0.15],
    [1.5, 0.075],
    [1.425, 0.0],
    [0.0, 0.0],
];

/// A control polygon around a tube: its inner and its outer edge (x and y), and half its width.
type Ring = ([f64; 2], [f64; 2], f64);

const HANDLE: [Ring; 7] = [
    ([-1.6, 2.025], [-1.5, 2.25], 0.3),
    ([-2.3, 2.025], [-2.5, 2.25], 0.3),
    ([-2.7, 2.025], [-3.0, 2.25], 0.3),
    ([-2.7, 1.8], [-3.0, 1.8], 0.3),
    ([-2.7, 1.575], [-3.0, 1.35], 0.3),
    ([-2.5, 1.125], [-2.65, 0.9375], 0.3),
    ([-2.0, 0.9], [-1.9, 0.6], 0.3),
];

const SPOUT: [Ring; 7] = [
    ([1.7, 1.425], [1.7, 0.6], 0.66),
    ([2.6, 1.425], [3.1, 0.825], 0.66),
    ([2.3, 2.1], [2.4, 2.025], 0.25),
    ([2.7, 2.4], [3.3, 2.4], 0.25),
    ([2.8, 2.475], [3.525, 2.49375], 0.25),
    ([2.9, 2.475], [3.45, 2.5125], 0.15),
    ([2.8, 2.4], [3.2, 2.4], 0.15),
];

/// Four curves of four control points.
pub type Patch = [[DVec3; 4]; 4];

/// All patches.
pub fn patches() -> Vec<Patch> {
    let mut patches = Vec::new();
    for profile in [&LID[..], &BODY] {
        for first in (0..profile.len() - 1).step_by(3) {
            let curve = &profile[first..first + 4];
            patches.extend((0..4).map(|quarter| quarter_turn(curve, quarter)));
        }
    }
    for tube in [HANDLE, SPOUT] {
        for first in [0, 3] {
            let rings = &tube[first..first + 4];
            patches.extend([1.0, -1.0].map(|side| half_tube(rings, side)));
        }
    }
    patches
}

/// A curve that turns around the axis by one quarter.
fn quarter_turn(curve: &[[f64; 2]], quarter: usize) -> Patch {
    let k = QUARTER_CIRCLE;
    let arc = [[1.0, 0.0], [1.0, k], [k, 1.0], [0.0, 1.0]];
    std::array::from_fn(|i| {
        let [radius, height] = curve[i];
        arc.map(|[x, z]| {
            let (x, z) = [(x, z), (-z, x), (-x, -z), (z, -x)][quarter];
            dvec3(radius * x, height, radius * z)
        })
    })
}

/// One side of a tube, from its inner to its outer edge.
fn half_tube(rings: &[Ring], side: f64) -> Patch {
    std::array::from_fn(|i| {
        let ([inner_x, inner_y], [outer_x, outer_y], width) = rings[i];
        let z = side * width;
        [
            dvec3(inner_x, inner_y, 0.0),
            dvec3(inner_x, inner_y, z),
            dvec3(outer_x, outer_y, z),
            dvec3(outer_x, outer_y, 0.0),
        ]
    })
}

/// The point of a patch at `u` and `v`, both from 0 to 1.
fn point(patch: &Patch, u: f64, v: f64) -> DVec3 {
    let along_v = patch.map(|curve| cubic(curve, v));
    cubic(along_v, u)
}

fn cubic([a, b, c, d]: [DVec3; 4], t: f64) -> DVec3 {
    let s = 1.0 - t;
    a * (s * s * s) + b * (3.0 * s * s * t) + c * (3.0 * s * t * t) + d * (t * t * t)
}

/// Vertices and triangles: every patch in `n` by `n` quadrilaterals, without the triangles of no area
/// where a patch ends in a point.
pub fn tessellate(patches: &[Patch], n: u32) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    for patch in patches {
        let first = vertices.len() as u32;
        let grid = (0..=n).flat_map(|i| (0..=n).map(move |j| (i, j)));
        let at = |i: u32| f64::from(i) / f64::from(n);
        vertices.extend(grid.map(|(i, j)| point(patch, at(i), at(j)).to_array()));
        let vertex = |i: u32, j: u32| first + i * (n + 1) + j;
        let cells = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
        let halves = cells.flat_map(|(i, j)| {
            let [a, b] = [vertex(i, j), vertex(i, j + 1)];
            let [c, d] = [vertex(i + 1, j), vertex(i + 1, j + 1)];
            [[a, b, c], [b, d, c]]
        });
        triangles.extend(halves.filter(|corners| {
            let [a, b, c] = corners.map(|i| DVec3::from_array(vertices[i as usize]));
            (b - a).cross(c - a).length() > 1e-12
        }));
    }
    (vertices, triangles)
}
