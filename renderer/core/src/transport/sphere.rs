//! The sphere.

use ad::vector::{Vector, Vector3};
use ad::{Differentiable, Fields, Real, Vec3, differentiable, select};

use super::camera::Ray;
use super::positive_part;
use super::surface::SurfacePoint;
use super::texture::Uv;
use super::transform::rotate;

/// A sphere, seen from outside or inside.
#[derive(Clone, Copy, Debug, PartialEq, Differentiable, Fields)]
pub struct Sphere<S: Real> {
    /// The centre.
    pub center: Vec3<S>,
    /// The radius, above 0.
    pub radius: S,
    /// How a texture is turned about the centre: the axis times the angle in degrees, as in a
    /// [`Transform`](super::transform::Transform).
    pub rotation: Vec3<S>,
}

/// The point where a ray enters a sphere, or leaves it where the ray starts `inside`.
///
/// The discriminant is taken from the distance between the ray and the centre, and the nearer root
/// from the product of both, which does not cancel for small and for distant spheres (Haines,
/// Günther & Akenine-Möller, "Precision Improvements for Ray/Sphere Intersection", 2019). At a
/// grazing hit the derivative of the root counts as 0.
#[differentiable]
#[inline]
pub fn sphere_point<S: Real>(sphere: Sphere<S>, inside: S::Mask, ray: Ray<S>) -> SurfacePoint<S> {
    let from_center = ray.origin - sphere.center;
    let along = -from_center.dot(ray.direction);
    let offset = from_center + ray.direction * along;
    let radius = sphere.radius;
    let discriminant = positive_part::<S>(radius * radius - offset.length_squared());
    let far = along + discriminant.sqrt().copysign(along);
    let product = from_center.length_squared() - radius * radius;
    // Both roots are zero, but for rounding, where the ray starts at the point in which it touches the sphere.
    let touches = (far * far).cmple(S::EPSILON * radius * radius);
    let near = select(touches, S::ZERO, product / far);
    let distance = select(inside, near.max(far), near.min(far));

    // Back onto the sphere, which the distance misses by its rounding error.
    let outward = (from_center + ray.direction * distance).normalize();
    SurfacePoint {
        point: sphere.center + outward * radius,
        normal: select(inside, -outward, outward),
        view: -ray.direction,
    }
}

/// The texture coordinates of a point of a sphere: longitude and latitude about the y axis of the
/// sphere, which runs from the lower edge of the texture to the upper one; its middle lies towards +z.
/// At the poles the derivatives count as 0.
#[differentiable]
#[inline]
pub fn sphere_uv<S: Real>(sphere: Sphere<S>, point: Vec3<S>) -> Uv<S> {
    let outward = rotate::<S>(-sphere.rotation, (point - sphere.center) / sphere.radius);
    let longitude = outward.x().atan2(outward.z());
    // Not the arc sine of y, which loses half of the digits near the poles.
    let from_axis = (outward.x() * outward.x() + outward.z() * outward.z()).sqrt();
    let latitude = outward.y().atan2(from_axis);
    Uv { u: S::HALF + longitude / (S::PI + S::PI), v: S::HALF + latitude / S::PI }
}
