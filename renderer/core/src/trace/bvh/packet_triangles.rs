//! A packet against the triangles of a leaf.
//!
//! With the origin at zero, the plane through the origin and an edge (B, C) has the normal
//! (B + C) x (C - B), and the side of it on which a ray lies is a dot product. Both triangles at
//! an edge get normals that are each other's exact negation. Near the edges, where rounding could
//! still decide differently for the triangles around a vertex, the test of single rays decides:
//! what a packet hits is what its rays hit.

use wide::{f32x8, f32x16};

use super::packet::{GROUPS, Goal, Packet, Rays};
use super::triangle_leaf::TriangleLeaf;
use super::triangle_test::minor_axes;

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
    /// For each group a bit for each triangle that its rays may hit.
    reachable: Rays<u32>,
    /// A bit for each triangle in whose plane the origin lies as far as rounding can tell: its
    /// normals may point either way.
    edge_on: u32,
}

impl View {
    #[inline(always)]
    fn new(packet: &Packet, leaf: &TriangleLeaf) -> Self {
        let [a, b] = minor_axes(packet.major);
        let relative =
            |corner: &Vector, axis: usize| corner[axis] - f32x8::splat(packet.origin[axis]);
        let sign = f32x8::splat(packet.sign);
        let view = |corner: &Vector| {
            [relative(corner, packet.major) * sign, relative(corner, a), relative(corner, b)]
        };
        let (p, q, r) = (view(&leaf.corners[0]), view(&leaf.corners[1]), view(&leaf.corners[2]));
        let edges = [sub(r, q), sub(p, r), sub(q, p)];
        let mut normals =
            [cross(add(q, r), edges[0]), cross(add(r, p), edges[1]), cross(add(p, q), edges[2])];

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
        let near = near.to_bitmask() & leaf.mask;
        let edge_on = near & !sure.to_bitmask();
        let mut reachable = [0; GROUPS];
        for (g, reachable) in reachable.iter_mut().enumerate() {
            let [a_low, a_high] = packet.group_range[0][g].map(f32x8::splat);
            let [b_low, b_high] = packet.group_range[1][g].map(f32x8::splat);
            // The greatest product that any slopes in range have, rounded as it is for a ray.
            let greatest = |[depth, a, b]: Vector| {
                let product = b_low.mul_add(b, depth).fast_max(b_high.mul_add(b, depth));
                a_low.mul_add(a, product).fast_max(a_high.mul_add(a, product))
            };
            let least =
                greatest(normals[0]).fast_min(greatest(normals[1])).fast_min(greatest(normals[2]));
            *reachable = least.simd_ge(-tolerance).to_bitmask() & near | edge_on;
        }
        Self { normals, depths, nearest, tolerance, reachable, edge_on }
    }
}

/// Tests a packet against the triangles of a leaf.
#[inline]
pub fn test_leaf(packet: &mut Packet, leaf: &TriangleLeaf, goal: &mut impl Goal) {
    let view = View::new(packet, leaf);
    let mut hit = false;
    for group in 0..GROUPS {
        let mut bits = view.reachable[group];
        while bits != 0 {
            let triangle = bits.trailing_zeros() as usize & 7;
            bits &= bits - 1;
            hit |= test_triangle(packet, group, leaf, &view, triangle, goal);
        }
    }
    if hit {
        packet.update_far();
    }
}

/// Tests a group of rays against one triangle; whether any of them hits it.
#[inline(always)]
fn test_triangle(
    packet: &mut Packet,
    group: usize,
    leaf: &TriangleLeaf,
    view: &View,
    triangle: usize,
    goal: &mut impl Goal,
) -> bool {
    let splat = |lanes: &f32x8| f32x16::splat(lanes.as_array()[triangle]);
    let (slope_a, slope_b) = (packet.slope[0][group], packet.slope[1][group]);
    let product =
        |[depth, a, b]: &Vector| slope_a.mul_add(splat(a), slope_b.mul_add(splat(b), splat(depth)));
    let (u, v, w) =
        (product(&view.normals[0]), product(&view.normals[1]), product(&view.normals[2]));
    let tolerance = splat(&view.tolerance);
    let low = u.fast_min(v).fast_min(w);
    let edge_on = view.edge_on >> triangle & 1 != 0;
    let mut reached = low.simd_ge(-tolerance);
    if edge_on {
        reached |= u.fast_max(v).fast_max(w).simd_le(tolerance);
    }
    let reached = reached & splat(&view.nearest).simd_lt(packet.depth[group]);
    if !reached.any() {
        return false;
    }

    let [p, q, r] = &view.depths;
    let inverse = f32x16::ONE / (u + v + w);
    let mut depth = (u * inverse) * splat(p) + (v * inverse) * splat(q) + (w * inverse) * splat(r);
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
        goal.record(packet, group, hit, depth, leaf.ids[triangle]);
        return true;
    }
    false
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
