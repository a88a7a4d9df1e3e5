//! The sphere.

use ad::{Real, Vec3};

/// A sphere, seen from outside or inside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere<S: Real> {
    /// Its centre.
    pub center: Vec3<S>,
    /// Its radius, above 0.
    pub radius: S,
}
