//! The pinhole camera.

use ad::vector::{Vector, Vector3};
use ad::{Differentiable, Fields, Real, Vec3, differentiable};

/// A pinhole camera. Lengths are in scene units, the field of view in degrees.
///
/// The image plane stands at distance 1 before `look_from`; its half height is
/// `film_scale * tan(vfov / 2)`. This is the camera of RayTracer.jl, which calls `film_scale` its focus.
#[derive(Clone, Copy, Debug, PartialEq, Differentiable, Fields)]
pub struct Camera<S: Real> {
    /// The position of the pinhole.
    pub look_from: Vec3<S>,
    /// The point in the middle of the image.
    pub look_at: Vec3<S>,
    /// A direction that points upwards in the image; it need not be a unit vector.
    pub up: Vec3<S>,
    /// The vertical field of view at `film_scale` 1, in degrees.
    pub vfov: S,
    /// The factor on the size of the image plane: above 1 the image shows more of the scene.
    pub film_scale: S,
}

impl Camera<f64> {
    /// A camera at `look_from` that looks at `look_at`: y points upwards, the field of view is 45 degrees.
    pub fn looking(look_from: glam::DVec3, look_at: glam::DVec3) -> Self {
        Self { look_from, look_at, up: glam::DVec3::Y, vfov: 45.0, film_scale: 1.0 }
    }
}

/// What all camera rays of an image share: the pinhole and the image plane.
#[derive(Clone, Copy, Debug, Differentiable, Fields)]
pub struct CameraFrame<S: Real> {
    /// The pinhole.
    pub origin: Vec3<S>,
    /// The vector from the pinhole to the middle of the image plane; a unit vector.
    pub forward: Vec3<S>,
    /// The vector from there to the middle of the right edge.
    pub right: Vec3<S>,
    /// The vector from there to the middle of the upper edge.
    pub up: Vec3<S>,
}

/// A ray.
#[derive(Clone, Copy, Debug, Differentiable, Fields)]
pub struct Ray<S: Real> {
    /// The point where the ray starts.
    pub origin: Vec3<S>,
    /// The direction of the ray; a unit vector.
    pub direction: Vec3<S>,
}

/// The frame of a camera whose image is `aspect` times as wide as it is high.
#[differentiable]
#[inline]
pub fn camera_frame<S: Real>(camera: Camera<S>, aspect: S) -> CameraFrame<S> {
    let backward = (camera.look_from - camera.look_at).normalize();
    let right = camera.up.cross(backward).normalize();
    let up = backward.cross(right);
    let half_angle = camera.vfov * (S::PI / S::from_f64(360.0));
    let half_height = half_angle.tan() * camera.film_scale;
    CameraFrame {
        origin: camera.look_from,
        forward: -backward,
        right: right * (half_height * aspect),
        up: up * half_height,
    }
}

/// The vector from the pinhole to the point `(x, y)` of the image plane: -1 is the left and the lower
/// edge, 1 the right and the upper one.
#[differentiable]
#[inline]
pub fn film_point<S: Real>(frame: CameraFrame<S>, x: S, y: S) -> Vec3<S> {
    frame.forward + frame.right * x + frame.up * y
}

/// The ray through the point `(x, y)` of the image plane, with the coordinates of [`film_point()`].
#[differentiable]
#[inline]
pub fn primary_ray<S: Real>(frame: CameraFrame<S>, x: S, y: S) -> Ray<S> {
    Ray { origin: frame.origin, direction: film_point::<S>(frame, x, y).normalize() }
}
