//! What every kind of light brings to a point.

use ad::{Differentiable, Real, Vec3};

/// The light that arrives at a point from one direction.
#[derive(Clone, Copy, Debug, Differentiable)]
pub struct Illumination<S: Real> {
    /// The unit vector towards the light.
    pub direction: Vec3<S>,
    /// The distance to the light, infinite for a distant one: what stands nearer casts a shadow.
    pub distance: S,
    /// The irradiance on a surface that faces the light, linear RGB, W/m².
    pub irradiance: Vec3<S>,
}
