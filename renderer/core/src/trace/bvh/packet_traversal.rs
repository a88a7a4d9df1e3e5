//! Traversal with a packet.

use std::array;

use wide::{f32x8, f32x16};

use super::node::{Child, Kind, Leaf, Node};
use super::packet::{GROUPS, Packet, Rays};
use super::single::SLAB_ERROR;
use super::stack::{Entry, Sorted, Stack};
use super::tree::Tree;
use super::triangle_test::minor_axes;
use crate::counts::count;

/// By how much the frustum is wider than its rays, relative to depth: several rounding errors of
/// the products that a box is tested with.
const WIDENING: f32 = 1e-6;

/// The frustum of a packet, prepared for boxes.
struct Frustum {
    /// Axes and origins in the order: depth, then the minor axes. The origin as seen by planes of
    /// low coordinates, then by those of high ones.
    axes: [usize; 3],
    low_origin: [f32; 3],
    high_origin: [f32; 3],
    forward: bool,
    /// By minor axis: the least and the greatest slope.
    range: [[f32; 2]; 2],
}

impl Frustum {
    fn new(packet: &Packet) -> Self {
        let [a, b] = minor_axes(packet.major);
        let axes = [packet.major, a, b];
        Self {
            axes,
            low_origin: axes.map(|axis| packet.origin[axis] + packet.slack),
            high_origin: axes.map(|axis| packet.origin[axis] - packet.slack),
            forward: packet.sign > 0.0,
            range: packet.range.map(|[low, high]| {
                let margin = WIDENING * (1.0 + low.abs().max(high.abs()));
                [low - margin, high + margin]
            }),
        }
    }

    /// The depths at which the boxes of a node begin, and a bit for each that the frustum touches
    /// before `far`.
    #[inline]
    fn enter(&self, node: &Node, far: f32) -> (f32x8, u32) {
        let [near, end] = self.relative(node, 0);
        let (near, end) = if self.forward { (near, end) } else { (-end, -near) };
        let near = near.fast_max(f32x8::ZERO);
        let mut touched = near.simd_le(end) & near.simd_le(f32x8::splat(far));
        for i in 0..2 {
            let [low, high] = self.relative(node, 1 + i);
            let (least, greatest) =
                (f32x8::splat(self.range[i][0]), f32x8::splat(self.range[i][1]));
            touched &= low.simd_le((greatest * near).fast_max(greatest * end));
            touched &= high.simd_ge((least * near).fast_min(least * end));
        }
        (near, touched.to_bitmask() & node.mask)
    }

    /// Whether any ray enters one of the boxes of a node.
    #[inline]
    fn any_ray_enters(
        &self,
        packet: &Packet,
        inverse: &Rays<[f32x16; 2]>,
        node: &Node,
        slot: usize,
    ) -> bool {
        let plane = |i: usize, side: usize, origin: f32| {
            f32x16::splat(node.bounds[self.axes[i]][side].as_array()[slot] - origin)
        };
        let low = |i: usize| plane(i, 0, self.low_origin[i]);
        let high = |i: usize| plane(i, 1, self.high_origin[i]);
        let (near, end) = if self.forward { (low(0), high(0)) } else { (-high(0), -low(0)) };
        let (a_low, a_high, b_low, b_high) = (low(1), high(1), low(2), high(2));
        let near = near.fast_max(f32x16::ZERO);
        for (&[a, b], &depth) in inverse.iter().zip(&packet.depth) {
            let (a0, a1, b0, b1) = (a_low * a, a_high * a, b_low * b, b_high * b);
            let entered = near.fast_max(a0.fast_min(a1)).fast_max(b0.fast_min(b1));
            let left = end.fast_min(a0.fast_max(a1)).fast_min(b0.fast_max(b1));
            let left = (left * f32x16::splat(1.0 + SLAB_ERROR)).fast_min(depth);
            if entered.simd_le(left).any() {
                return true;
            }
        }
        false
    }

    /// The lowest and the highest coordinates of the boxes of a node, relative to the origin, along
    /// one of `axes`.
    #[inline]
    fn relative(&self, node: &Node, i: usize) -> [f32x8; 2] {
        let [low, high] = node.bounds[self.axes[i]];
        [low - f32x8::splat(self.low_origin[i]), high - f32x8::splat(self.high_origin[i])]
    }
}

/// 1 over the slopes of the rays, finite.
#[inline]
fn inverse_slopes(packet: &Packet) -> Rays<[f32x16; 2]> {
    let inverse = |slope: f32x16| {
        let steep = slope.abs().fast_max(f32x16::splat(1e-12));
        f32x16::ONE / steep.copysign(slope)
    };
    array::from_fn(|g| [inverse(packet.slope[0][g]), inverse(packet.slope[1][g])])
}

impl<L: Leaf> Tree<L> {
    /// Visits every leaf whose box the frustum touches, near ones first, before the depths of its
    /// rays. A visit may lower `packet.depth`. `SPARSE` says that the rays may fill the frustum
    /// badly, so that it pays to test boxes against each of them too.
    pub fn visit_packet<const SPARSE: bool>(
        &self,
        packet: &mut Packet,
        mut visit: impl FnMut(&L, &mut Packet),
    ) {
        if self.nodes.is_empty() {
            for leaf in &self.leaves {
                visit(leaf, packet);
                if packet.far < 0.0 {
                    return;
                }
            }
            return;
        }
        let frustum = Frustum::new(packet);
        let inverse = if SPARSE { inverse_slopes(packet) } else { [[f32x16::ZERO; 2]; GROUPS] };
        let mut stack = Stack::new();
        let mut current = Child::node(0);
        let mut nodes = 0;
        'traversal: loop {
            match current.kind() {
                Kind::Leaf(leaf) => {
                    visit(&self.leaves[leaf], packet);
                    if packet.far < 0.0 {
                        break 'traversal;
                    }
                }
                Kind::Node(index) => {
                    nodes += 1;
                    let (near, bits) = frustum.enter(&self.nodes[index], packet.far);
                    let sorted = Sorted::new(bits, |slot| Entry {
                        near: near.as_array()[slot],
                        target: (8 * index + slot) as u32,
                    });
                    sorted.as_slice().iter().for_each(|&entry| stack.push(entry));
                }
            }
            current = loop {
                let Some(entry) = stack.pop() else { break 'traversal };
                if entry.near > packet.far {
                    continue;
                }
                let (index, slot) = (entry.target as usize / 8, entry.target as usize % 8);
                let node = &self.nodes[index];
                let child = node.children[slot];
                if !SPARSE || frustum.any_ray_enters(packet, &inverse, node, slot) {
                    break child;
                }
            };
        }
        count(|counts| &counts.nodes, nodes);
    }
}
