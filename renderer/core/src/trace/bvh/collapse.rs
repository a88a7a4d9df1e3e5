//! From a binary tree to an eight-wide one.

use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;

use super::Shapes;
use super::binary;
use super::bounds::bounds;
use super::node::{Child, Leaf, Node};
use super::quality::BuildQuality;

/// Builds the nodes, without their boxes, and the leaves, not loaded yet, over the shapes with
/// these indices.
pub fn collapse<L: Leaf>(
    shapes: &dyn Shapes,
    members: &[u32],
    quality: BuildQuality,
) -> (Vec<Node>, Vec<L>) {
    let boxes: Vec<Aabb> = members.iter().map(|&id| bounds(&shapes.shape(id))).collect();
    let binary = binary::build(boxes, quality);
    let sizes = sizes(&binary);
    let mut collapse = Collapse { binary, sizes, members, nodes: Vec::new(), leaves: Vec::new() };
    collapse.run();
    (collapse.nodes, collapse.leaves)
}

/// The number of primitives below each node.
fn sizes(binary: &Bvh2) -> Vec<u32> {
    let mut sizes = vec![0; binary.nodes.len()];
    for (index, node) in binary.nodes.iter().enumerate().rev() {
        let first = node.first_index as usize;
        sizes[index] =
            if node.is_leaf() { node.prim_count } else { sizes[first] + sizes[first + 1] };
    }
    sizes
}

struct Collapse<'a, L> {
    binary: Bvh2,
    sizes: Vec<u32>,
    members: &'a [u32],
    nodes: Vec<Node>,
    leaves: Vec<L>,
}

impl<L: Leaf> Collapse<'_, L> {
    fn run(&mut self) {
        if self.binary.nodes.is_empty() {
            return;
        }
        // A binary node that becomes a node, and the place that waits for its index.
        let mut pending = vec![(0, None)];
        while let Some((root, place)) = pending.pop() {
            let index = self.nodes.len();
            if let Some((parent, slot)) = place {
                let parent: &mut Node = &mut self.nodes[parent];
                parent.children[slot] = Child::node(index);
            }
            let (group, count) = self.open(root);
            let mut node = Node::new();
            node.mask = (1 << count) - 1;
            for (slot, &member) in group[..count].iter().enumerate() {
                if self.fits_leaf(member) {
                    node.children[slot] = Child::leaf(self.leaves.len());
                    let leaf = self.leaf(member);
                    self.leaves.push(leaf);
                } else {
                    pending.push((member, Some((index, slot))));
                }
            }
            self.nodes.push(node);
        }
    }

    /// Replaces a binary node by its children, again and again the largest, until there are eight
    /// or all of them are small enough for a leaf.
    fn open(&self, root: usize) -> ([usize; 8], usize) {
        let mut group = [root; 8];
        let mut count = 1;
        while count < group.len() {
            let largest = (0..count)
                .filter(|&i| !self.fits_leaf(group[i]))
                .max_by(|&i, &j| self.area(group[i]).total_cmp(&self.area(group[j])));
            let Some(largest) = largest else { break };
            let first = self.binary.nodes[group[largest]].first_index as usize;
            group[largest] = first;
            group[count] = first + 1;
            count += 1;
        }
        (group, count)
    }

    /// Whether everything below a node fits into one leaf. A binary leaf always has to.
    fn fits_leaf(&self, node: usize) -> bool {
        self.sizes[node] as usize <= L::CAPACITY
    }

    fn area(&self, node: usize) -> f32 {
        self.binary.nodes[node].aabb().half_area()
    }

    /// A leaf of everything below a node.
    fn leaf(&self, node: usize) -> L {
        let mut members = Vec::with_capacity(L::CAPACITY);
        let mut pending = vec![node];
        while let Some(node) = pending.pop() {
            let node = &self.binary.nodes[node];
            let first = node.first_index as usize;
            if node.is_leaf() {
                let range = first..first + node.prim_count as usize;
                let indices = &self.binary.primitive_indices[range];
                members.extend(indices.iter().map(|&i| self.members[i as usize]));
            } else {
                pending.extend([first + 1, first]);
            }
        }
        L::new(&members)
    }
}
