//! Point and distant lights.

use ad::{Real, Vec3};

/// A light that shines from a point in all directions.
///
/// The irradiance it brings to a surface that faces it at distance `r` is
/// `color * intensity / (4 pi r^2)`: `intensity` is the radiant flux.
#[derive(Clone, Copy, Debug, PartialEq)]
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
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DistantLight<S: Real> {
    /// The direction towards the light; need not be a unit vector.
    pub direction: Vec3<S>,
    /// Linear RGB.
    pub color: Vec3<S>,
    /// Irradiance.
    pub intensity: S,
}
