//! A packet against the triangles of a leaf.
//!
//! With the origin at zero, the plane through the origin and an edge (B, C) has the normal
//! (B + C) x (C - B), and the side of it on which a ray lies is a dot product. Both triangles at
//! an edge get normals that are each other's exact negation. Near the edges, where rounding could
//! still decide differently for the triangles around a vertex, the test of single rays decides:
//! what a packet hits is what its rays hit.

use wide::{f32x8, f32x16};

use super::packet::{GROUPS, Goal, Packet};
use super::triangle_test::minor_axes;
use super::triangles::TriangleLeaf;

/// Half a unit in the last place of 1.
const ROUNDING: f32 = 0.5 * f32::EPSILON;

type Vector = [f32x8; 3];

/// The triangles of a leaf as seen from the origin of a packet. Vectors are in the order: depth,
/// then the minor axes.
struct View {
    /// The normals of the planes through the origin and the edge opposite to each corner. On the
    /// inside of the triangle all products with a direction are positive.
    normals: [Vector; 3],
    /// The depth of each corner.
    depths: [f32x8; 3],
    nearest: f32x8,
    /// Products below it may have the wrong sign.
    tolerance: f32x8,
    /// A bit for each triangle that rays may hit.
    facing: u32,
    /// A bit for each triangle that rays may hit, and that contains the origin in its plane as
    /// far as rounding can tell: its normals may point either way.
    edge_on: u32,
}

impl View {
    #[inline]
    fn new(packet: &Packet, leaf: &TriangleLeaf) -> Self {
        let [a, b] = minor_axes(packet.major);
        let origin = [packet.major, a, b].map(|axis| (axis, f32x8::splat(packet.origin[axis])));
        let sign = f32x8::splat(packet.sign);
        let corners = leaf.corners.each_ref().map(|corner| {
            let [depth, a, b] = origin.map(|(axis, origin)| corner[axis] - origin);
            [depth * sign, a, b]
        });
        let [p, q, r] = corners;
        let edges = [sub(r, q), sub(p, r), sub(q, p)];
        let sums = [add(q, r), add(r, p), add(p, q)];
        let mut normals = [0, 1, 2].map(|i| cross(sums[i], edges[i]));

        // Bounds of the rounding errors: of the normals and their products with directions, and
        // of the test of single rays. Twelve multiplications and additions, each rounded, of terms
        // that are not larger than reach * size * slope.
        let reach = greatest(p).fast_max(greatest(q)).fast_max(greatest(r));
        let size = greatest(edges[0]).fast_max(greatest(edges[1])).fast_max(greatest(edges[2]));
        let steepest = packet.range.iter().flatten().fold(0.0, |s: f32, slope| s.max(slope.abs()));
        let factor = 42.0 * (1.0 + 2.0 * steepest) + 12.0 * steepest * (1.0 + steepest);
        let tolerance = f32x8::splat(factor * ROUNDING) * reach * size;

        // On which side of the triangle the origin is.
        let volume = dot(cross(edges[2], edges[1]), p);
        let sure = volume.abs().simd_gt(f32x8::splat(64.0 * ROUNDING) * reach * size * size);
        let flip = volume.simd_ge(f32x8::ZERO).select(f32x8::splat(-0.0), f32x8::ZERO);
        for component in normals.iter_mut().flatten() {
            *component ^= flip;
        }

        let depths = [p[0], q[0], r[0]];
        let nearest = depths[0].fast_min(depths[1]).fast_min(depths[2]);
        let farthest = depths[0].fast_max(depths[1]).fast_max(depths[2]);
        let near = nearest.simd_lt(f32x8::splat(packet.far)) & farthest.simd_gt(f32x8::ZERO);
        let mut facing = near & sure;
        for [depth, a, b] in normals {
            // The greatest product that any slopes in range have, rounded as it is for a ray.
            let [a_range, b_range] = packet.range.map(|range| range.map(f32x8::splat));
            let product = b_range[0].mul_add(b, depth).fast_max(b_range[1].mul_add(b, depth));
            let product = a_range[0].mul_add(a, product).fast_max(a_range[1].mul_add(a, product));
            facing &= product.simd_ge(-tolerance);
        }
        let near = near.to_bitmask() & leaf.mask;
        Self {
            normals,
            depths,
            nearest,
            tolerance,
            facing: facing.to_bitmask() & leaf.mask,
            edge_on: near & !sure.to_bitmask(),
        }
    }
}

/// Tests a packet against the triangles of a leaf.
#[inline]
pub fn test_leaf(packet: &mut Packet, leaf: &TriangleLeaf, goal: &mut impl Goal) {
    let view = View::new(packet, leaf);
    let mut bits = view.facing | view.edge_on;
    let mut hit = false;
    while bits != 0 {
        let triangle = bits.trailing_zeros() as usize & 7;
        bits &= bits - 1;
        let edge_on = view.edge_on >> triangle & 1 != 0;
        hit |= test_triangle(packet, leaf, &view, triangle, edge_on, goal);
    }
    if hit {
        packet.update_far();
    }
}

/// Tests a packet against one triangle; whether any ray hit it.
#[inline]
fn test_triangle(
    packet: &mut Packet,
    leaf: &TriangleLeaf,
    view: &View,
    triangle: usize,
    edge_on: bool,
    goal: &mut impl Goal,
) -> bool {
    let splat = |lanes: &f32x8| f32x16::splat(lanes.as_array()[triangle]);
    let normals = view.normals.each_ref().map(|normal| normal.each_ref().map(splat));
    let nearest = splat(&view.nearest);
    let tolerance = splat(&view.tolerance);
    let mut any = false;
    for group in 0..GROUPS {
        let (slope_a, slope_b) = (packet.slope[0][group], packet.slope[1][group]);
        let [u, v, w] = normals.map(|[depth, a, b]| slope_a.mul_add(a, slope_b.mul_add(b, depth)));
        let low = u.fast_min(v).fast_min(w);
        let mut reached = low.simd_ge(-tolerance);
        if edge_on {
            reached |= u.fast_max(v).fast_max(w).simd_le(tolerance);
        }
        let reached = reached & nearest.simd_lt(packet.depth[group]);
        if !reached.any() {
            continue;
        }
        let [p, q, r] = view.depths.each_ref().map(splat);
        let inverse = f32x16::ONE / (u + v + w);
        let mut depth = (u * inverse) * p + (v * inverse) * q + (w * inverse) * r;
        let unsure = if edge_on { reached } else { reached & low.simd_le(tolerance) };
        let mut unsure = unsure.to_bitmask();
        while unsure != 0 {
            let lane = unsure.trailing_zeros() as usize & 15;
            unsure &= unsure - 1;
            let test = packet.triangle_test(group, lane);
            depth.as_mut_array()[lane] = test.depth(leaf.triangle(triangle));
        }
        let hit = reached & depth.simd_lt(packet.depth[group]);
        if hit.any() {
            any = true;
            goal.record(packet, group, hit, depth, leaf.ids[triangle]);
        }
    }
    any
}

#[inline]
fn add(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

#[inline]
fn sub(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline]
fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[inline]
fn dot(a: Vector, b: Vector) -> f32x8 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The greatest magnitude of a component.
#[inline]
fn greatest(a: Vector) -> f32x8 {
    a[0].abs().fast_max(a[1].abs()).fast_max(a[2].abs())
}
