//! Where a ray meets a triangle.

use ad::vector::{Vector, Vector3};
use ad::{Real, Vec3, differentiable, select};

use super::camera::Ray;
use super::surface::SurfacePoint;

/// The point where a ray meets the plane of the triangle `a`, `b`, `c`.
///
/// The triangle is flat shaded and seen from both sides. A triangle without area, or one that the
/// ray runs along, has no such point; traversal never reports one.
#[differentiable]
#[inline]
pub fn triangle_surface<S: Real>(
    ray: Ray<S>,
    a: Vec3<S>,
    b: Vec3<S>,
    c: Vec3<S>,
) -> SurfacePoint<S> {
    let normal = exact_cross::<S>(b - a, c - a);
    let slope = ray.direction.dot(normal);
    let distance = (a - ray.origin).dot(normal) / slope;
    let unit = normal.normalize();
    SurfacePoint {
        point: ray.origin + ray.direction * distance,
        normal: select(slope.cmpgt(S::ZERO), -unit, unit),
        view: -ray.direction,
    }
}

/// The vector product without cancellation, for the normals of needles.
#[differentiable]
#[inline]
pub fn exact_cross<S: Real>(u: Vec3<S>, v: Vec3<S>) -> Vec3<S> {
    <Vec3<S>>::new(
        S::difference_of_products(u.y(), v.z(), v.y(), u.z()),
        S::difference_of_products(u.z(), v.x(), v.z(), u.x()),
        S::difference_of_products(u.x(), v.y(), v.x(), u.y()),
    )
}
