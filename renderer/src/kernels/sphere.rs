//! The sphere, and where a ray meets it.

use ad::vector::Vector;
use ad::{Differentiable, Real, Vec3, differentiable, select};

use super::camera::Ray;
use super::surface::{SurfacePoint, positive_part};

/// A sphere, seen from outside or inside.
#[derive(Clone, Copy, Debug, PartialEq, Differentiable)]
pub struct Sphere<S: Real> {
    /// Its centre.
    pub center: Vec3<S>,
    /// Its radius, above 0.
    pub radius: S,
}

/// The point where a ray enters a sphere, or leaves it where `leaves` holds.
///
/// The discriminant is taken from the distance between the ray and the centre, and the nearer root
/// from the product of both, which does not cancel for small and for distant spheres (Haines,
/// Günther & Akenine-Möller, "Precision Improvements for Ray/Sphere Intersection", 2019). At a
/// grazing hit the derivative of the root counts as 0.
#[differentiable]
#[inline]
pub fn sphere_surface<S: Real>(ray: Ray<S>, sphere: Sphere<S>, leaves: S::Mask) -> SurfacePoint<S> {
    let from_center = ray.origin - sphere.center;
    let along = -from_center.dot(ray.direction);
    let offset = from_center + ray.direction * along;
    let radius = sphere.radius;
    let discriminant = positive_part::<S>(radius * radius - offset.length_squared());
    let far = along + discriminant.sqrt().copysign(along);
    let product = from_center.length_squared() - radius * radius;
    // Both roots are zero where the ray starts at the point in which it touches the sphere.
    let near = select(far.cmpeq(S::ZERO), S::ZERO, product / far);
    let distance = select(leaves, near.max(far), near.min(far));

    // Back onto the sphere, which the distance misses by its rounding error.
    let outward = (from_center + ray.direction * distance).normalize();
    SurfacePoint {
        point: sphere.center + outward * radius,
        normal: select(leaves, -outward, outward),
        view: -ray.direction,
    }
}
