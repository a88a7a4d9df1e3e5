//! Edges: numbers of a ray that vanish where the ray meets the boundary of what it sees.
//!
//! On the film such a number is a function of position whose zeros are a curve. When a parameter moves
//! the curve, a point of it moves along its normal by minus the derivative by the parameter over the
//! length of the derivative by the position, so the scale of a number does not count, and neither does
//! its sign.

use ad::vector::{Vector, Vector3};
use ad::{Real, Vec3, differentiable};

use super::camera::Ray;
use super::sphere::Sphere;
use super::triangle::Triangle;

/// The number of the straight edge from `a` to `b`: the volume that a ray spans with it.
#[differentiable]
#[inline]
pub fn segment_margin<S: Real>(a: Vec3<S>, b: Vec3<S>, ray: Ray<S>) -> S {
    (a - ray.origin).cross(b - ray.origin).dot(ray.direction)
}

/// The number of the silhouette of a sphere: the squared radius without the squared distance between
/// the centre and a ray.
#[differentiable]
#[inline]
pub fn sphere_margin<S: Real>(sphere: Sphere<S>, ray: Ray<S>) -> S {
    let to_center = sphere.center - ray.origin;
    let offset = to_center - ray.direction * to_center.dot(ray.direction);
    sphere.radius * sphere.radius - offset.length_squared()
}

/// The number of a place on the plane of a triangle: the volume that it spans with the corners.
#[differentiable]
#[inline]
pub fn plane_margin<S: Real>(triangle: Triangle<S>, place: Vec3<S>) -> S {
    (triangle.a - place).cross(triangle.b - place).dot(triangle.c - place)
}

/// The number of a place on a sphere: the squared radius without the squared distance from the centre.
#[differentiable]
#[inline]
pub fn ball_margin<S: Real>(sphere: Sphere<S>, place: Vec3<S>) -> S {
    sphere.radius * sphere.radius - (sphere.center - place).length_squared()
}
