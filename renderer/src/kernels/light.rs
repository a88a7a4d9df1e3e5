//! Point and distant lights, and what they bring to a point.

use std::f64::consts::PI;

use ad::vector::Vector;
use ad::{Differentiable, Real, Vec3, differentiable, select};

use super::camera::Ray;

/// A light that shines from a point in all directions.
///
/// The irradiance it brings to a surface that faces it at distance `r` is
/// `color * intensity / (4 pi r^2)`: `intensity` is the radiant flux.
#[derive(Clone, Copy, Debug, PartialEq, Differentiable)]
pub struct PointLight<S: Real> {
    /// Where the light stands.
    pub position: Vec3<S>,
    /// Linear RGB.
    pub color: Vec3<S>,
    /// Radiant flux.
    pub intensity: S,
}

/// A light so far away that its rays are parallel.
///
/// The irradiance it brings to a surface that faces it is `color * intensity`.
#[derive(Clone, Copy, Debug, PartialEq, Differentiable)]
pub struct DistantLight<S: Real> {
    /// The direction towards the light; need not be a unit vector.
    pub direction: Vec3<S>,
    /// Linear RGB.
    pub color: Vec3<S>,
    /// Irradiance.
    pub intensity: S,
}

/// The light that arrives at a point from one direction.
#[derive(Clone, Copy, Debug, Differentiable)]
pub struct Illumination<S: Real> {
    /// The unit vector towards the light.
    pub direction: Vec3<S>,
    /// The irradiance on a surface that faces the light, linear RGB.
    pub irradiance: Vec3<S>,
}

/// What a point light brings to `point`. In the light itself, where it has no direction, it brings
/// nothing.
#[differentiable]
#[inline]
pub fn point_illumination<S: Real>(light: PointLight<S>, point: Vec3<S>) -> Illumination<S> {
    let to_light = light.position - point;
    // Its square, and no other power, is a part of a derivative: the range of distances is the largest
    // that single precision has.
    let length_recip = to_light.length_recip();
    let recip = select(length_recip.is_finite(), length_recip, S::ZERO);
    let flux_density = light.intensity * S::from_f64(0.25 / PI) * recip * recip;
    Illumination { direction: to_light.normalize_or_zero(), irradiance: light.color * flux_density }
}

/// What a distant light brings everywhere.
#[differentiable]
#[inline]
pub fn distant_illumination<S: Real>(light: DistantLight<S>) -> Illumination<S> {
    Illumination {
        direction: light.direction.normalize(),
        irradiance: light.color * light.intensity,
    }
}

/// The ray from a point towards a light that stands at `position`.
#[differentiable]
pub fn ray_to_position<S: Real>(position: Vec3<S>, point: Vec3<S>) -> Ray<S> {
    Ray { origin: point, direction: (position - point).normalize_or_zero() }
}

/// The ray from a point towards a light that is infinitely far in a direction.
#[differentiable]
pub fn ray_along<S: Real>(direction: Vec3<S>, point: Vec3<S>) -> Ray<S> {
    Ray { origin: point, direction: direction.normalize() }
}
