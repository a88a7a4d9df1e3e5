//! Which primitive does a ray meet first, and is anything in its way?
//!
//! These questions have discrete answers, so nothing here is differentiated, and everything is
//! `f32` whatever the kernels compute in.

mod bounds;
mod collapse;
mod effort;
mod packet;
mod packet_queries;
mod packet_traversal;
mod packet_triangles;
mod single;
mod spheres;
mod stack;
#[cfg(test)]
mod tests;
mod tree;
mod triangle_test;
mod triangles;

use glam::Vec3;

pub use effort::Effort;
pub use packet::{
    NO_PRIMITIVE, PACKET_RAYS, PacketHits, PacketVectors, ray_at, rays, tile_position,
};

use single::BoxTest;
use spheres::{SphereLeaf, sphere_distance};
use tree::Tree;
use triangle_test::TriangleTest;
use triangles::TriangleLeaf;

/// A primitive as traversal sees it.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    /// Three corners.
    Triangle([Vec3; 3]),
    /// Centre and radius.
    Sphere(Vec3, f32),
}

/// The primitives of a scene, wherever they are kept.
pub trait Shapes: Sync {
    /// How many there are.
    fn count(&self) -> usize;
    /// One of them.
    fn shape(&self, index: u32) -> Shape;
}

impl<T: AsRef<[Shape]> + Sync + ?Sized> Shapes for T {
    fn count(&self) -> usize {
        self.as_ref().len()
    }

    #[inline]
    fn shape(&self, index: u32) -> Shape {
        self.as_ref()[index as usize]
    }
}

/// The first primitive that a ray meets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The index of the primitive.
    pub primitive: u32,
    /// The distance from the origin of the ray, in lengths of its direction.
    pub distance: f32,
    /// For a sphere: whether the ray comes from its inside.
    pub leaves: bool,
}

/// A ray, prepared to be tested against single shapes, with what traversal finds.
pub struct ShapeTest {
    origin: Vec3,
    direction: Vec3,
    test: TriangleTest,
}

impl ShapeTest {
    /// Prepares a ray; nothing if its direction is zero or not finite.
    pub fn new(origin: Vec3, direction: Vec3) -> Option<Self> {
        Some(Self { origin, direction, test: TriangleTest::new(origin, direction)? })
    }

    /// The distance at which the ray meets a shape, infinite if it does not, and whether it comes from
    /// inside of a sphere.
    pub fn distance(&self, shape: &Shape) -> (f32, bool) {
        match *shape {
            Shape::Triangle(corners) => (self.test.depth(corners) * self.test.scale, false),
            Shape::Sphere(center, radius) => {
                sphere_distance(self.origin, self.direction, center, radius)
            }
        }
    }
}

/// The indices of triangles and of spheres.
fn by_kind(shapes: &(impl Shapes + ?Sized)) -> (Vec<u32>, Vec<u32>) {
    let is_triangle = |&id: &u32| matches!(shapes.shape(id), Shape::Triangle(_));
    (0..shapes.count() as u32).partition(is_triangle)
}

/// By what factor a ray may become dearer because shapes have moved before the tree is rebuilt.
const REBUILD_ABOVE: f64 = 1.5;

/// A bounding volume hierarchy over primitives, or a plain list of them.
pub struct Acceleration {
    /// How many primitives there are.
    count: usize,
    is_list: bool,
    effort: Effort,
    triangles: Tree<TriangleLeaf>,
    spheres: Tree<SphereLeaf>,
}

impl Acceleration {
    /// Builds the tree with the least effort. Every coordinate has to be finite.
    pub fn new(shapes: &(impl Shapes + ?Sized)) -> Self {
        Self::with_effort(shapes, Effort::default())
    }

    /// Builds the tree. Every coordinate has to be finite.
    pub fn with_effort(shapes: &(impl Shapes + ?Sized), effort: Effort) -> Self {
        let (triangles, spheres) = by_kind(shapes);
        Self {
            count: shapes.count(),
            is_list: false,
            effort,
            triangles: Tree::build(shapes, &triangles, effort),
            spheres: Tree::build(shapes, &spheres, effort),
        }
    }

    /// A plain list, to compare with: every ray is tested against every primitive. Every coordinate
    /// has to be finite.
    pub fn list(shapes: &(impl Shapes + ?Sized)) -> Self {
        let (triangles, spheres) = by_kind(shapes);
        Self {
            count: shapes.count(),
            is_list: true,
            effort: Effort::default(),
            triangles: Tree::list(shapes, &triangles),
            spheres: Tree::list(shapes, &spheres),
        }
    }

    /// Takes over where shapes have moved to. Every coordinate has to be finite.
    ///
    /// Boxes are fitted to the shapes again, which takes a fraction of the time of a new tree; once
    /// this tree has become too much worse than when it was built, or the number or kinds of the
    /// shapes are others, a new one is built.
    pub fn update(&mut self, shapes: &(impl Shapes + ?Sized)) {
        let fits = shapes.count() == self.count
            && self.triangles.refit(shapes)
            && self.spheres.refit(shapes);
        let worse = || self.triangles.degradation().max(self.spheres.degradation());
        if !fits || worse() > REBUILD_ABOVE {
            *self = match self.is_list {
                true => Self::list(shapes),
                false => Self::with_effort(shapes, self.effort),
            };
        }
    }

    /// The nearest primitive along the ray.
    pub fn nearest(&self, origin: Vec3, direction: Vec3) -> Option<Hit> {
        self.nearest_but(None, origin, direction)
    }

    /// The nearest primitive along the ray but `from`, the flat one that it starts on.
    pub fn nearest_but(&self, from: Option<u32>, origin: Vec3, direction: Vec3) -> Option<Hit> {
        let test = TriangleTest::new(origin, direction)?;
        let boxes = BoxTest::new(&test);
        let mut found = None;
        let mut nearest = f32::INFINITY;
        self.triangles.visit(&boxes, nearest, |leaf, _| {
            let depths = test.depths(leaf);
            let mut bits = depths.simd_lt(nearest).to_bitmask() & leaf.mask;
            while bits != 0 {
                let lane = bits.trailing_zeros() as usize & 7;
                bits &= bits - 1;
                let depth = depths.as_array()[lane];
                if depth < nearest && from != Some(leaf.ids[lane]) {
                    nearest = depth;
                    let distance = depth * test.scale;
                    found = Some(Hit { primitive: leaf.ids[lane], distance, leaves: false });
                }
            }
            nearest
        });
        self.spheres.visit(&boxes, nearest, |leaf, _| {
            let (distance, leaves) = leaf.distance(origin, direction);
            if distance / test.scale < nearest {
                nearest = distance / test.scale;
                found = Some(Hit { primitive: leaf.id, distance, leaves });
            }
            nearest
        });
        found
    }

    /// Whether anything but `from`, the flat primitive that the ray starts on, is met before
    /// `limit`.
    pub fn is_occluded(
        &self,
        origin: Vec3,
        direction: Vec3,
        limit: f32,
        from: Option<u32>,
    ) -> bool {
        let Some(test) = TriangleTest::new(origin, direction) else { return false };
        let boxes = BoxTest::new(&test);
        let depth_limit = limit / test.scale;
        let mut occluded = false;
        self.triangles.visit(&boxes, depth_limit, |leaf, _| {
            let depths = test.depths(leaf);
            let mut bits = depths.simd_lt(depth_limit).to_bitmask() & leaf.mask;
            while bits != 0 && !occluded {
                let lane = bits.trailing_zeros() as usize & 7;
                bits &= bits - 1;
                occluded = from != Some(leaf.ids[lane]);
            }
            if occluded { -1.0 } else { depth_limit }
        });
        if occluded {
            return true;
        }
        self.spheres.visit(&boxes, depth_limit, |leaf, _| {
            occluded |= from != Some(leaf.id) && leaf.distance(origin, direction).0 < limit;
            if occluded { -1.0 } else { depth_limit }
        });
        occluded
    }

    /// Visits what is met before `limit` but `from`, the flat primitive that the ray starts on, in no
    /// order: a sphere as often as the ray goes through its surface, each time with whether it leaves it.
    /// A visit returns whether to go on.
    pub fn visit_met(
        &self,
        origin: Vec3,
        direction: Vec3,
        limit: f32,
        from: Option<u32>,
        mut visit: impl FnMut(u32, bool) -> bool,
    ) {
        let Some(test) = TriangleTest::new(origin, direction) else { return };
        let boxes = BoxTest::new(&test);
        let depth_limit = limit / test.scale;
        let mut goes_on = true;
        self.triangles.visit(&boxes, depth_limit, |leaf, _| {
            let depths = test.depths(leaf);
            let mut bits = depths.simd_lt(depth_limit).to_bitmask() & leaf.mask;
            while bits != 0 && goes_on {
                let lane = bits.trailing_zeros() as usize & 7;
                bits &= bits - 1;
                goes_on = from == Some(leaf.ids[lane]) || visit(leaf.ids[lane], false);
            }
            if goes_on { depth_limit } else { -1.0 }
        });
        if !goes_on {
            return;
        }
        self.spheres.visit(&boxes, depth_limit, |leaf, _| {
            for leaves in leaf.crossings(origin, direction, limit) {
                goes_on &= visit(leaf.id, leaves);
            }
            if goes_on { depth_limit } else { -1.0 }
        });
    }
}
