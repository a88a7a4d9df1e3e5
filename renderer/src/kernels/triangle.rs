//! Where a ray meets a triangle.

use ad::vector::{Vector, Vector3};
use ad::{Real, Vec3, differentiable, select};

use super::camera::Ray;
use super::surface::SurfacePoint;

/// The point where a ray meets the plane of the triangle `a`, `b`, `c`.
///
/// The triangle is flat shaded and seen from both sides. A triangle without area, or one that the
/// ray runs along, has no such point; traversal never reports one.
///
/// In single precision it is right for edges from 1e-20 to 1e18. For needles the normal is off by
/// the rounding error of the corners times the length over the width.
#[differentiable]
#[inline]
pub fn triangle_surface<S: Real>(
    ray: Ray<S>,
    a: Vec3<S>,
    b: Vec3<S>,
    c: Vec3<S>,
) -> SurfacePoint<S> {
    let (to_b, to_c) = (b - a, c - a);
    let scale = edge_scale::<S>(to_b, to_c);
    let normal = exact_cross::<S>(to_b * scale, to_c * scale);
    let slope = ray.direction.dot(normal);
    let distance = (a - ray.origin).dot(normal) / slope;
    let unit = normal.normalize();
    SurfacePoint {
        point: ray.origin + ray.direction * distance,
        normal: select(slope.cmpgt(S::ZERO), -unit, unit),
        view: -ray.direction,
    }
}

/// A power of two that brings edges to lengths whose fourth power, the squared length of a normal,
/// single precision can hold. A constant: nothing that it is used for depends on the length of a
/// normal.
#[differentiable]
#[inline]
pub fn edge_scale<S: Real>(u: Vec3<S>, v: Vec3<S>) -> S {
    let squared = u.length_squared() + v.length_squared();
    let power = |exponent: i32| S::from_f64(2.0_f64.powi(exponent));
    let up = select(squared.cmplt(power(-40)), power(45), S::ONE);
    select(squared.cmpgt(power(40)), power(-40), up)
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
