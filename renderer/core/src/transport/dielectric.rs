//! The smooth dielectric: glass, water, diamond.
//!
//! Light is reflected by Fresnel's equations, unpolarised, and the rest of it is refracted by Snell's law.
//! A path goes on in one of both directions. The radiance that is seen through the surface is smaller than
//! behind it by the squared ratio of the indices of refraction, because light that comes out of the denser
//! side fills a wider cone (Veach, "Robust Monte Carlo Methods for Light Transport Simulation", 1997,
//! section 5.2); where light leaves what it has entered, both factors cancel.

use ad::vector::Vector;
use ad::{Real, Vec3, differentiable, select};

use super::material::Material;
use super::positive_part;
use super::surface::SurfacePoint;

/// The index of refraction behind a surface over that before it, by that of the material over that around
/// it; `inside` holds where the viewer is in the material.
#[differentiable]
#[inline]
pub fn relative_ior<S: Real>(ior: S, inside: S::Mask) -> S {
    select(inside, S::ONE / ior, ior)
}

/// The squared cosine of the refracted ray, below 0 where there is none: total reflection.
#[differentiable]
#[inline]
fn refracted_cosine_squared<S: Real>(relative_ior: S, cosine: S) -> S {
    S::ONE - (S::ONE - cosine * cosine) / (relative_ior * relative_ior)
}

/// The part of light that a dielectric reflects which arrives at an angle of this cosine (Fresnel,
/// unpolarised). Where the reflection becomes total it has a kink, at which its derivative counts as 0.
#[differentiable]
#[inline]
pub fn fresnel<S: Real>(relative_ior: S, cosine: S) -> S {
    let squared = refracted_cosine_squared::<S>(relative_ior, cosine);
    let refracted = positive_part::<S>(squared).sqrt();
    let (dense, sparse) = (relative_ior * cosine, relative_ior * refracted);
    let parallel = (dense - refracted) / (dense + refracted);
    let perpendicular = (cosine - sparse) / (cosine + sparse);
    let mean = (parallel * parallel + perpendicular * perpendicular) * S::HALF;
    select(squared.cmpgt(S::ZERO), mean, S::ONE)
}

/// The cosine between the viewer and the normal, not below 0.
#[differentiable]
#[inline]
fn cosine_of_view<S: Real>(surface: SurfacePoint<S>) -> S {
    positive_part::<S>(surface.normal.dot(surface.view)).min(S::ONE)
}

/// The part of light that a dielectric reflects towards the viewer.
#[differentiable]
#[inline]
pub fn reflectance<S: Real>(material: Material<S>, surface: SurfacePoint<S>, inside: S::Mask) -> S {
    let relative = relative_ior::<S>(material.ior, inside);
    fresnel::<S>(relative, cosine_of_view::<S>(surface))
}

/// The direction from which refracted light comes to the viewer, a unit vector; where the reflection is
/// total it does not count.
#[differentiable]
#[inline]
pub fn refracted_direction<S: Real>(
    material: Material<S>,
    surface: SurfacePoint<S>,
    inside: S::Mask,
) -> Vec3<S> {
    let relative = relative_ior::<S>(material.ior, inside);
    let cosine = cosine_of_view::<S>(surface);
    let refracted = positive_part::<S>(refracted_cosine_squared::<S>(relative, cosine)).sqrt();
    let along = (surface.normal * cosine - surface.view) / relative;
    (along - surface.normal * refracted).normalize_or_zero()
}

/// The part of the radiance from one direction that a dielectric sends on towards the viewer: what it
/// reflects where the direction is `mirrored`, else what it refracts, by the colour `diffuse` that it lets
/// through. `factor` is one over the probability that the path goes on in this way.
#[differentiable]
#[inline]
pub fn sent_on_by_dielectric<S: Real>(
    material: Material<S>,
    surface: SurfacePoint<S>,
    inside: S::Mask,
    mirrored: S::Mask,
    factor: S,
) -> Vec3<S> {
    let reflected = reflectance::<S>(material, surface, inside);
    let relative = relative_ior::<S>(material.ior, inside);
    let through = (S::ONE - reflected) / (relative * relative);
    let mirror = Vec3::<S>::splat(reflected);
    select(mirrored, mirror, material.diffuse * through) * factor
}
