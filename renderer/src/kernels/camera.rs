//! The pinhole camera.

use ad::vector::{Vector, Vector3};
use ad::{Differentiable, Real, Vec3, differentiable};

/// A pinhole camera. Lengths are in scene units, the field of view in degrees.
///
/// The image plane stands at distance 1 before `look_from`; its half height is
/// `focus * tan(vfov / 2)`. This is the convention of RayTracer.jl: `focus` zooms.
#[derive(Clone, Copy, Debug, PartialEq, Differentiable)]
pub struct Camera<S: Real> {
    /// Where the camera stands.
    pub look_from: Vec3<S>,
    /// The point in the middle of the image.
    pub look_at: Vec3<S>,
    /// A direction that points upwards in the image; need not be a unit vector.
    pub up: Vec3<S>,
    /// The vertical field of view at `focus` 1, in degrees.
    pub vfov: S,
    /// The factor on the size of the image plane.
    pub focus: S,
}

/// What all rays of an image share: the pinhole and the image plane.
#[derive(Clone, Copy, Debug, Differentiable)]
pub struct Frame<S: Real> {
    /// The pinhole.
    pub origin: Vec3<S>,
    /// From the pinhole to the middle of the image plane; a unit vector.
    pub forward: Vec3<S>,
    /// From there to the middle of the right edge.
    pub right: Vec3<S>,
    /// From there to the middle of the upper edge.
    pub up: Vec3<S>,
}

/// A ray.
#[derive(Clone, Copy, Debug, Differentiable)]
pub struct Ray<S: Real> {
    /// Where it starts.
    pub origin: Vec3<S>,
    /// Where it goes; a unit vector.
    pub direction: Vec3<S>,
}

/// The frame of a camera whose image is `aspect` times as wide as it is high.
#[differentiable]
#[inline]
pub fn frame<S: Real>(camera: Camera<S>, aspect: S) -> Frame<S> {
    let backward = (camera.look_from - camera.look_at).normalize();
    let right = camera.up.cross(backward).normalize();
    let up = backward.cross(right);
    let half_angle = camera.vfov * (S::PI / S::from_f64(360.0));
    let half_height = half_angle.tan() * camera.focus;
    Frame {
        origin: camera.look_from,
        forward: -backward,
        right: right * (half_height * aspect),
        up: up * half_height,
    }
}

/// From the pinhole to the point `(x, y)` of the image plane: -1 is the left and the lower edge, 1
/// the right and the upper one.
#[differentiable]
#[inline]
pub fn film_point<S: Real>(frame: Frame<S>, x: S, y: S) -> Vec3<S> {
    frame.forward + frame.right * x + frame.up * y
}

/// The ray through the point `(x, y)` of the image plane.
#[differentiable]
#[inline]
pub fn primary_ray<S: Real>(frame: Frame<S>, x: S, y: S) -> Ray<S> {
    Ray { origin: frame.origin, direction: film_point::<S>(frame, x, y).normalize() }
}
