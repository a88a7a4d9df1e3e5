//! Where light goes on from a surface: a vertex of a scattered path.

use ad::vector::{Vector, Vector3};
use ad::{Real, Vec3, differentiable, select};

use super::brdf::brdf;
use super::material::{Lobes, Material};
use super::positive_part;
use super::surface::SurfacePoint;

/// The part of the radiance from one direction that a vertex sends on towards the viewer.
///
/// The direction goes `straight` through the surface, or is `mirrored`, or is one that the surface scatters
/// to. `factor` is one over the probability that the path goes on in this way, by the density of directions
/// where it scatters.
#[differentiable]
#[inline]
pub fn sent_on<S: Real>(
    material: Material<S>,
    lobes: Lobes,
    surface: SurfacePoint<S>,
    direction: Vec3<S>,
    straight: S::Mask,
    mirrored: S::Mask,
    factor: S,
) -> Vec3<S> {
    let cosine = positive_part::<S>(surface.normal.dot(direction));
    let reflectance = brdf::<S>(material, lobes, surface, direction);
    let reflected = reflectance * (material.opacity * cosine);
    let behind = S::ONE - material.opacity;
    let through = <Vec3<S>>::new(behind, behind, behind);
    select(straight, through, select(mirrored, material.mirror, reflected)) * factor
}

/// The radiance that leaves a vertex towards the viewer, from its `own`, emitted and reflected directly, and
/// the `part` of the radiance `beyond` that it [sends on](sent_on()).
#[differentiable]
#[inline]
pub fn gathered<S: Real>(opacity: S, own: Vec3<S>, part: Vec3<S>, beyond: Vec3<S>) -> Vec3<S> {
    own * opacity + beyond * part
}
