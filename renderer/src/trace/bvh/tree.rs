//! An eight-wide bounding volume hierarchy.

use obvhs::aabb::Aabb;
use rayon::prelude::*;
use wide::f32x8;

use super::Shapes;
use super::collapse::collapse;
use super::quality::BuildQuality;

/// What the tree holds at its ends.
pub trait Leaf: Send + Sync {
    /// The most members that a leaf has.
    const CAPACITY: usize;
    /// A leaf of the shapes with these indices, yet to be loaded.
    fn new(members: &[u32]) -> Self;
    /// Takes the shapes over; false if one of them is of another kind.
    fn load(&mut self, shapes: &(impl Shapes + ?Sized)) -> bool;
    /// The box around all members.
    fn bounds(&self) -> Aabb;
}

/// A child of a node.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Child(u32);

/// What a [`Child`] is.
pub enum Kind {
    Node(usize),
    Leaf(usize),
}

impl Child {
    const LEAF: u32 = 1 << 31;

    pub fn node(index: usize) -> Self {
        Self(index as u32)
    }

    pub fn leaf(index: usize) -> Self {
        Self(index as u32 | Self::LEAF)
    }

    pub fn from_bits(bits: u32) -> Self {
        Self(bits)
    }

    pub fn bits(self) -> u32 {
        self.0
    }

    #[inline]
    pub fn is_leaf(self) -> bool {
        self.0 & Self::LEAF != 0
    }

    #[inline]
    pub fn kind(self) -> Kind {
        let index = (self.0 & !Self::LEAF) as usize;
        if self.is_leaf() { Kind::Leaf(index) } else { Kind::Node(index) }
    }
}

/// Up to eight children and their boxes, side by side.
#[repr(C, align(64))]
#[derive(Clone)]
pub struct Node {
    /// By axis; the lowest coordinate, then the highest. Finite where there is no child.
    pub bounds: [[f32x8; 2]; 3],
    pub children: [Child; 8],
    /// A bit for each child that there is.
    pub mask: u32,
}

impl Node {
    pub fn new() -> Self {
        Self { bounds: [[f32x8::ZERO; 2]; 3], children: [Child::default(); 8], mask: 0 }
    }

    /// The children that there are.
    pub fn children(&self) -> &[Child] {
        &self.children[..self.mask.count_ones() as usize]
    }

    fn set_bounds(&mut self, slot: usize, bounds: Aabb) {
        for (axis, [low, high]) in self.bounds.iter_mut().enumerate() {
            low.as_mut_array()[slot] = bounds.min[axis];
            high.as_mut_array()[slot] = bounds.max[axis];
        }
    }

    /// The box around all children.
    fn hull(&self) -> Aabb {
        let count = self.children().len();
        let mut hull = Aabb::INVALID;
        for (axis, [low, high]) in self.bounds.iter().enumerate() {
            hull.min[axis] = low.as_array()[..count].iter().copied().fold(f32::INFINITY, f32::min);
            hull.max[axis] =
                high.as_array()[..count].iter().copied().fold(f32::NEG_INFINITY, f32::max);
        }
        hull
    }

    /// The sum of half the surface areas of the children's boxes.
    fn area(&self) -> f32 {
        let [x, y, z] = self.bounds.map(|[low, high]| high - low);
        (x * y + y * z + z * x).reduce_add()
    }
}

/// A hierarchy over leaves of one kind.
pub struct Tree<L> {
    /// The root first, children after their parents. Without nodes every leaf is visited.
    pub nodes: Vec<Node>,
    pub leaves: Vec<L>,
    /// The cost when the tree was built.
    cost: f64,
}

impl<L: Leaf> Tree<L> {
    /// Builds a tree over the shapes with these indices, which have to be of the leaf's kind.
    pub fn build(shapes: &(impl Shapes + ?Sized), members: &[u32], quality: BuildQuality) -> Self {
        let (nodes, leaves) = collapse(shapes, members, quality);
        let mut tree = Self { nodes, leaves, cost: 0.0 };
        tree.refit(shapes);
        tree.cost = tree.cost();
        tree
    }

    /// Leaves without a tree over them.
    pub fn list(shapes: &(impl Shapes + ?Sized), members: &[u32]) -> Self {
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
    pub fn refit(&mut self, shapes: &(impl Shapes + ?Sized)) -> bool {
        let fits = self.leaves.par_iter_mut().with_min_len(64).all(|leaf| leaf.load(shapes));
        if !fits {
            return false;
        }
        let leaves = &self.leaves;
        self.nodes.par_iter_mut().with_min_len(16).for_each(|node| {
            for slot in 0..node.children().len() {
                if let Kind::Leaf(leaf) = node.children[slot].kind() {
                    node.set_bounds(slot, leaves[leaf].bounds());
                }
            }
        });
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
