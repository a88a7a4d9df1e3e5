//! Textures: the colour of an image at texture coordinates, and what it varies.

use ad::vector::Vector3;
use ad::{Differentiable, Fields, Real, Vec3, differentiable};

/// Texture coordinates: `u` goes from the left edge to the right one, `v` from the lower edge to the
/// upper one, both from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq, Differentiable, Fields)]
pub struct Uv<S: Real> {
    /// The coordinate to the right.
    pub u: S,
    /// The coordinate upwards.
    pub v: S,
}

/// The four texels around a point of a texture: the upper left, the upper right, the lower left and
/// the lower right one; with the size of the texture in texels.
#[derive(Clone, Copy, Debug, Differentiable)]
pub struct Footprint<S: Real> {
    /// Linear RGB.
    pub texels: [Vec3<S>; 4],
    /// Texels per row.
    pub width: S,
    /// Rows.
    pub height: S,
}

/// Columns and rows of texels, from the middle of the upper left one, up to a point of a texture of
/// `width` by `height` texels.
#[differentiable]
#[inline]
pub fn texel_position<S: Real>(uv: Uv<S>, width: S, height: S) -> (S, S) {
    (uv.u * width - S::HALF, (S::ONE - uv.v) * height - S::HALF)
}

/// The bilinear interpolation of four texels.
///
/// It is continuous; where texture coordinates cross from one set of four texels to the next, the
/// derivative by them is that of the set they come to.
#[differentiable]
#[inline]
pub fn bilinear<S: Real>(footprint: Footprint<S>, uv: Uv<S>) -> Vec3<S> {
    let (x, y) = texel_position::<S>(uv, footprint.width, footprint.height);
    let (right, down) = (x - x.floor(), y - y.floor());
    let [upper_left, upper_right, lower_left, lower_right] = footprint.texels;
    let upper = upper_left + (upper_right - upper_left) * right;
    let lower = lower_left + (lower_right - lower_left) * right;
    upper + (lower - upper) * down
}

/// A colour of a material, varied by a texture.
#[differentiable]
#[inline]
pub fn modulate<S: Real>(color: Vec3<S>, footprint: Footprint<S>, uv: Uv<S>) -> Vec3<S> {
    color * bilinear::<S>(footprint, uv)
}

/// A roughness and a metallic part, varied by the green and the blue channel of a texture.
#[differentiable]
#[inline]
pub fn modulate_facets<S: Real>(
    roughness: S,
    metallic: S,
    footprint: Footprint<S>,
    uv: Uv<S>,
) -> (S, S) {
    let factors = bilinear::<S>(footprint, uv);
    (roughness * factors.y(), metallic * factors.z())
}

/// An opacity, varied by a texture: by the mean of its channels.
#[differentiable]
#[inline]
pub fn modulate_opacity<S: Real>(opacity: S, footprint: Footprint<S>, uv: Uv<S>) -> S {
    let color = bilinear::<S>(footprint, uv);
    opacity * ((color.x() + color.y() + color.z()) / S::from_f64(3.0))
}
