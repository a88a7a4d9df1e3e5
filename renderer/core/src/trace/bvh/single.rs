//! Traversal with one ray.

use glam::Vec3;
use wide::f32x8;

use super::node::{Child, Kind, Leaf, Node};
use super::stack::{Entry, Sorted, Stack};
use super::tree::Tree;
use super::triangle_test::{TriangleTest, minor_axes};
use crate::counts::count;

/// Rounding errors of a slab test, relative to the depth that it finds.
pub const SLAB_ERROR: f32 = 4.0 * f32::EPSILON;

/// A ray, prepared for boxes.
pub struct BoxTest {
    /// For each axis, which of the two planes of a box is entered.
    near_plane: [usize; 3],
    /// The origin as seen by planes that are entered and by those that are left. They differ by a
    /// few rounding errors of the origin: the differences to the corners of a triangle round too.
    near_origin: Vec3,
    far_origin: Vec3,
    /// 1 over the direction, which has the length 1 on the major axis.
    inverse: Vec3,
}

impl BoxTest {
    #[inline]
    pub fn new(test: &TriangleTest) -> Self {
        let [a, b] = minor_axes(test.major);
        let mut direction = Vec3::ZERO;
        direction[test.major] = test.sign;
        direction[a] = test.slope[0];
        direction[b] = test.slope[1];
        // Far below rounding errors of the position, and its inverse stays finite.
        let least = Vec3::splat(1e-12);
        let direction = direction.abs().max(least).copysign(direction);
        let slack = direction.signum() * origin_error(test.origin);
        Self {
            near_plane: direction.to_array().map(|d| usize::from(d < 0.0)),
            near_origin: test.origin + slack,
            far_origin: test.origin - slack,
            inverse: direction.recip(),
        }
    }

    /// The depths at which the boxes of a node are entered, and a bit for each that is hit before
    /// `limit`.
    #[inline]
    fn enter(&self, node: &Node, limit: f32) -> (f32x8, u32) {
        let mut near = f32x8::ZERO;
        let mut far = f32x8::INFINITY;
        for axis in 0..3 {
            let entered = self.near_plane[axis] & 1;
            let bounds = &node.bounds[axis];
            let inverse = f32x8::splat(self.inverse[axis]);
            near =
                near.fast_max((bounds[entered] - f32x8::splat(self.near_origin[axis])) * inverse);
            far =
                far.fast_min((bounds[1 - entered] - f32x8::splat(self.far_origin[axis])) * inverse);
        }
        let far = (far * f32x8::splat(1.0 + SLAB_ERROR)).fast_min(f32x8::splat(limit));
        (near, near.simd_le(far).to_bitmask() & node.mask)
    }
}

/// How much the difference to a point may be wrong because it is taken in single precision.
pub fn origin_error(origin: Vec3) -> f32 {
    4.0 * f32::EPSILON * origin.abs().max_element()
}

impl<L: Leaf> Tree<L> {
    /// Visits every leaf whose box is entered before `limit`, near ones first. A visit returns the
    /// new limit; a negative one ends the traversal.
    #[inline]
    pub fn visit(&self, ray: &BoxTest, mut limit: f32, mut visit: impl FnMut(&L, f32) -> f32) {
        if self.nodes.is_empty() {
            for leaf in &self.leaves {
                limit = visit(leaf, limit);
                if limit < 0.0 {
                    return;
                }
            }
            return;
        }
        self.visit_below(Child::node(0), ray, limit, visit);
    }

    /// The same for the leaves below a child of a node.
    #[inline]
    pub fn visit_below(
        &self,
        mut current: Child,
        ray: &BoxTest,
        mut limit: f32,
        mut visit: impl FnMut(&L, f32) -> f32,
    ) {
        let mut stack = Stack::new();
        let mut nodes = 0;
        'traversal: loop {
            match current.kind() {
                Kind::Leaf(leaf) => {
                    limit = visit(&self.leaves[leaf], limit);
                    if limit < 0.0 {
                        break 'traversal;
                    }
                }
                Kind::Node(index) => {
                    nodes += 1;
                    let node = &self.nodes[index];
                    let (near, bits) = ray.enter(node, limit);
                    let sorted = Sorted::new(bits, |slot| Entry {
                        near: near.as_array()[slot],
                        target: node.children[slot].bits(),
                    });
                    if let Some((nearest, others)) = sorted.as_slice().split_last() {
                        others.iter().for_each(|&entry| stack.push(entry));
                        current = Child::from_bits(nearest.target);
                        continue;
                    }
                }
            }
            current = loop {
                match stack.pop() {
                    None => break 'traversal,
                    Some(entry) if entry.near <= limit => break Child::from_bits(entry.target),
                    Some(_) => {}
                }
            };
        }
        count(|counts| &counts.nodes, nodes);
    }
}
