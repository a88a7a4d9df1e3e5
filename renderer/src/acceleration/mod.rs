//! Which primitive does a ray meet first, and is anything in its way?
//!
//! These questions have discrete answers, so nothing here is differentiated, and everything is
//! `f32` whatever the kernels compute in.

#[cfg(test)]
mod tests;
mod triangle_test;

use glam::{Vec3, Vec3A};
use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2;
use obvhs::ray::{Ray, RayHit};

use triangle_test::TriangleTest;

/// A primitive as traversal sees it.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    /// Three corners.
    Triangle([Vec3; 3]),
    /// Centre and radius.
    Sphere(Vec3, f32),
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

/// A bounding volume hierarchy over primitives.
pub struct Acceleration {
    tree: Bvh2,
    /// In the order of the tree's leaves.
    shapes: Vec<Shape>,
    /// The index that the user knows each of `shapes` by.
    ids: Vec<u32>,
}

impl Acceleration {
    /// Builds the tree. Every coordinate has to be finite.
    pub fn new(shapes: &[Shape]) -> Self {
        let bounds: Vec<Aabb> = shapes.iter().map(bounds).collect();
        let mut build_time = std::time::Duration::ZERO;
        let tree = build_bvh2(&bounds, BvhBuildParams::medium_build(), &mut build_time);
        let ids = tree.primitive_indices.clone();
        let shapes = ids.iter().map(|&id| shapes[id as usize]).collect();
        Self { tree, shapes, ids }
    }

    /// The nearest primitive along the ray.
    pub fn nearest(&self, origin: Vec3, direction: Vec3) -> Option<Hit> {
        let test = TriangleTest::new(origin, direction)?;
        let ray = Ray::new(origin.into(), direction.into(), 0.0, f32::INFINITY);
        let mut found = RayHit::none();
        self.tree.ray_traverse(ray, &mut found, |_, index| {
            self.distance(&test, origin, direction, index).0
        });
        let index = found.primitive_id as usize;
        let &primitive = self.ids.get(index)?;
        let (distance, leaves) = self.distance(&test, origin, direction, index);
        Some(Hit { primitive, distance, leaves })
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
        let ray = Ray::new(origin.into(), direction.into(), 0.0, limit);
        !self.tree.ray_traverse_miss(ray, |_, index| match from {
            Some(from) if from == self.ids[index] => f32::INFINITY,
            _ => self.distance(&test, origin, direction, index).0,
        })
    }

    /// The distance to a primitive, infinite if it is missed, and whether the ray leaves it.
    fn distance(
        &self,
        test: &TriangleTest,
        origin: Vec3,
        direction: Vec3,
        index: usize,
    ) -> (f32, bool) {
        match self.shapes[index] {
            Shape::Triangle(corners) => (test.distance(corners), false),
            Shape::Sphere(center, radius) => sphere_distance(origin, direction, center, radius),
        }
    }
}

/// The box around a shape, a few rounding errors wider than it: a slab test that rounds must not
/// miss what lies on the face of a box.
fn bounds(shape: &Shape) -> Aabb {
    let exact = match *shape {
        Shape::Triangle(corners) => Aabb::from_points(&corners.map(Vec3A::from)),
        Shape::Sphere(center, radius) => {
            Aabb::new((center - radius).into(), (center + radius).into())
        }
    };
    let margin = 4.0 * f32::EPSILON * exact.min.abs().max(exact.max.abs()).max_element();
    Aabb::new(exact.min - margin, exact.max + margin)
}

/// The distance at which a ray with a unit direction enters or, from inside, leaves a sphere.
/// Computed in double precision: a sphere that is small or far would lose its edge in single.
fn sphere_distance(origin: Vec3, direction: Vec3, center: Vec3, radius: f32) -> (f32, bool) {
    let (direction, radius) = (direction.as_dvec3(), f64::from(radius));
    let from_center = origin.as_dvec3() - center.as_dvec3();
    let along = -from_center.dot(direction) / direction.length_squared();
    let offset = from_center + direction * along;
    let discriminant = radius * radius - offset.length_squared();
    if discriminant < 0.0 {
        return (f32::INFINITY, false);
    }
    let half_chord = (discriminant / direction.length_squared()).sqrt();
    let (near, far) = (along - half_chord, along + half_chord);
    if near > 0.0 {
        (near as f32, false)
    } else if far > 0.0 {
        (far as f32, true)
    } else {
        (f32::INFINITY, false)
    }
}
