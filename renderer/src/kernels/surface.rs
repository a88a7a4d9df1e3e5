//! The point where a ray meets a surface.

use ad::vector::Vector;
use ad::{Differentiable, Real, Vec3, differentiable};

use super::camera::Ray;

/// A point of a surface, as shading needs it.
#[derive(Clone, Copy, Debug, Differentiable)]
pub struct SurfacePoint<S: Real> {
    /// Where it is.
    pub point: Vec3<S>,
    /// The unit normal, on the side of the viewer.
    pub normal: Vec3<S>,
    /// The unit vector towards the viewer.
    pub view: Vec3<S>,
}

/// The ray whose radiance a mirror sends to the viewer.
#[differentiable]
#[inline]
pub fn mirrored_ray<S: Real>(surface: SurfacePoint<S>) -> Ray<S> {
    let cosine = surface.normal.dot(surface.view);
    Ray { origin: surface.point, direction: surface.normal * (cosine + cosine) - surface.view }
}
