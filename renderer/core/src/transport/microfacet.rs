//! The metallic-roughness material of glTF 2.0: smooth facets in many directions, on a metal or above a
//! diffuse surface.
//!
//! The facets are those of the distribution GGX (Trowbridge & Reitz 1975; Walter et al., "Microfacet Models
//! for Refraction through Rough Surfaces", 2007), and hide each other as Smith's height-correlated term
//! says (Heitz, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", 2014). They
//! reflect by Schlick's approximation. How the parts are put together is Appendix B of the specification of
//! glTF 2.0. Light that goes from facet to facet is left out: a white metal of roughness 1 reflects
//! 31 % of what it receives straight on. By that specification the diffuse base below a smooth layer does not know how much the
//! layer reflects to the viewer: at grazing angles a white one below a smooth layer reflects nearly twice what
//! it receives, at 60 degrees up to 1.02 times, and a ball of it of roughness 0.5 1.003 times.
//!
//! Directions are sampled by the facets that the viewer sees (Heitz, "Sampling the GGX Distribution of
//! Visible Normals", 2018), as caps of a sphere (Dupuy & Benyoub, "Sampling Visible GGX Normals with
//! Spherical Caps", 2023).
//!
//! **Derivatives.** [`metallic_roughness()`] is differentiated as it stands, by all of its arguments. Sampled
//! directions and their densities count as constants (detached sampling), and are: [`sampling()`] rounds the
//! roughness and the probability of a lobe that they depend on, so that they move in steps alone, and the
//! derivative of an estimate is that of the same estimate with the same random numbers. Turned down:
//! directions that move with the roughness (attached sampling). Its noise is less for a nearly smooth
//! surface, where the detached one grows as one over the width of the lobe; but what the moving directions
//! meet jumps at edges, which nobody accounts for there, so that the derivative would be wrong
//! (Zeltner, Speierer, Georgiev & Jakob, "Monte Carlo Estimators for Differential Light Transport", 2021).

use std::f64::consts::FRAC_1_PI;

use ad::vector::{Vector, Vector3};
use ad::{Differentiable, Fields, Real, Vec3, differentiable, select};

use super::direction::{cosine_direction, turn};
use super::material::Material;
use super::positive_part;
use super::surface::SurfacePoint;

/// Below this roughness facets are as wide as at it: reflections are as sharp as a mirror's to the eye, and single
/// precision does not tell half-way vectors apart.
pub const LEAST_ROUGHNESS: f64 = 0.01;
/// The least width of facets.
const SHARPEST: f64 = LEAST_ROUGHNESS * LEAST_ROUGHNESS;
/// Keeps the term of shadows, and its derivatives in single precision, finite where both light and viewer graze
/// the surface.
const GRAZING: f64 = 1e-8;
/// How many steps a factor of e of sampled widths has.
const WIDTH_STEPS: f64 = 16.0;
/// How many steps the probability of a lobe has.
const SHARE_STEPS: f64 = 8.0;

/// The BRDF of a metallic-roughness material for light from `direction`, a unit vector: its `diffuse` colour
/// is the base colour, and `ior`, the index of refraction, sets how much its dielectric part reflects.
///
/// Below the roughness 0.01 the facets are those of 0.01, and the derivative by the roughness is 0. A
/// viewer behind the shading normal, as of smooth meshes at grazing angles, sees as many facets as one who is as
/// far before it, so that the radiance does not jump where a light grazes the surface.
// Other materials pay for code that stands in their loop, and for residuals that their pullbacks would have
// room for.
#[differentiable(boxed)]
#[inline(never)]
pub fn metallic_roughness<S: Real>(
    material: Material<S>,
    surface: SurfacePoint<S>,
    direction: Vec3<S>,
) -> Vec3<S> {
    let half_way = (direction + surface.view).normalize_or_zero();
    let width = facet_width::<S>(material.roughness);
    let facets = distribution::<S>(width, surface.normal, half_way)
        * visibility::<S>(width, surface, direction);
    let grazing = schlick::<S>(surface.view.dot(half_way));
    let straight_on = normal_reflectance::<S>(material.ior);
    let layer = straight_on + (S::ONE - straight_on) * grazing;
    let color = material.diffuse;
    let white = Vec3::<S>::splat(S::ONE);
    let metal = (color + (white - color) * grazing) * facets;
    let base = color * ((S::ONE - layer) * S::from_f64(FRAC_1_PI));
    let dielectric = base + white * (layer * facets);
    dielectric * (S::ONE - material.metallic) + metal * material.metallic
}

/// The reflectance of the surface of a dielectric, straight on.
#[differentiable]
#[inline]
fn normal_reflectance<S: Real>(ior: S) -> S {
    let ratio = (ior - S::ONE) / (ior + S::ONE);
    ratio * ratio
}

/// Schlick's factor of what is reflected beyond the reflectance straight on: `(1 - cosine)⁵`.
#[differentiable]
#[inline]
fn schlick<S: Real>(cosine: S) -> S {
    let versine = positive_part::<S>(S::ONE - cosine);
    let squared = versine * versine;
    squared * squared * versine
}

/// The width of the distribution of facets: the squared roughness.
#[differentiable]
#[inline]
pub fn facet_width<S: Real>(roughness: S) -> S {
    (roughness * roughness).max(S::from_f64(SHARPEST))
}

/// The density of facets with the normal `half_way`, by solid angle and by area of the surface (GGX).
#[differentiable]
#[inline]
pub fn distribution<S: Real>(width: S, normal: Vec3<S>, half_way: Vec3<S>) -> S {
    let cosine = normal.dot(half_way);
    // Not from the cosine, which does not tell small angles apart.
    let sine_squared = normal.cross(half_way).length_squared();
    let squared = width * width;
    // No less than where the normal stands, but without a half-way vector, where light and viewer oppose.
    let least = S::from_f64(0.5 * SHARPEST * SHARPEST);
    let spread = (sine_squared + squared * (cosine * cosine)).max(least);
    squared / (spread * spread * S::PI)
}

/// The part of facets that both light and viewer see, by four times the product of their cosines (Smith,
/// height-correlated).
#[differentiable]
#[inline]
pub fn visibility<S: Real>(width: S, surface: SurfacePoint<S>, direction: Vec3<S>) -> S {
    let to_light = positive_part::<S>(surface.normal.dot(direction));
    let to_viewer = surface.normal.dot(surface.view).abs();
    let both = to_light * slope::<S>(width, to_viewer) + to_viewer * slope::<S>(width, to_light);
    S::HALF / both.max(S::from_f64(GRAZING))
}

/// The square root of `width² + (1 - width²) cosine²`.
#[differentiable]
#[inline]
fn slope<S: Real>(width: S, cosine: S) -> S {
    let squared = width * width;
    (squared + (S::ONE - squared) * (cosine * cosine)).sqrt()
}

/// How directions are sampled at a surface point.
#[derive(Clone, Copy, Debug, Differentiable, Fields)]
pub struct Sampling<S: Real> {
    /// The width of the facets that directions are sampled by.
    pub width: S,
    /// The probability of a direction that facets reflect to; the others are those of a diffuse surface.
    pub share: S,
}

/// How directions are sampled at a point of a metallic-roughness material. All numbers are rounded, so that
/// they have no derivative: the width upwards, by 2 to 9 %, the share to eighths. Where the material is not
/// known to be mere metal, it `has_base`: each lobe is sampled at least one time in eight.
pub fn sampling<S: Real>(
    material: Material<S>,
    surface: SurfacePoint<S>,
    has_base: S::Mask,
) -> Sampling<S> {
    let steps = S::from_f64(WIDTH_STEPS);
    // Away from common values, at which rounding errors would decide.
    let offset = S::from_f64(0.37);
    let position = facet_width::<S>(material.roughness).ln() * steps + offset;
    let width = (-(-position).floor() / steps).exp();

    let grazing = schlick::<S>(positive_part::<S>(surface.normal.dot(surface.view)));
    let straight_on = normal_reflectance::<S>(material.ior);
    let layer = straight_on + (S::ONE - straight_on) * grazing;
    let brightest = material.diffuse.max_element();
    let dielectric = S::ONE - material.metallic;
    let metal = brightest + (S::ONE - brightest) * grazing;
    let reflected = dielectric * layer + material.metallic * metal;
    let diffuse = dielectric * (S::ONE - layer) * brightest;
    let part = reflected / (reflected + diffuse).max(S::from_f64(1e-30));
    let steps = S::from_f64(SHARE_STEPS);
    let rounded = (part * steps + S::HALF).floor() / steps;
    let least = S::ONE / steps;
    let both = rounded.clamp(least, S::ONE - least);
    Sampling { width, share: select(has_base, both, S::ONE) }
}

/// The surface point as a viewer sees it who is not behind its normal.
#[differentiable]
#[inline]
fn seen_from_above<S: Real>(surface: SurfacePoint<S>) -> SurfacePoint<S> {
    let SurfacePoint { point, normal, view } = surface;
    let depth = normal.dot(view).min(S::ZERO);
    SurfacePoint { point, normal, view: (view - normal * depth).normalize_or_zero() }
}

/// The direction in which the facet reflects the viewer that two numbers from 0 to 1 choose among those he
/// sees. It may lie below the surface, where nothing is reflected.
#[differentiable]
#[inline]
pub fn facet_direction<S: Real>(width: S, surface: SurfacePoint<S>, numbers: [S; 2]) -> Vec3<S> {
    let SurfacePoint { normal, view, .. } = seen_from_above::<S>(surface);
    // Stretched until facets are those of a sphere.
    let height = normal.dot(view);
    let stretched = ((view - normal * height) * width + normal * height).normalize_or_zero();
    let lowest = normal.dot(stretched);
    let cosine = (S::ONE - numbers[1]) * (S::ONE + lowest) - lowest;
    let sine = positive_part::<S>(S::ONE - cosine * cosine).sqrt();
    let around = numbers[0] * (S::PI + S::PI);
    let local = <Vec3<S>>::new(sine * around.cos(), sine * around.sin(), cosine);
    let sum = turn::<S>(normal, local) + stretched;
    let along = normal.dot(sum);
    let half_way = ((sum - normal * along) * width + normal * along).normalize_or_zero();
    let twice = view.dot(half_way) * S::TWO;
    half_way * twice - view
}

/// The probability density of a direction among those of [`facet_direction()`], by solid angle.
#[differentiable]
#[inline]
pub fn facet_density<S: Real>(width: S, surface: SurfacePoint<S>, direction: Vec3<S>) -> S {
    let SurfacePoint { normal, view, .. } = seen_from_above::<S>(surface);
    let half_way = (direction + view).normalize_or_zero();
    let height = positive_part::<S>(normal.dot(view));
    let seen = height + slope::<S>(width, height);
    let density = distribution::<S>(width, normal, half_way) / (seen + seen);
    select(normal.dot(half_way).cmpgt(S::ZERO), density, S::ZERO)
}

/// A direction that three numbers from 0 to 1 choose: which lobe, and which direction of it.
#[differentiable]
#[inline]
pub fn scattered_direction<S: Real>(
    sampling: Sampling<S>,
    surface: SurfacePoint<S>,
    lobe: S,
    numbers: [S; 2],
) -> Vec3<S> {
    let by_facets = facet_direction::<S>(sampling.width, surface, numbers);
    let diffuse = turn::<S>(surface.normal, cosine_direction::<S>(numbers));
    select(lobe.cmplt(sampling.share), by_facets, diffuse)
}

/// The probability density of a direction among those of [`scattered_direction()`], by solid angle.
#[differentiable]
#[inline]
pub fn scattered_density<S: Real>(
    sampling: Sampling<S>,
    surface: SurfacePoint<S>,
    direction: Vec3<S>,
) -> S {
    let by_facets = facet_density::<S>(sampling.width, surface, direction);
    let cosine = positive_part::<S>(surface.normal.dot(direction));
    let diffuse = cosine * S::from_f64(FRAC_1_PI);
    by_facets * sampling.share + diffuse * (S::ONE - sampling.share)
}
