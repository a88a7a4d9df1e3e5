//! The point where a ray meets a surface.

use ad::vector::Vector;
use ad::{Differentiable, Real, Vec3, differentiable, select};

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

/// `x`, or 0 where it is negative. Unlike `max` it keeps what is not a number, so that it shows in
/// the image.
#[differentiable]
#[inline]
pub fn positive_part<S: Real>(x: S) -> S {
    select(x.cmplt(S::ZERO), S::ZERO, x)
}

/// The ray that goes straight on behind a surface.
#[differentiable]
#[inline]
pub fn straight_ray<S: Real>(surface: SurfacePoint<S>) -> Ray<S> {
    Ray { origin: surface.point, direction: -surface.view }
}

/// The radiance of a transparent surface that shows `own` by itself and has `behind` behind it. An
/// opacity of 1 covers all of it.
#[differentiable]
#[inline]
pub fn seen_through<S: Real>(opacity: S, own: Vec3<S>, behind: Vec3<S>) -> Vec3<S> {
    own * opacity + behind * (S::ONE - opacity)
}

/// The ray whose radiance a mirror sends to the viewer.
#[differentiable]
#[inline]
pub fn mirrored_ray<S: Real>(surface: SurfacePoint<S>) -> Ray<S> {
    let cosine = surface.normal.dot(surface.view);
    Ray { origin: surface.point, direction: surface.normal * (cosine + cosine) - surface.view }
}
