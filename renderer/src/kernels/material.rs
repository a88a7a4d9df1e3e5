//! The Blinn-Phong material.

use ad::{Real, Vec3};

/// A Blinn-Phong material; colours are linear RGB.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material<S: Real> {
    /// Radiance that the surface shows without any light.
    pub ambient: Vec3<S>,
    /// Albedo of the diffuse part.
    pub diffuse: Vec3<S>,
    /// Albedo of the highlight.
    pub specular: Vec3<S>,
    /// How sharp the highlight is; 0 or more.
    pub exponent: S,
}
