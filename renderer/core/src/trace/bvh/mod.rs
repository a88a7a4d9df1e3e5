//! Which primitive does a ray meet first, and is anything in its way?
//!
//! These questions have discrete answers, so nothing here is differentiated, and everything is
//! `f32` whatever the kernels compute in.

mod batch;
mod batch_queries;
mod batch_traversal;
mod binary;
mod bounds;
mod collapse;
mod node;
mod packet;
mod packet_queries;
mod packet_traversal;
mod packet_triangles;
mod quality;
mod single;
mod single_leaf;
mod stack;
#[cfg(test)]
mod tests;
mod tree;
mod triangle_leaf;
mod triangle_test;

use std::sync::Arc;

use glam::Vec3;

pub use batch::Batch;
pub use packet::{
    NO_PRIMITIVE, PACKET_RAYS, PacketHits, PacketVectors, first_rays, ray_at, rays, tile_position,
};
pub use quality::BuildQuality;

use single::BoxTest;
use single_leaf::{CustomLeaf, SingleLeaf, SphereLeaf, sphere_distance};
use tree::Tree;
use triangle_leaf::TriangleLeaf;
use triangle_test::TriangleTest;

/// A primitive as traversal sees it.
#[derive(Clone)]
pub enum Shape {
    /// Three corners.
    Triangle([Vec3; 3]),
    /// Centre and radius.
    Sphere(Vec3, f32),
    /// A custom shape.
    Custom(Arc<dyn CustomShape>),
}

/// A custom shape as traversal sees it.
pub trait CustomShape: Send + Sync {
    /// The lowest and the highest corner of a box around it.
    fn bounds(&self) -> (Vec3, Vec3);

    /// The distance at which a ray meets the shape first, in lengths of its direction, which is not zero.
    fn distance(&self, origin: Vec3, direction: Vec3) -> Option<f32>;
}

/// The primitives of a scene, wherever they are kept.
pub trait Shapes: Sync {
    /// How many there are.
    fn count(&self) -> usize;
    /// One of them.
    fn shape(&self, index: u32) -> Shape;
}

impl<T: AsRef<[Shape]> + Sync> Shapes for T {
    fn count(&self) -> usize {
        self.as_ref().len()
    }

    #[inline]
    fn shape(&self, index: u32) -> Shape {
        self.as_ref()[index as usize].clone()
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
        match shape {
            &Shape::Triangle(corners) => (self.test.depth(corners) * self.test.scale, false),
            &Shape::Sphere(center, radius) => {
                sphere_distance(self.origin, self.direction, center, radius)
            }
            Shape::Custom(shape) => {
                let distance = shape.distance(self.origin, self.direction);
                (distance.unwrap_or(f32::INFINITY), false)
            }
        }
    }
}

/// The indices of the primitives of each kind.
fn by_kind(shapes: &dyn Shapes) -> [Vec<u32>; 3] {
    let mut kinds = [Vec::new(), Vec::new(), Vec::new()];
    for id in 0..shapes.count() as u32 {
        let kind = match shapes.shape(id) {
            Shape::Triangle(_) => 0,
            Shape::Sphere(..) => 1,
            Shape::Custom(_) => 2,
        };
        kinds[kind].push(id);
    }
    kinds
}

/// The hierarchy is rebuilt once its SAH cost exceeds this multiple of the cost at build time.
const REBUILD_ABOVE: f64 = 1.5;

/// A bounding volume hierarchy over primitives, or a plain list of them.
#[derive(Clone)]
pub struct Bvh {
    /// The number of primitives.
    count: usize,
    is_brute_force: bool,
    quality: BuildQuality,
    triangles: Tree<TriangleLeaf>,
    spheres: Tree<SphereLeaf>,
    customs: Tree<CustomLeaf>,
}

impl Bvh {
    /// Builds the hierarchy of the lowest quality. Every coordinate has to be finite.
    pub fn new(shapes: &dyn Shapes) -> Self {
        Self::with_quality(shapes, BuildQuality::default())
    }

    /// Builds the hierarchy. Every coordinate has to be finite.
    pub fn with_quality(shapes: &dyn Shapes, quality: BuildQuality) -> Self {
        let [triangles, spheres, customs] = by_kind(shapes);
        Self {
            count: shapes.count(),
            is_brute_force: false,
            quality,
            triangles: Tree::build(shapes, &triangles, quality),
            spheres: Tree::build(shapes, &spheres, quality),
            customs: Tree::build(shapes, &customs, quality),
        }
    }

    /// A plain list, to compare with: every ray is tested against every primitive. Every coordinate
    /// has to be finite.
    pub fn list(shapes: &dyn Shapes) -> Self {
        let [triangles, spheres, customs] = by_kind(shapes);
        Self {
            count: shapes.count(),
            is_brute_force: true,
            quality: BuildQuality::default(),
            triangles: Tree::list(shapes, &triangles),
            spheres: Tree::list(shapes, &spheres),
            customs: Tree::list(shapes, &customs),
        }
    }

    /// Takes over where primitives have moved to. Every coordinate has to be finite.
    ///
    /// Boxes are refitted, which takes a fraction of the time of a new hierarchy; once this one has
    /// become too much worse than when it was built, or the number or kinds of the primitives are
    /// others, a new one is built.
    pub fn update(&mut self, shapes: &dyn Shapes) {
        let fits = shapes.count() == self.count
            && self.triangles.refit(shapes)
            && self.spheres.refit(shapes)
            && self.customs.refit(shapes);
        let worse = || {
            let costs = [
                self.triangles.degradation(),
                self.spheres.degradation(),
                self.customs.degradation(),
            ];
            costs.into_iter().any(|cost| cost > REBUILD_ABOVE)
        };
        if !fits || worse() {
            *self = match self.is_brute_force {
                true => Self::list(shapes),
                false => Self::with_quality(shapes, self.quality),
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
        let ray = (origin, direction, test.scale);
        nearest_of(&self.spheres, &boxes, ray, &mut nearest, &mut found);
        nearest_of(&self.customs, &boxes, ray, &mut nearest, &mut found);
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
        let is_start = |primitive| from == Some(primitive);
        self.is_occluded_by_any(origin, direction, limit, is_start, |_| false)
    }

    /// Whether anything is met before `limit` but the primitives that `counts_not` holds for.
    #[inline]
    pub fn is_occluded_but(
        &self,
        origin: Vec3,
        direction: Vec3,
        limit: f32,
        counts_not: impl Fn(u32) -> bool,
    ) -> bool {
        self.is_occluded_by_any(origin, direction, limit, &counts_not, &counts_not)
    }

    /// The same, apart for triangles and for other primitives.
    #[inline]
    fn is_occluded_by_any(
        &self,
        origin: Vec3,
        direction: Vec3,
        limit: f32,
        no_triangle: impl Fn(u32) -> bool,
        no_other: impl Fn(u32) -> bool,
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
                occluded = !no_triangle(leaf.ids[lane]);
            }
            if occluded { -1.0 } else { depth_limit }
        });
        let ray = (origin, direction, test.scale);
        occluded
            || is_occluded_by(&self.spheres, &boxes, ray, limit, &no_other)
            || is_occluded_by(&self.customs, &boxes, ray, limit, &no_other)
    }

    /// Visits what a ray goes through before `limit` but `from`, the flat primitive that the ray starts on, in no
    /// order: a sphere as often as the ray goes through its surface, each time with whether it leaves it.
    /// A visit returns whether to go on.
    pub fn visit_crossings(
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
        let ray = (origin, direction, test.scale);
        let goes_on = goes_on && visit_crossings(&self.spheres, &boxes, ray, limit, &mut visit);
        if goes_on {
            visit_crossings(&self.customs, &boxes, ray, limit, &mut visit);
        }
    }
}

/// Origin, direction, and the length of the direction for each unit of depth.
type Ray = (Vec3, Vec3, f32);

/// Looks for a primitive that is nearer than the depth `nearest`.
fn nearest_of<L: SingleLeaf>(
    tree: &Tree<L>,
    boxes: &BoxTest,
    (origin, direction, scale): Ray,
    nearest: &mut f32,
    found: &mut Option<Hit>,
) {
    tree.visit(boxes, *nearest, |leaf, _| {
        let (distance, leaves) = leaf.distance(origin, direction);
        if distance / scale < *nearest {
            *nearest = distance / scale;
            *found = Some(Hit { primitive: leaf.id(), distance, leaves });
        }
        *nearest
    });
}

/// Whether a primitive is hit before `limit`, which is in lengths of the direction. A ray may start on
/// one and hit it again: it is not flat.
fn is_occluded_by<L: SingleLeaf>(
    tree: &Tree<L>,
    boxes: &BoxTest,
    (origin, direction, scale): Ray,
    limit: f32,
    counts_not: impl Fn(u32) -> bool,
) -> bool {
    let mut occluded = false;
    tree.visit(boxes, limit / scale, |leaf, _| {
        occluded |= leaf.distance(origin, direction).0 < limit && !counts_not(leaf.id());
        if occluded { -1.0 } else { limit / scale }
    });
    occluded
}

/// Visits what a ray goes through before `limit`, until a visit says that it is enough; returns whether
/// none did.
fn visit_crossings<L: SingleLeaf>(
    tree: &Tree<L>,
    boxes: &BoxTest,
    (origin, direction, scale): Ray,
    limit: f32,
    visit: &mut impl FnMut(u32, bool) -> bool,
) -> bool {
    let mut goes_on = true;
    tree.visit(boxes, limit / scale, |leaf, _| {
        for leaves in leaf.crossings(origin, direction, limit) {
            goes_on = goes_on && visit(leaf.id(), leaves);
        }
        if goes_on { limit / scale } else { -1.0 }
    });
    goes_on
}
