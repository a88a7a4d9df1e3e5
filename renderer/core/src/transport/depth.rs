//! How far what a camera sees is from it.

use ad::vector::Vector;
use ad::{Real, Vec3, differentiable};

use super::camera::CameraFrame;

/// The distance of a point from the plane through the pinhole that is parallel to the image plane: the depth
/// that sensors measure, and not the length of the ray.
#[differentiable]
#[inline]
pub fn depth<S: Real>(frame: CameraFrame<S>, point: Vec3<S>) -> S {
    (point - frame.origin).dot(frame.forward)
}
