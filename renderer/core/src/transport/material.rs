//! The material, rough diffuse below a Blinn-Phong highlight, and the light it reflects.

use std::f64::consts::{FRAC_1_PI, PI};

use ad::vector::Vector;
use ad::{Differentiable, Fields, Real, Vec3, differentiable, select};

use super::positive_part;
use super::surface::SurfacePoint;

/// A diffuse material with a Blinn-Phong highlight; colours are linear RGB.
#[derive(Clone, Copy, Debug, PartialEq, Differentiable, Fields)]
pub struct Material<S: Real> {
    /// The radiance that the surface emits.
    pub emission: Vec3<S>,
    /// The albedo of the diffuse part.
    pub diffuse: Vec3<S>,
    /// The roughness of the diffuse part, from 0, which is Lambert's, to 1: how much of its light goes
    /// back to where it comes from, as that of dust, plaster and clay does.
    pub roughness: S,
    /// The albedo of the highlight.
    pub specular: Vec3<S>,
    /// The sharpness of the highlight; 0 or more.
    pub exponent: S,
    /// The part of the radiance from the mirror direction that is added; 0 is no mirror.
    pub mirror: Vec3<S>,
    /// The part of its own radiance that a transparent surface shows; the rest is what lies straight
    /// behind it. 1 for opaque materials.
    pub opacity: S,
}

impl Material<f64> {
    /// The lobes that its BRDF has.
    pub(crate) fn lobes(&self) -> Lobes {
        Lobes { rough: self.roughness != 0.0, glossy: self.specular != glam::DVec3::ZERO }
    }

    /// An opaque Lambertian material.
    pub fn lambertian(albedo: glam::DVec3) -> Self {
        Self {
            emission: glam::DVec3::ZERO,
            diffuse: albedo,
            roughness: 0.0,
            specular: glam::DVec3::ZERO,
            exponent: 1.0,
            mirror: glam::DVec3::ZERO,
            opacity: 1.0,
        }
    }
}

/// A grey Lambertian material of albedo 0.7: what files that name no material get.
impl Default for Material<f64> {
    fn default() -> Self {
        Self::lambertian(glam::DVec3::splat(0.7))
    }
}

/// What BRDFs have beside Lambert's; the other terms are not computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Differentiable)]
pub struct Lobes {
    /// A roughness.
    pub rough: bool,
    /// A highlight.
    pub glossy: bool,
}

impl Lobes {
    /// Those that any of two has.
    pub(crate) fn union(self, other: Self) -> Self {
        Self { rough: self.rough | other.rough, glossy: self.glossy | other.glossy }
    }
}

/// The BRDF of a material for light from `direction`, a unit vector: its diffuse part, and
/// `specular / π * max(n · h, 0)^exponent`, where `h` is the direction half-way between light and viewer
/// (Blinn 1977). `lobes` holds those of all lanes.
///
/// The highlight is not normalised, as in RayTracer.jl: `exponent` changes its energy. Unlike there,
/// both parts are multiplied by the cosine of the light, so that the highlight fades towards the shadow
/// side instead of ending at an edge.
#[differentiable]
#[inline]
pub fn brdf<S: Real>(
    material: Material<S>,
    lobes: Lobes,
    surface: SurfacePoint<S>,
    direction: Vec3<S>,
) -> Vec3<S> {
    let mut reflectance = material.diffuse;
    if lobes.rough {
        reflectance = reflectance * rough_diffuse::<S>(material.roughness, surface, direction);
    }
    if lobes.glossy {
        let half_way = (direction + surface.view).normalize_or_zero();
        let alignment = positive_part::<S>(surface.normal.dot(half_way));
        reflectance = reflectance + material.specular * alignment.powf(material.exponent);
    }
    reflectance * S::from_f64(FRAC_1_PI)
}

/// The BRDF of a rough diffuse surface, by Lambert's: facets in all directions, which are Lambertian and
/// hide each other (Oren & Nayar 1994), in the form of Fujii, which has no ring (Portsmouth, Kutz & Hill
/// 2024). It has a kink where light and viewer are at the same angle from the normal. The light that facets send to each other is left out: at `roughness` 1 the mean albedo is 0.83.
#[differentiable]
#[inline]
fn rough_diffuse<S: Real>(roughness: S, surface: SurfacePoint<S>, direction: Vec3<S>) -> S {
    let (to_light, to_viewer) = (surface.normal.dot(direction), surface.normal.dot(surface.view));
    let along_surface = direction.dot(surface.view) - to_light * to_viewer;
    // At grazing angles the cosine of the light tends to zero faster than this to infinity.
    let largest = to_light.max(to_viewer).max(S::EPSILON);
    let ratio = select(along_surface.cmpgt(S::ZERO), along_surface / largest, along_surface);
    let energy = S::ONE + roughness * S::from_f64(0.5 - 2.0 / (3.0 * PI));
    (S::ONE + roughness * ratio) / energy
}
