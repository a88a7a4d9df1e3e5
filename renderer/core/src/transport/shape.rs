//! Custom shapes: where rays meet them.

use ad::vector::Vector;
use ad::{Differentiable, Real, Vec3, differentiable, select};
use glam::DVec3;

use super::camera::Ray;
use super::surface::SurfacePoint;
use super::transform::{Transform, rotate, unplace};

/// Where a ray meets a shape.
#[derive(Clone, Copy, Debug, Differentiable)]
pub struct Intersection<S: Real> {
    /// The distance to the first point above 0.
    pub distance: S,
    /// The normal there, of any length above 0 and on either side.
    pub normal: Vec3<S>,
    /// A number that is positive where the ray meets the shape, and falls to zero as it comes to its
    /// silhouette: a discriminant, or the distance to a border. Where it is negative, distance and
    /// normal do not count, but should be finite: take the square root of `max(discriminant, 0)`.
    pub margin: S,
}

/// A shape: the numbers `self`, and where rays meet it.
#[differentiable]
pub trait Shape {
    /// The scalar of the numbers.
    type Scalar: Real;

    /// Where a ray meets the shape first. A shape that has no point on the ray has a negative margin, or
    /// a distance that is not above 0.
    fn intersect(self, ray: Ray<Self::Scalar>) -> Intersection<Self::Scalar>;
}

/// The box around a shape.
pub trait Bounded {
    /// The lowest and the highest corner of a box that holds the shape.
    fn bounds(&self) -> (DVec3, DVec3);
}

/// Where a ray meets a shape that is placed in the world. The shape meets the ray in its own
/// coordinates, where lengths and normals differ by the scale.
#[differentiable]
#[inline]
pub fn placed_intersection<S: Real, T: Shape<Scalar = S> + Differentiable + Copy>(
    shape: T,
    transform: Transform<S>,
    ray: Ray<S>,
) -> Intersection<S> {
    let inverse = transform.scale.recip();
    let origin = unplace::<S>(transform, ray.origin);
    let direction = rotate::<S>(-transform.rotation, ray.direction) * inverse;
    let length_recip = direction.length_recip();
    let found = shape.intersect(Ray { origin, direction: direction * length_recip });
    Intersection {
        distance: found.distance * length_recip,
        normal: rotate::<S>(transform.rotation, found.normal * inverse),
        margin: found.margin,
    }
}

/// The surface point where a ray meets a shape that is placed in the world.
#[differentiable]
#[inline]
pub fn placed_point<S: Real, T: Shape<Scalar = S> + Differentiable + Copy>(
    shape: T,
    transform: Transform<S>,
    ray: Ray<S>,
) -> SurfacePoint<S> {
    let found = placed_intersection::<S, T>(shape, transform, ray);
    let normal = found.normal.normalize();
    let behind = normal.dot(ray.direction).cmpgt(S::ZERO);
    SurfacePoint {
        point: ray.origin + ray.direction * found.distance,
        normal: select(behind, -normal, normal),
        view: -ray.direction,
    }
}
