//! Traversal with sixteen rays that have nothing in common.
//!
//! The boxes of a node are tested against one ray in each lane; so are the triangles of a leaf, unless it has
//! more of them than there are rays, which then come one after the other. Where few of the rays are left, each goes on by itself, against the boxes
//! of a node side by side (Benthin, Wald, Woop, Ernst & Mark, "Combining Single and Packet-Ray Tracing for
//! Arbitrary Ray Distributions", 2012).

use glam::Vec3;
use wide::f32x16;

use super::batch::Batch;
use super::node::{Child, Kind, Node};
use super::packet::{greatest, rays};
use super::single::{BoxTest, SLAB_ERROR};
use super::stack::{Entry, Sorted};
use super::tree::Tree;
use super::triangle_leaf::TriangleLeaf;
use super::triangle_test::TriangleTest;
use crate::counts::count;

/// How many rays are few.
const FEW: u32 = 3;

/// Up to sixteen rays, prepared.
pub struct Sixteen {
    tests: [TriangleTest; 16],
    /// What the tests hold, side by side; coordinates along the major axis and the two after it.
    is_x: f32x16,
    is_z: f32x16,
    origin: [f32x16; 3],
    sign: f32x16,
    slope: [f32x16; 2],
    /// By axis: the origins as seen by planes of low coordinates, then by those of high ones.
    low_origin: [f32x16; 3],
    high_origin: [f32x16; 3],
    /// 1 over the directions, which have the length 1 on their major axes.
    inverse: [f32x16; 3],
    /// Before which depth a hit counts; -1 for rays that want none.
    limit: f32x16,
}

impl Sixteen {
    /// Prepares some rays of a batch. `limit` gives their limits, in lengths of their directions.
    #[inline]
    pub fn new(batch: &Batch, chosen: &[usize], limit: impl Fn(usize) -> f32) -> Self {
        let gather = |from: &[f32; 64]| {
            let mut lanes = [0.0; 16];
            for (lane, &ray) in lanes.iter_mut().zip(chosen) {
                *lane = from[ray % 64];
            }
            f32x16::new(lanes)
        };
        let Batch { origins, directions, .. } = batch;
        let origin = [gather(&origins.x), gather(&origins.y), gather(&origins.z)];
        let direction = [gather(&directions.x), gather(&directions.y), gather(&directions.z)];
        let size = direction.map(f32x16::abs);
        let is_x = size[0].simd_ge(size[1]) & size[0].simd_ge(size[2]);
        let is_z = !is_x & size[2].simd_gt(size[1]);
        let along = |v: [f32x16; 3], offset: usize| along(is_x, is_z, v, offset);
        let length = along(size, 0);
        let is_ray = (size[0] + size[1] + size[2]).is_finite() & length.simd_ge(f32::MIN_POSITIVE);
        let scale = f32x16::ONE / length;
        let sign = f32x16::ONE.copysign(along(direction, 0));
        let slope = [along(direction, 1) * scale, along(direction, 2) * scale];
        let major = is_z.select(f32x16::splat(2.0), f32x16::ONE);
        let major = is_x.select(f32x16::ZERO, major).to_array();
        let tests = std::array::from_fn(|lane| TriangleTest {
            origin: Vec3::from(origin.map(|along| along.as_array()[lane])),
            major: major[lane] as usize,
            sign: sign.as_array()[lane],
            slope: slope.map(|slope| slope.as_array()[lane]),
            scale: scale.as_array()[lane],
        });

        // As for single rays.
        let slack = origin.map(f32x16::abs);
        let slack = slack[0].fast_max(slack[1]).fast_max(slack[2]);
        let slack = slack * f32x16::splat(4.0 * f32::EPSILON);
        let inverse = direction.map(|d| {
            let d = d * scale;
            f32x16::ONE / d.abs().fast_max(f32x16::splat(1e-12)).copysign(d)
        });
        let mut limits = [-1.0; 16];
        for (lane, &ray) in limits.iter_mut().zip(chosen) {
            *lane = limit(ray);
        }
        let limit = is_ray.select(f32x16::new(limits) * length, f32x16::splat(-1.0));
        Self {
            tests,
            is_x,
            is_z,
            origin: [0, 1, 2].map(|offset| along(origin, offset)),
            sign,
            slope,
            low_origin: origin.map(|origin| origin + slack),
            high_origin: origin.map(|origin| origin - slack),
            inverse,
            limit,
        }
    }

    /// The depths at which rays enter the box of a child, infinite for those that do not before their
    /// limits.
    #[inline]
    fn enter(&self, node: &Node, slot: usize, limit: f32x16) -> f32x16 {
        let (mut near, mut far) = (f32x16::ZERO, f32x16::INFINITY);
        for axis in 0..3 {
            let plane = |side: usize| f32x16::splat(node.bounds[axis][side].as_array()[slot]);
            let low = (plane(0) - self.low_origin[axis]) * self.inverse[axis];
            let high = (plane(1) - self.high_origin[axis]) * self.inverse[axis];
            near = near.fast_max(low.fast_min(high));
            far = far.fast_min(low.fast_max(high));
        }
        let far = (far * f32x16::splat(1.0 + SLAB_ERROR)).fast_min(limit);
        near.simd_le(far).select(near, f32x16::INFINITY)
    }

    /// The depths at which rays meet a triangle of a leaf, with the roundings of [`TriangleTest::depths`], and
    /// a bit for each that does before its limit.
    #[inline]
    fn depths(&self, leaf: &TriangleLeaf, triangle: usize) -> (f32x16, u32) {
        let [a, b, c] = [0, 1, 2].map(|corner| {
            let corner =
                leaf.corners[corner].map(|axis| f32x16::splat(axis.as_array()[triangle % 8]));
            let from_origin =
                |offset: usize| along(self.is_x, self.is_z, corner, offset) - self.origin[offset];
            let z = from_origin(0) * self.sign;
            [from_origin(1) - self.slope[0] * z, from_origin(2) - self.slope[1] * z, z]
        });
        let u = c[0] * b[1] - c[1] * b[0];
        let v = a[0] * c[1] - a[1] * c[0];
        let w = b[0] * a[1] - b[1] * a[0];
        let (low, high) = (u.fast_min(v).fast_min(w), u.fast_max(v).fast_max(w));
        let zero = f32x16::ZERO;
        let inside = low.simd_ge(zero) | high.simd_le(zero);
        if !inside.any() {
            return (f32x16::INFINITY, 0);
        }
        let inverse = f32x16::ONE / (u + v + w);
        let depth = (u * inverse) * a[2] + (v * inverse) * b[2] + (w * inverse) * c[2];
        let hit = inside & depth.simd_gt(zero);
        let mut depth = hit.select(depth, f32x16::INFINITY);
        let on_edge = u.simd_eq(zero) | v.simd_eq(zero) | w.simd_eq(zero);
        for lane in rays((on_edge & inside).to_bitmask().into()) {
            let test = &self.tests[lane % 16];
            depth.as_mut_array()[lane % 16] = test.depth(leaf.triangle(triangle));
        }
        (depth, depth.simd_lt(self.limit).to_bitmask())
    }
}

/// Coordinates along the axis that is so many after the major one, where this is x or z, or else y.
#[inline(always)]
fn along(is_x: f32x16, is_z: f32x16, v: [f32x16; 3], offset: usize) -> f32x16 {
    let [x, y, z] = [v[offset], v[(1 + offset) % 3], v[(2 + offset) % 3]];
    is_x.select(x, is_z.select(z, y))
}

/// A triangle that a ray meets before its limit.
pub struct Found {
    pub lane: usize,
    pub depth: f32,
    pub primitive: u32,
}

/// A child of a node yet to be visited.
pub struct Waiting {
    /// The depths at which rays enter its box; infinite for those that do not.
    near: f32x16,
    child: Child,
}

impl Tree<TriangleLeaf> {
    /// Calls `found` with triangles that rays meet before their limits, near leaves first, and with the
    /// distances for each unit of depth; it returns a new limit if the triangle counts, and a negative one ends
    /// the ray. The stack is empty before and after.
    #[inline]
    pub fn visit_sixteen(
        &self,
        sixteen: &mut Sixteen,
        stack: &mut Vec<Waiting>,
        mut found: impl FnMut(Found, f32) -> Option<f32>,
    ) {
        stack.push(Waiting { near: f32x16::ZERO, child: Child::node(0) });
        let mut nodes = 0;
        while let Some(Waiting { near, child }) = stack.pop() {
            let inside = near.simd_le(sixteen.limit) & near.simd_lt(f32::INFINITY);
            let lanes = inside.to_bitmask();
            if lanes == 0 {
                continue;
            }
            match child.kind() {
                Kind::Leaf(leaf) => {
                    let leaf = &self.leaves[leaf];
                    if lanes.count_ones() > leaf.mask.count_ones() {
                        for triangle in rays(leaf.mask.into()) {
                            let (depth, hit) = sixteen.depths(leaf, triangle);
                            for lane in rays((hit & lanes).into()) {
                                let depth = depth.as_array()[lane % 16];
                                let primitive = leaf.ids[triangle % 8];
                                let scale = sixteen.tests[lane % 16].scale;
                                if let Some(limit) = found(Found { lane, depth, primitive }, scale)
                                {
                                    sixteen.limit.as_mut_array()[lane % 16] = limit;
                                }
                            }
                        }
                        continue;
                    }
                    for lane in rays(lanes.into()) {
                        let limit = &mut sixteen.limit.as_mut_array()[lane % 16];
                        *limit = one(leaf, lane, &sixteen.tests[lane % 16], *limit, &mut found);
                    }
                }
                Kind::Node(_) if lanes.count_ones() <= FEW => {
                    for lane in rays(lanes.into()) {
                        let test = &sixteen.tests[lane % 16];
                        let limit = &mut sixteen.limit.as_mut_array()[lane % 16];
                        self.visit_below(child, &BoxTest::new(test), *limit, |leaf, before| {
                            *limit = one(leaf, lane, test, before, &mut found);
                            *limit
                        });
                    }
                }
                Kind::Node(index) => {
                    nodes += 1;
                    let node = &self.nodes[index];
                    let limit = inside.select(sixteen.limit, f32x16::splat(-1.0));
                    let mut entered = [f32x16::INFINITY; 8];
                    let mut bits = 0;
                    for (slot, near) in entered.iter_mut().enumerate().take(node.children().len()) {
                        *near = sixteen.enter(node, slot, limit);
                        let is_entered = near.simd_lt(f32::INFINITY).any();
                        bits |= u32::from(is_entered) << slot;
                    }
                    let sorted = Sorted::new(bits, |slot| Entry {
                        near: -greatest(-entered[slot]),
                        target: slot as u32,
                    });
                    stack.extend(sorted.as_slice().iter().map(|entry| {
                        let slot = entry.target as usize % 8;
                        Waiting { near: entered[slot], child: node.children[slot] }
                    }));
                }
            }
        }
        count(|counts| &counts.nodes, nodes);
    }
}

/// Tests the triangles of a leaf against one ray; returns its new limit.
#[inline]
fn one(
    leaf: &TriangleLeaf,
    lane: usize,
    test: &TriangleTest,
    mut limit: f32,
    found: &mut impl FnMut(Found, f32) -> Option<f32>,
) -> f32 {
    let depths = test.depths(leaf);
    for triangle in rays((depths.simd_lt(limit).to_bitmask() & leaf.mask).into()) {
        let (depth, primitive) = (depths.as_array()[triangle % 8], leaf.ids[triangle % 8]);
        if depth < limit
            && let Some(less) = found(Found { lane, depth, primitive }, test.scale)
        {
            limit = less;
        }
    }
    limit
}
