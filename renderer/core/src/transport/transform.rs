//! Transforms: where an object stands in the world.
//!
//! A point is scaled along the axes, rotated about the origin, and moved. The rotation is a rotation
//! vector: its direction is the axis, its length the angle in degrees, counterclockwise as seen from
//! the tip. `[0, 90, 0]` turns z to x. Chosen for optimisation: three numbers without a constraint,
//! smooth at no rotation, where every optimisation begins that knows nothing better, and equal steps
//! turn by equal angles. The map has one singularity, at whole turns (360 degrees), where it turns
//! about every axis alike: half a turn is as far as two poses are ever apart, so an optimiser does not
//! have to come near it. Turned down: Euler angles (gimbal lock within the range, and a convention to
//! remember), quaternions (a fourth number whose length means nothing and drifts), matrices (six
//! constraints).

use ad::vector::{Vector, Vector3};
use ad::{Differentiable, Fields, Real, Vec3, differentiable, select};

/// A placement in the world: scale, then rotation, then translation.
#[derive(Clone, Copy, Debug, PartialEq, Differentiable, Fields)]
pub struct Transform<S: Real> {
    /// The vector that points are moved by.
    pub translation: Vec3<S>,
    /// The rotation vector: the axis times the angle in degrees.
    pub rotation: Vec3<S>,
    /// The factors along the axes.
    pub scale: Vec3<S>,
}

impl Transform<f64> {
    /// The transform that leaves every point where it is.
    pub const IDENTITY: Self = Self {
        translation: glam::DVec3::ZERO,
        rotation: glam::DVec3::ZERO,
        scale: glam::DVec3::ONE,
    };
}

impl Default for Transform<f64> {
    fn default() -> Self {
        Self::IDENTITY
    }
}

/// A vector turned by a rotation vector in degrees (Rodrigues 1840):
/// `v + sin(a)/a r × v + (1 - cos(a))/a² r × (r × v)` with `a = |r|`.
#[differentiable]
#[inline]
pub fn rotate<S: Real>(rotation: Vec3<S>, v: Vec3<S>) -> Vec3<S> {
    let r = rotation * (S::PI / S::from_f64(180.0));
    let squared = r.length_squared();
    // Below this angle two terms of each series are exact in double precision.
    let small = squared.cmplt(S::from_f64(1e-7));
    let safe = select(small, S::ONE, squared);
    let angle = safe.sqrt();
    let half_sine = (angle * S::HALF).sin();
    let sine = select(small, S::ONE - squared / S::from_f64(6.0), angle.sin() / angle);
    let versine =
        select(small, S::HALF - squared / S::from_f64(24.0), S::TWO * half_sine * half_sine / safe);
    let once = r.cross(v);
    v + once * sine + r.cross(once) * versine
}

/// The place of a point in the world.
#[differentiable]
#[inline]
pub fn place<S: Real>(transform: Transform<S>, point: Vec3<S>) -> Vec3<S> {
    transform.translation + rotate::<S>(transform.rotation, transform.scale * point)
}

/// The place of a point in the world before it was [placed](place()).
#[differentiable]
#[inline]
pub fn unplace<S: Real>(transform: Transform<S>, point: Vec3<S>) -> Vec3<S> {
    let unmoved = point - transform.translation;
    rotate::<S>(-transform.rotation, unmoved) * transform.scale.recip()
}
