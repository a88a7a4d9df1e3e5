//! The pinhole camera.

use ad::{Real, Vec3};

/// A pinhole camera. Lengths are in scene units, the field of view in degrees.
///
/// The image plane stands at distance 1 before `look_from`; its half height is
/// `focus * tan(vfov / 2)`. This is the convention of RayTracer.jl: `focus` zooms.
#[derive(Clone, Copy, Debug, PartialEq)]
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
