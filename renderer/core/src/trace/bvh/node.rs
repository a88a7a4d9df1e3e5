//! The nodes of the tree, and what its leaves can do.

use obvhs::aabb::Aabb;
use wide::f32x8;

use super::Shapes;

/// What the tree holds at its ends.
pub trait Leaf: Send + Sync {
    /// The most members that a leaf has.
    const CAPACITY: usize;
    /// A leaf of the shapes with these indices, yet to be loaded.
    fn new(members: &[u32]) -> Self;
    /// Takes the shapes over; false if one of them is of another kind.
    fn load(&mut self, shapes: &dyn Shapes) -> bool;
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
    /// The boxes of the children by axis: the lowest coordinate, then the highest. Finite where there is no child.
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

    pub fn set_bounds(&mut self, slot: usize, bounds: Aabb) {
        for (axis, [low, high]) in self.bounds.iter_mut().enumerate() {
            low.as_mut_array()[slot] = bounds.min[axis];
            high.as_mut_array()[slot] = bounds.max[axis];
        }
    }

    /// The box around all children.
    pub fn hull(&self) -> Aabb {
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
    pub fn area(&self) -> f32 {
        let [x, y, z] = self.bounds.map(|[low, high]| high - low);
        (x * y + y * z + z * x).reduce_add()
    }
}
