//! Where light goes on from a surface: a vertex of a scattered path.

use ad::vector::Vector3;
use ad::{Real, Vec3, differentiable, select};

use super::material::{Lobes, Material, brdf};
use super::surface::SurfacePoint;

/// A direction about the z axis that two numbers from 0 to 1 choose, with a probability density of the
/// cosine by π.
#[differentiable]
#[inline]
pub fn cosine_direction<S: Real>(numbers: [S; 2]) -> Vec3<S> {
    let (sine, around) = (numbers[0].sqrt(), numbers[1] * (S::PI + S::PI));
    let cosine = (S::ONE - numbers[0]).sqrt();
    <Vec3<S>>::new(sine * around.cos(), sine * around.sin(), cosine)
}

/// A direction about the z axis as one about another unit vector (Duff et al., "Building an Orthonormal
/// Basis, Revisited", 2017). The basis jumps where the vector crosses the plane z = 0.
#[differentiable]
#[inline]
pub fn turn<S: Real>(axis: Vec3<S>, local: Vec3<S>) -> Vec3<S> {
    let (x, y, z) = (axis.x(), axis.y(), axis.z());
    let sign = S::ONE.copysign(z);
    let a = -S::ONE / (sign + z);
    let b = x * y * a;
    let tangent = <Vec3<S>>::new(S::ONE + sign * x * x * a, sign * b, -sign * x);
    let bitangent = <Vec3<S>>::new(b, sign + y * y * a, -y);
    tangent * local.x() + bitangent * local.y() + axis * local.z()
}

/// The part of the radiance from one direction that a vertex sends on towards the viewer.
///
/// The direction goes `straight` through the surface, or is `mirrored`, or is one that the surface scatters
/// to with a density of the cosine by π, so that the cosine cancels. `factor` is one over the probability
/// that the path goes on in this way, times π where it scatters.
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
    let reflected = brdf::<S>(material, lobes, surface, direction) * material.opacity;
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
