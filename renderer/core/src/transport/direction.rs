//! Directions about an axis.

use ad::vector::Vector3;
use ad::{Real, Vec3, differentiable};

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
