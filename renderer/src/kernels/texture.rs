//! Textures: where a surface point lies on an image, and what colour the image has there.

use ad::vector::{Vector, Vector3};
use ad::{Differentiable, Real, Vec3, differentiable};

use super::camera::Ray;
use super::sphere::{Sphere, sphere_surface};
use super::triangle::{edge_scale, exact_cross, triangle_surface};

/// A place on a texture: `u` goes from the left edge to the right one, `v` from the lower edge to
/// the upper one, both from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq, Differentiable)]
pub struct Uv<S: Real> {
    /// To the right.
    pub u: S,
    /// Upwards.
    pub v: S,
}

/// The place that belongs to a point of the triangle `a`, `b`, `c` whose corners have the places
/// `uv`: linear in the point.
#[differentiable]
#[inline]
pub fn triangle_uv<S: Real>(
    point: Vec3<S>,
    a: Vec3<S>,
    b: Vec3<S>,
    c: Vec3<S>,
    uv: [Uv<S>; 3],
) -> Uv<S> {
    let scale = edge_scale::<S>(b - a, c - a);
    let (to_b, to_c, to_point) = ((b - a) * scale, (c - a) * scale, (point - a) * scale);
    let normal = exact_cross::<S>(to_b, to_c);
    let area_squared = normal.length_squared();
    let at_b = normal.dot(to_point.cross(to_c)) / area_squared;
    let at_c = normal.dot(to_b.cross(to_point)) / area_squared;
    let at_a = S::ONE - at_b - at_c;
    Uv {
        u: uv[0].u * at_a + uv[1].u * at_b + uv[2].u * at_c,
        v: uv[0].v * at_a + uv[1].v * at_b + uv[2].v * at_c,
    }
}

/// The place that belongs to a point of a sphere: longitude and latitude about the y axis, which
/// runs from the lower edge of the texture to the upper one; its middle lies towards +z. At the
/// poles the derivatives count as 0.
#[differentiable]
#[inline]
pub fn sphere_uv<S: Real>(point: Vec3<S>, sphere: Sphere<S>) -> Uv<S> {
    let outward = (point - sphere.center) / sphere.radius;
    let longitude = outward.x().atan2(outward.z());
    // Not the arc sine of y, which loses half of the digits near the poles.
    let from_axis = (outward.x() * outward.x() + outward.z() * outward.z()).sqrt();
    let latitude = outward.y().atan2(from_axis);
    Uv { u: S::HALF + longitude / (S::PI + S::PI), v: S::HALF + latitude / S::PI }
}

/// Columns and rows of texels, from the middle of the upper left one, up to a place on a texture of
/// `width` by `height` texels.
#[differentiable]
#[inline]
pub fn texel_position<S: Real>(uv: Uv<S>, width: S, height: S) -> (S, S) {
    (uv.u * width - S::HALF, (S::ONE - uv.v) * height - S::HALF)
}

/// The colour at a place, between the four texels around it: the upper left, the upper right, the
/// lower left and the lower right one.
///
/// Bilinear, so continuous; where a place crosses from one set of four texels to the next, the
/// derivative by the place is that of the set it comes to.
#[differentiable]
#[inline]
pub fn bilinear<S: Real>(texels: [Vec3<S>; 4], uv: Uv<S>, width: S, height: S) -> Vec3<S> {
    let (x, y) = texel_position::<S>(uv, width, height);
    let (right, down) = (x - x.floor(), y - y.floor());
    let upper = texels[0] + (texels[1] - texels[0]) * right;
    let lower = texels[2] + (texels[3] - texels[2]) * right;
    upper + (lower - upper) * down
}

/// An opacity where a texture that varies it has this colour: it counts by the mean of its channels.
#[differentiable]
#[inline]
pub fn varied_opacity<S: Real>(opacity: S, color: Vec3<S>) -> S {
    opacity * ((color.x() + color.y() + color.z()) / S::from_f64(3.0))
}

/// The place at which a ray goes through the triangle `a`, `b`, `c` whose corners have the places `uv`.
#[differentiable]
pub fn triangle_crossing<S: Real>(
    ray: Ray<S>,
    a: Vec3<S>,
    b: Vec3<S>,
    c: Vec3<S>,
    uv: [Uv<S>; 3],
) -> Uv<S> {
    let surface = triangle_surface::<S>(ray, a, b, c);
    triangle_uv::<S>(surface.point, a, b, c, uv)
}

/// The place at which a ray enters a sphere, or leaves it where `leaves` holds.
#[differentiable]
pub fn sphere_crossing<S: Real>(ray: Ray<S>, sphere: Sphere<S>, leaves: S::Mask) -> Uv<S> {
    let surface = sphere_surface::<S>(ray, sphere, leaves);
    sphere_uv::<S>(surface.point, sphere)
}
