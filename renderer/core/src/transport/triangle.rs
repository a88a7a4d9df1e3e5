//! The triangle.

use ad::vector::{Vector, Vector3};
use ad::{Differentiable, Fields, Real, Vec3, differentiable, select};

use super::camera::Ray;
use super::surface::SurfacePoint;
use super::texture::Uv;

/// A triangle, seen from both sides.
#[derive(Clone, Copy, Debug, Differentiable, Fields)]
pub struct Triangle<S: Real> {
    /// The first corner.
    pub a: Vec3<S>,
    /// The second corner.
    pub b: Vec3<S>,
    /// The third corner.
    pub c: Vec3<S>,
}

/// The point where a ray meets the plane of a triangle.
///
/// A triangle without area, or one that the ray runs along, has no such point; traversal never reports
/// one. In single precision the point is right for edges from 1e-20 to 1e18. For needles the normal is
/// off by the rounding error of the corners times the length over the width.
#[differentiable]
#[inline]
pub fn triangle_point<S: Real>(triangle: Triangle<S>, ray: Ray<S>) -> SurfacePoint<S> {
    let (to_b, to_c) = (triangle.b - triangle.a, triangle.c - triangle.a);
    let scale = edge_scale::<S>(to_b, to_c);
    let normal = exact_cross::<S>(to_b * scale, to_c * scale);
    let slope = ray.direction.dot(normal);
    let distance = (triangle.a - ray.origin).dot(normal) / slope;
    let unit = normal.normalize();
    SurfacePoint {
        point: ray.origin + ray.direction * distance,
        normal: select(slope.cmpgt(S::ZERO), -unit, unit),
        view: -ray.direction,
    }
}

/// The texture coordinates of a point of a triangle whose corners have the coordinates `corners`:
/// linear in the point.
#[differentiable]
#[inline]
pub fn triangle_uv<S: Real>(triangle: Triangle<S>, corners: [Uv<S>; 3], point: Vec3<S>) -> Uv<S> {
    interpolated_uv::<S>(corners, barycentric::<S>(triangle, point))
}

/// The mean of the texture coordinates of corners, by their weights.
#[differentiable]
#[inline]
pub fn interpolated_uv<S: Real>(corners: [Uv<S>; 3], [at_a, at_b, at_c]: [S; 3]) -> Uv<S> {
    Uv {
        u: corners[0].u * at_a + corners[1].u * at_b + corners[2].u * at_c,
        v: corners[0].v * at_a + corners[1].v * at_b + corners[2].v * at_c,
    }
}

/// The weights of the corners of a triangle whose mean is a point of it; they add up to 1.
#[differentiable]
#[inline]
pub fn barycentric<S: Real>(triangle: Triangle<S>, point: Vec3<S>) -> [S; 3] {
    let (to_b, to_c) = (triangle.b - triangle.a, triangle.c - triangle.a);
    let scale = edge_scale::<S>(to_b, to_c);
    let (to_b, to_c, to_point) = (to_b * scale, to_c * scale, (point - triangle.a) * scale);
    let normal = exact_cross::<S>(to_b, to_c);
    let area_squared = normal.length_squared();
    let at_b = normal.dot(to_point.cross(to_c)) / area_squared;
    let at_c = normal.dot(to_b.cross(to_point)) / area_squared;
    [S::ONE - at_b - at_c, at_b, at_c]
}

/// A power of two that brings edges to lengths whose fourth power, the squared length of a normal,
/// single precision can hold. It is a constant: nothing that it is used for depends on the length of a
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
