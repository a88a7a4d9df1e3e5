//! Where a ray meets a primitive.

use ad::{Differentiable, Real, Vec3, differentiable};

use super::camera::Ray;
use super::sphere::{Sphere, sphere_point, sphere_uv};
use super::surface::SurfacePoint;
use super::texture::Uv;
use super::triangle::{Triangle, triangle_point, triangle_uv};

/// A primitive of a known kind. The kind is the same in every lane.
#[derive(Clone, Copy, Debug, Differentiable)]
#[non_exhaustive]
pub enum Primitive<S: Real> {
    /// A flat triangle.
    Triangle(Triangle<S>),
    /// A sphere.
    Sphere(Sphere<S>),
}

/// The point where a ray meets a primitive. A ray that starts inside of a sphere leaves it at that
/// point; for triangles `inside` does not count.
#[differentiable]
#[inline]
pub fn hit<S: Real>(primitive: Primitive<S>, inside: S::Mask, ray: Ray<S>) -> SurfacePoint<S> {
    match primitive {
        Primitive::Triangle(triangle) => triangle_point::<S>(triangle, ray),
        Primitive::Sphere(sphere) => sphere_point::<S>(sphere, inside, ray),
    }
}

/// The texture coordinates of a point on a primitive. Triangles interpolate those of their `corners`,
/// spheres have their own.
#[differentiable]
#[inline]
pub fn surface_uv<S: Real>(primitive: Primitive<S>, corners: [Uv<S>; 3], point: Vec3<S>) -> Uv<S> {
    match primitive {
        Primitive::Triangle(triangle) => triangle_uv::<S>(triangle, corners, point),
        Primitive::Sphere(sphere) => sphere_uv::<S>(sphere, point),
    }
}
