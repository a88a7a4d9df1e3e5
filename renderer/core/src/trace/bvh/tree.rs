//! An eight-wide bounding volume hierarchy.

use super::Shapes;
use super::collapse::collapse;
use super::node::{Kind, Leaf, Node};
use super::quality::BuildQuality;
use crate::parallel;

/// How many leaves, or nodes, are taken over one after the other.
const CHUNK: usize = 256;

/// A hierarchy over leaves of one kind.
#[derive(Clone)]
pub struct Tree<L> {
    /// The root first, children after their parents. Without nodes every leaf is visited.
    pub nodes: Vec<Node>,
    pub leaves: Vec<L>,
    /// The cost when the tree was built.
    cost: f64,
}

impl<L: Leaf> Tree<L> {
    /// Builds a tree over the shapes with these indices, which have to be of the leaf's kind.
    pub fn build(shapes: &dyn Shapes, members: &[u32], quality: BuildQuality) -> Self {
        let (nodes, leaves) = collapse(shapes, members, quality);
        let mut tree = Self { nodes, leaves, cost: 0.0 };
        tree.refit(shapes);
        tree.cost = tree.cost();
        tree
    }

    /// Leaves without a tree over them.
    pub fn list(shapes: &dyn Shapes, members: &[u32]) -> Self {
        let leaves = members.chunks(L::CAPACITY).map(L::new).collect();
        let mut list = Self { nodes: Vec::new(), leaves, cost: 0.0 };
        list.refit(shapes);
        list
    }

    /// How much dearer a ray has become since the tree was built: the expected number of boxes that
    /// a ray through the root enters, now over then.
    pub fn degradation(&self) -> f64 {
        if self.cost > 0.0 { self.cost() / self.cost } else { 1.0 }
    }

    /// Takes shapes over that have moved; false if one of them is of another kind.
    pub fn refit(&mut self, shapes: &dyn Shapes) -> bool {
        let load = |leaves: &mut [L]| leaves.iter_mut().all(|leaf| leaf.load(shapes));
        if parallel::map(self.leaves.chunks_mut(CHUNK).collect(), load).contains(&false) {
            return false;
        }
        let leaves = &self.leaves;
        let bound = |nodes: &mut [Node]| {
            for node in nodes {
                for slot in 0..node.children().len() {
                    if let Kind::Leaf(leaf) = node.children[slot].kind() {
                        node.set_bounds(slot, leaves[leaf].bounds());
                    }
                }
            }
        };
        parallel::map(self.nodes.chunks_mut(CHUNK).collect(), bound);
        // The rest is too little work for threads: an eighth of the boxes, in order.
        for index in (0..self.nodes.len()).rev() {
            let (before, after) = self.nodes.split_at_mut(index + 1);
            let node = &mut before[index];
            for slot in 0..node.children().len() {
                if let Kind::Node(child) = node.children[slot].kind() {
                    node.set_bounds(slot, after[child - index - 1].hull());
                }
            }
        }
        true
    }

    fn cost(&self) -> f64 {
        let Some(root) = self.nodes.first() else { return 0.0 };
        let size = root.hull().diagonal();
        let root = size.x * size.y + size.y * size.z + size.z * size.x;
        self.nodes.iter().map(|node| f64::from(node.area())).sum::<f64>() / f64::from(root)
    }
}
