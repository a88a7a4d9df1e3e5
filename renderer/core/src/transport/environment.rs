//! What surrounds a scene.

use ad::vector::Vector3;
use ad::{Differentiable, Fields, Real, Vec3, differentiable};

use super::texture::{Footprint, Uv, modulate};
use super::transform::rotate;

/// Light from infinitely far in all directions: what rays bring that meet nothing.
#[derive(Clone, Copy, Debug, PartialEq, Differentiable, Fields)]
pub struct Environment<S: Real> {
    /// The radiance from everywhere, or what multiplies a map of it.
    pub radiance: Vec3<S>,
    /// The angle by which the map is turned about the y axis, degrees, as an object would be.
    pub rotation: S,
}

impl Environment<f64> {
    /// The same radiance from everywhere.
    pub fn constant(radiance: glam::DVec3) -> Self {
        Self { radiance, rotation: 0.0 }
    }
}

/// Where a map of all directions shows one, of any length: longitude to the right, latitude upwards. The
/// longitude jumps by 1 towards +z, where a map begins and ends; at the poles it is any, with the derivative
/// 0.
#[differentiable]
#[inline]
pub fn map_coordinates<S: Real>(rotation: S, direction: Vec3<S>) -> Uv<S> {
    let (x, y, z) = (direction.x(), direction.y(), direction.z());
    let longitude = x.atan2(-z) / (S::PI + S::PI) + rotation / S::from_f64(360.0);
    let latitude = y.atan2((x * x + z * z).sqrt()) / S::PI;
    Uv { u: S::HALF + longitude, v: S::HALF + latitude }
}

/// The radiance of a map from a direction: bilinear between the middles of texels, which stand evenly in
/// longitude and latitude.
#[differentiable]
#[inline]
pub fn map_radiance<S: Real>(
    environment: Environment<S>,
    footprint: Footprint<S>,
    direction: Vec3<S>,
) -> Vec3<S> {
    let uv = map_coordinates::<S>(environment.rotation, direction);
    modulate::<S>(environment.radiance, footprint, uv)
}

/// The unit vector that is turned about the y axis by so many turns from -z towards +x, by one minus its cosine
/// with a pole: cosines lose small angles to rounding. The `pole` is 1 for +y, else -1.
#[inline]
pub fn direction_of<S: Real>([turns, versine, pole]: [S; 3]) -> Vec3<S> {
    let (around, cosine) = (turns * (S::PI + S::PI), S::ONE - versine);
    let across = (versine * (S::ONE + cosine)).max(S::ZERO).sqrt();
    Vector3::new(across * around.sin(), pole * cosine, -(across * around.cos()))
}

/// The direction, in the world, of one that is fixed to a map, which turns as an object would.
#[differentiable]
#[inline]
pub fn turned<S: Real>(rotation: S, direction: Vec3<S>) -> Vec3<S> {
    rotate::<S>(Vec3::<S>::new(S::ZERO, rotation, S::ZERO), direction)
}

/// The irradiance that a part of the environment brings to a surface that faces it: `integral` is that of the
/// map over the part, weighted by the cosine.
#[differentiable]
#[inline]
pub fn part_irradiance<S: Real>(radiance: Vec3<S>, integral: Vec3<S>) -> Vec3<S> {
    radiance * integral
}
