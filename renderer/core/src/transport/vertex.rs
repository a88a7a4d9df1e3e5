//! A path vertex: what leaves it towards the viewer, and the ray to the next one.
//!
//! A ray goes on in one direction at most: straight through a transparent surface, to the mirror
//! direction from every other. Turned down: both at once, which makes a tree of every path.

use ad::vector::Vector;
use ad::{Real, Vec3, differentiable, select};

use super::camera::Ray;
use super::surface::SurfacePoint;

/// The radiance that leaves a surface towards the viewer: its `own`, and the radiance that comes from
/// where the ray goes on, `beyond`. A transparent surface covers it by its `opacity` (the operator
/// "over" of Porter & Duff 1984), every other one adds what it mirrors of it, the part `mirror`.
#[differentiable]
#[inline]
pub fn outgoing<S: Real>(
    opacity: S,
    mirror: Vec3<S>,
    transparent: S::Mask,
    own: Vec3<S>,
    beyond: Vec3<S>,
) -> Vec3<S> {
    let over = own * opacity + beyond * (S::ONE - opacity);
    select(transparent, over, own + mirror * beyond)
}

/// The ray that goes on from a surface.
#[differentiable]
#[inline]
pub fn next_ray<S: Real>(surface: SurfacePoint<S>, transparent: S::Mask) -> Ray<S> {
    let cosine = surface.normal.dot(surface.view);
    let mirrored = surface.normal * (cosine + cosine) - surface.view;
    Ray { origin: surface.point, direction: select(transparent, -surface.view, mirrored) }
}
