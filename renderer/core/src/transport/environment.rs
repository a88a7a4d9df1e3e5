//! What surrounds a scene.

use ad::{Differentiable, Fields, Real, Vec3};

/// Light from infinitely far in all directions: what rays bring that meet nothing.
#[derive(Clone, Copy, Debug, PartialEq, Differentiable, Fields)]
pub struct Environment<S: Real> {
    /// The radiance, the same from everywhere.
    pub radiance: Vec3<S>,
}
