//! Traversal with sixteen rays that have nothing in common.
//!
//! The boxes of a node are tested against one ray in each lane; so are the triangles of a leaf, unless it has
//! more of them than there are rays, which then come one after the other. Where few of the rays are left, each
//! goes on by itself, against the boxes of a node side by side (Benthin, Wald, Woop, Ernst & Mark, "Combining
//! Single and Packet-Ray Tracing for Arbitrary Ray Distributions", 2012).
//!
//! Turned down: the rays of four or eight samples sorted together, which took 4 to 12 % less time, and sixteen that
//! have their major axis in common, 3 to 9 % less; neither is 3 % of an image.

use glam::Vec3;
use wide::{f32x8, f32x16, u32x16};

use super::batch::Batch;
use super::node::{Child, Kind, Node};
use super::packet::{NO_PRIMITIVE, PACKET_RAYS, greatest, rays};
use super::single::{BoxTest, SLAB_ERROR};
use super::stack::{Entry, Sorted};
use super::tree::Tree;
use super::triangle_leaf::TriangleLeaf;
use super::triangle_test::{TriangleTest, minor_axes};
use crate::counts::count;

/// How many rays are few.
const FEW: u32 = 3;

/// Up to sixteen rays, prepared.
pub struct Sixteen {
    /// Where the major axis is x, and where it is z.
    is_x: f32x16,
    is_z: f32x16,
    /// What [`TriangleTest`] holds, side by side; coordinates along the major axis and the two after it.
    origin: [f32x16; 3],
    sign: f32x16,
    slope: [f32x16; 2],
    scale: f32x16,
    /// By axis: the origins as seen by planes of low coordinates, then by those of high ones.
    low_origin: [f32x16; 3],
    high_origin: [f32x16; 3],
    /// 1 over the directions, which have the length 1 on their major axes.
    inverse: [f32x16; 3],
    /// Before which depth a hit counts; -1 for rays that want none, or no more.
    limit: f32x16,
    /// The primitives that do not count.
    but: [u32x16; 2],
    /// What was hit last, or [`NO_PRIMITIVE`].
    primitive: u32x16,
}

impl Sixteen {
    /// Prepares some rays of a batch, with limits in lengths of their directions and, beside those that they start
    /// on, primitives that do not count.
    #[inline]
    pub fn new(
        batch: &Batch,
        chosen: &[usize],
        limits: &[f32; PACKET_RAYS],
        targets: &[u32; PACKET_RAYS],
    ) -> Self {
        let Batch { origins, directions, from, .. } = batch;
        let origin = [&origins.x, &origins.y, &origins.z].map(|along| gather(along, chosen, 0.0));
        let direction =
            [&directions.x, &directions.y, &directions.z].map(|along| gather(along, chosen, 0.0));
        let size = direction.map(f32x16::abs);
        let is_x = size[0].simd_ge(size[1]) & size[0].simd_ge(size[2]);
        let is_z = !is_x & size[2].simd_gt(size[1]);
        let along = |v: [f32x16; 3], offset: usize| along(is_x, is_z, v, offset);
        let length = along(size, 0);
        let is_ray = (size[0] + size[1] + size[2]).is_finite() & length.simd_ge(f32::MIN_POSITIVE);
        let scale = f32x16::ONE / length;

        // As for single rays.
        let slack = origin.map(f32x16::abs);
        let slack = slack[0].fast_max(slack[1]).fast_max(slack[2]);
        let slack = slack * f32x16::splat(4.0 * f32::EPSILON);
        let inverse = direction.map(|d| {
            let d = d * scale;
            f32x16::ONE / d.abs().fast_max(f32x16::splat(1e-12)).copysign(d)
        });
        let limit: f32x16 = gather(limits, chosen, -1.0);
        Self {
            is_x,
            is_z,
            origin: [0, 1, 2].map(|offset| along(origin, offset)),
            sign: f32x16::ONE.copysign(along(direction, 0)),
            slope: [along(direction, 1) * scale, along(direction, 2) * scale],
            scale,
            low_origin: origin.map(|origin| origin + slack),
            high_origin: origin.map(|origin| origin - slack),
            inverse,
            limit: is_ray.select(limit * length, f32x16::splat(-1.0)),
            but: [gather(from, chosen, NO_PRIMITIVE), gather(targets, chosen, NO_PRIMITIVE)],
            primitive: u32x16::splat(NO_PRIMITIVE),
        }
    }

    /// What each of so many rays has hit last, if anything, and its distance.
    pub fn hits(&self, count: usize) -> impl Iterator<Item = Option<(u32, f32)>> {
        let distances = (self.limit * self.scale).to_array();
        let hits = self.primitive.to_array().into_iter().zip(distances).take(count);
        hits.map(|(primitive, distance)| {
            (primitive != NO_PRIMITIVE).then_some((primitive, distance))
        })
    }

    /// One of the rays.
    fn ray(&self, lane: usize) -> TriangleTest {
        let of = |lanes: &f32x16| lanes.as_array()[lane % 16];
        let bit = |lanes: f32x16| lanes.to_bitmask() >> lane & 1;
        let major = [1, 0, 2, 0][(bit(self.is_x) | bit(self.is_z) << 1) as usize];
        let [a, b] = minor_axes(major);
        let mut origin = Vec3::ZERO;
        for (axis, origin_along) in [major, a, b].into_iter().zip(&self.origin) {
            origin[axis] = of(origin_along);
        }
        TriangleTest {
            origin,
            major,
            sign: of(&self.sign),
            slope: [of(&self.slope[0]), of(&self.slope[1])],
            scale: of(&self.scale),
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

    /// A corner of a triangle in the spaces of the rays.
    // Always inline: a call passes everything through memory.
    #[inline(always)]
    fn shear(&self, corner: &[f32x8; 3], triangle: usize) -> [f32x16; 3] {
        let corner = [
            f32x16::splat(corner[0].as_array()[triangle % 8]),
            f32x16::splat(corner[1].as_array()[triangle % 8]),
            f32x16::splat(corner[2].as_array()[triangle % 8]),
        ];
        let along = |offset: usize| along(self.is_x, self.is_z, corner, offset);
        let z = (along(0) - self.origin[0]) * self.sign;
        let a = (along(1) - self.origin[1]) - self.slope[0] * z;
        [a, (along(2) - self.origin[2]) - self.slope[1] * z, z]
    }

    /// Tests a triangle of a leaf against the rays of some lanes, with the roundings of [`TriangleTest::depths`].
    #[inline]
    fn test<const ANY: bool>(&mut self, leaf: &TriangleLeaf, triangle: usize, lanes: f32x16) {
        let [a, b, c] = &leaf.corners;
        let [a, b, c] = [self.shear(a, triangle), self.shear(b, triangle), self.shear(c, triangle)];
        let u = c[0] * b[1] - c[1] * b[0];
        let v = a[0] * c[1] - a[1] * c[0];
        let w = b[0] * a[1] - b[1] * a[0];
        let (low, high) = (u.fast_min(v).fast_min(w), u.fast_max(v).fast_max(w));
        let zero = f32x16::ZERO;
        let inside = (low.simd_ge(zero) | high.simd_le(zero)) & lanes;
        if !inside.any() {
            return;
        }
        let inverse = f32x16::ONE / (u + v + w);
        let depth = (u * inverse) * a[2] + (v * inverse) * b[2] + (w * inverse) * c[2];
        let hit = inside & depth.simd_gt(zero);
        let mut depth = hit.select(depth, f32x16::INFINITY);
        let on_edge = u.simd_eq(zero) | v.simd_eq(zero) | w.simd_eq(zero);
        for lane in rays((on_edge & inside).to_bitmask().into()) {
            depth.as_mut_array()[lane % 16] = self.ray(lane).depth(leaf.triangle(triangle));
        }
        let id = u32x16::splat(leaf.ids[triangle]);
        let counts = self.but[0].simd_ne(id) & self.but[1].simd_ne(id);
        let hit = depth.simd_lt(self.limit) & f32x16::from_bits(counts);
        let limit = if ANY { f32x16::splat(-1.0) } else { depth };
        self.limit = hit.select(limit, self.limit);
        self.primitive = hit.to_bits().select(id, self.primitive);
    }

    /// Visits what is below a child with one ray.
    fn visit_alone<const ANY: bool>(
        &mut self,
        tree: &Tree<TriangleLeaf>,
        child: Child,
        lane: usize,
    ) {
        let test = self.ray(lane);
        let but = [0, 1].map(|which| self.but[which].as_array()[lane % 16]);
        let mut primitive = self.primitive.as_array()[lane % 16];
        let mut limit = self.limit.as_array()[lane % 16];
        let mut visit = |leaf: &TriangleLeaf, mut limit: f32| {
            let depths = test.depths(leaf);
            for triangle in rays((depths.simd_lt(limit).to_bitmask() & leaf.mask).into()) {
                let (depth, id) = (depths.as_array()[triangle % 8], leaf.ids[triangle % 8]);
                if depth < limit && !but.contains(&id) {
                    primitive = id;
                    limit = if ANY { -1.0 } else { depth };
                }
            }
            limit
        };
        match child.kind() {
            Kind::Leaf(leaf) => limit = visit(&tree.leaves[leaf], limit),
            Kind::Node(_) => {
                tree.visit_below(child, &BoxTest::new(&test), limit, |leaf, before| {
                    limit = visit(leaf, before);
                    limit
                })
            }
        }
        self.primitive.as_mut_array()[lane % 16] = primitive;
        self.limit.as_mut_array()[lane % 16] = limit;
    }
}

/// The values of some rays side by side, and `none` beyond.
#[inline(always)]
fn gather<T: Copy, V: From<[T; 16]>>(values: &[T; PACKET_RAYS], chosen: &[usize], none: T) -> V {
    let mut lanes = [none; 16];
    for (lane, &ray) in lanes.iter_mut().zip(chosen) {
        *lane = values[ray % PACKET_RAYS];
    }
    V::from(lanes)
}

/// Coordinates along the axis that is so many after the major one, where this is x or z, or else y.
#[inline(always)]
fn along(is_x: f32x16, is_z: f32x16, v: [f32x16; 3], offset: usize) -> f32x16 {
    let [x, y, z] = [v[offset], v[(1 + offset) % 3], v[(2 + offset) % 3]];
    is_x.select(x, is_z.select(z, y))
}

/// A child of a node yet to be visited.
pub struct Waiting {
    /// The depths at which rays enter its box; infinite for those that do not.
    near: f32x16,
    child: Child,
}

impl Tree<TriangleLeaf> {
    /// Finds what rays meet first before their limits, or `ANY` of it. The stack is empty before and after.
    #[inline]
    pub fn visit_sixteen<const ANY: bool>(&self, sixteen: &mut Sixteen, stack: &mut Vec<Waiting>) {
        stack.push(Waiting { near: f32x16::ZERO, child: Child::node(0) });
        let mut nodes = 0;
        while let Some(Waiting { near, child }) = stack.pop() {
            let inside = near.simd_le(sixteen.limit) & near.simd_lt(f32::INFINITY);
            let lanes = inside.to_bitmask();
            let alone = |sixteen: &mut Sixteen| {
                for lane in rays(lanes.into()) {
                    sixteen.visit_alone::<ANY>(self, child, lane);
                }
            };
            match child.kind() {
                _ if lanes == 0 => {}
                Kind::Leaf(leaf) => {
                    let leaf = &self.leaves[leaf];
                    if 2 * lanes.count_ones() <= leaf.mask.count_ones() {
                        alone(sixteen);
                        continue;
                    }
                    for triangle in 0..leaf.mask.count_ones() as usize {
                        sixteen.test::<ANY>(leaf, triangle % 8, inside);
                    }
                }
                Kind::Node(_) if lanes.count_ones() <= FEW => alone(sixteen),
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
