//! Leaves of triangles.

use glam::{Vec3, Vec3A};
use obvhs::aabb::Aabb;
use wide::f32x8;

use super::bounds::widened;
use super::node::Leaf;
use super::{Shape, Shapes};

/// Up to eight triangles, side by side.
#[derive(Clone)]
pub struct TriangleLeaf {
    /// The coordinates of the triangles, by corner, then by axis.
    pub corners: [[f32x8; 3]; 3],
    /// The index that the user knows each triangle by.
    pub ids: [u32; 8],
    /// A bit for each triangle that there is.
    pub mask: u32,
}

impl TriangleLeaf {
    /// The corners of one triangle.
    #[inline]
    pub fn triangle(&self, lane: usize) -> [Vec3; 3] {
        [0, 1, 2].map(|corner| {
            Vec3::from([0, 1, 2].map(|axis| self.corners[corner][axis].as_array()[lane]))
        })
    }
}

impl Leaf for TriangleLeaf {
    const CAPACITY: usize = 8;

    fn new(members: &[u32]) -> Self {
        let mut ids = [0; 8];
        ids[..members.len()].copy_from_slice(members);
        Self { corners: [[f32x8::ZERO; 3]; 3], ids, mask: (1 << members.len()) - 1 }
    }

    fn load(&mut self, shapes: &dyn Shapes) -> bool {
        let count = self.mask.count_ones() as usize;
        for (lane, &id) in self.ids[..count].iter().enumerate() {
            let Shape::Triangle(triangle) = shapes.shape(id) else { return false };
            for (corner, place) in triangle.iter().zip(&mut self.corners) {
                for (axis, place) in place.iter_mut().enumerate() {
                    place.as_mut_array()[lane] = corner[axis];
                }
            }
        }
        true
    }

    fn bounds(&self) -> Aabb {
        let count = self.mask.count_ones() as usize;
        let [a, b, c] = &self.corners;
        let extreme =
            |axis: usize, choose: fn(f32x8, f32x8) -> f32x8, fold: fn(f32, f32) -> f32| {
                let lanes = choose(choose(a[axis], b[axis]), c[axis]).to_array();
                lanes[..count].iter().copied().fold(lanes[0], fold)
            };
        let low = [0, 1, 2].map(|axis| extreme(axis, f32x8::fast_min, f32::min));
        let high = [0, 1, 2].map(|axis| extreme(axis, f32x8::fast_max, f32::max));
        widened(Aabb::new(Vec3A::from(low), Vec3A::from(high)))
    }
}
