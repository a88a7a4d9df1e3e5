//! The Blinn-Phong material, and how it reflects.

use ad::vector::Vector;
use ad::{Differentiable, Real, Vec3, differentiable};

use super::light::{
    DistantLight, Illumination, PointLight, distant_illumination, point_illumination,
};
use super::surface::{SurfacePoint, positive_part};

/// A Blinn-Phong material; colours are linear RGB.
#[derive(Clone, Copy, Debug, PartialEq, Differentiable)]
pub struct Material<S: Real> {
    /// Radiance that the surface shows without any light.
    pub ambient: Vec3<S>,
    /// Albedo of the diffuse part.
    pub diffuse: Vec3<S>,
    /// Albedo of the highlight.
    pub specular: Vec3<S>,
    /// How sharp the highlight is; 0 or more.
    pub exponent: S,
    /// The part of the radiance from the mirror direction that is added; 0 is no mirror.
    pub reflection: Vec3<S>,
}

/// The radiance that a surface reflects towards the viewer:
/// `(diffuse + specular * max(n . h, 0)^exponent) * irradiance * max(n . l, 0)`, where `h` is the
/// direction half-way between light and viewer (Blinn 1977).
///
/// As in RayTracer.jl the albedo is not divided by pi. Unlike there, the highlight is multiplied
/// with the irradiance and its cosine too: it fades towards the shadow side instead of ending
/// at an edge, whose derivative would be missing from every gradient.
#[differentiable]
#[inline]
pub fn reflection<S: Real>(
    material: Material<S>,
    surface: SurfacePoint<S>,
    light: Illumination<S>,
) -> Vec3<S> {
    let cosine = positive_part::<S>(surface.normal.dot(light.direction));
    let half_way = (light.direction + surface.view).normalize_or_zero();
    let alignment = positive_part::<S>(surface.normal.dot(half_way));
    let highlight = alignment.powf(material.exponent);
    (material.diffuse + material.specular * highlight) * light.irradiance * cosine
}

/// The radiance that a point light makes a surface reflect, if nothing is between them.
#[differentiable]
#[inline]
pub fn reflection_of_point_light<S: Real>(
    material: Material<S>,
    surface: SurfacePoint<S>,
    light: PointLight<S>,
) -> Vec3<S> {
    reflection::<S>(material, surface, point_illumination::<S>(light, surface.point))
}

/// The radiance that a distant light makes a surface reflect, if nothing is between them.
#[differentiable]
#[inline]
pub fn reflection_of_distant_light<S: Real>(
    material: Material<S>,
    surface: SurfacePoint<S>,
    light: DistantLight<S>,
) -> Vec3<S> {
    reflection::<S>(material, surface, distant_illumination::<S>(light))
}

/// [`reflection()`] of a material whose `specular` is zero.
pub fn matte_reflection<S: Real>(
    diffuse: Vec3<S>,
    surface: SurfacePoint<S>,
    light: Illumination<S>,
) -> Vec3<S> {
    diffuse * light.irradiance * positive_part::<S>(surface.normal.dot(light.direction))
}
