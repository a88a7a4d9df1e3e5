//! Normal maps: textures that bend the normals that surfaces are shaded with.
//!
//! A texel holds a vector in the frame of the surface, its numbers from 0 to 1 standing for -1 to 1 (glTF 2.0,
//! 3.9.3): red goes along the tangent, in which `u` grows, green along the bitangent, to the side to which `v`
//! grows, upwards, and blue along the normal. `[0.5, 0.5, 1]` leaves the normal as it is.
//!
//! The frame is that of each triangle by itself: the tangent is the derivative of the position by `u`, without
//! its part along the shading normal, which may be interpolated. Frames that are interpolated between
//! vertices (MikkTSpace), for which maps of curved surfaces are often made, differ a little from it, and
//! those of files are not read. So maps may have seams at edges of triangles where the directions of their
//! texture coordinates jump.
//!
//! The front of a triangle is where its corners go round counterclockwise. Seen from behind, a bump is a dent.

use ad::vector::{Vector, Vector3};
use ad::{Differentiable, Real, Vec3, differentiable, select};

use super::positive_part;
use super::surface::SurfacePoint;
use super::texture::{Footprint, Uv, bilinear};
use super::triangle::{Triangle, edge_scale, exact_cross};

/// What a normal map says of a surface point.
#[derive(Clone, Copy, Debug, Differentiable)]
pub struct NormalMap<S: Real> {
    /// The texels around it.
    pub footprint: Footprint<S>,
    /// The texture coordinates.
    pub uv: Uv<S>,
    /// The factor of what is along tangent and bitangent; the sign is turned where the mesh is mirrored.
    pub scale: S,
}

/// The shading normal of a point of a triangle, bent by a normal map where the surface is `mapped`.
///
/// It stays as it is where the texture coordinates `corners` of the triangle span no area, and where the
/// map has no direction. One that looks away from a viewer who stands before the normal that is bent is
/// turned back towards him, until he grazes the surface; one whom that normal looks away from already is
/// turned away from no further.
// Others do not pay for code that stands in their loop.
#[differentiable(boxed)]
#[inline(never)]
pub fn mapped_normal<S: Real>(
    triangle: Triangle<S>,
    corners: [Uv<S>; 3],
    surface: SurfacePoint<S>,
    map: NormalMap<S>,
    mapped: S::Mask,
) -> Vec3<S> {
    let (normal, view) = (surface.normal, surface.view);
    let (to_b, to_c) = (triangle.b - triangle.a, triangle.c - triangle.a);
    let size = edge_scale::<S>(to_b, to_c);
    let (to_b, to_c) = (to_b * size, to_c * size);
    let (u_to_b, v_to_b) = (corners[1].u - corners[0].u, corners[1].v - corners[0].v);
    let (u_to_c, v_to_c) = (corners[2].u - corners[0].u, corners[2].v - corners[0].v);
    let area = S::difference_of_products(u_to_b, v_to_c, v_to_b, u_to_c);
    let turn = select(area.cmplt(S::ZERO), -S::ONE, S::ONE);
    let along_u = (to_b * v_to_c - to_c * v_to_b) * turn;
    let tangent = (along_u - normal * along_u.dot(normal)).normalize_or_zero();
    let bitangent = normal.cross(tangent) * turn;
    let is_behind = exact_cross::<S>(to_b, to_c).dot(view).cmplt(S::ZERO);
    let front = select(is_behind, -S::ONE, S::ONE);

    let texel = bilinear::<S>(map.footprint, map.uv);
    let (x, y) = (texel.x() + texel.x() - S::ONE, texel.y() + texel.y() - S::ONE);
    let up = texel.z() + texel.z() - S::ONE;
    let across = tangent * (x * front) + bitangent * y;
    let bent = normal * up + across * map.scale;
    let unit = bent.normalize_or_zero();

    let lowest = normal.dot(view).min(S::ZERO);
    let missing = positive_part::<S>(lowest - unit.dot(view));
    let seen = (unit + view * missing).normalize_or_zero();
    let has_frame = area.abs().cmpgt(S::ZERO) & tangent.length_squared().cmpgt(S::HALF);
    let has_direction =
        bent.length_squared().cmpgt(S::EPSILON) & seen.length_squared().cmpgt(S::HALF);
    select(mapped & has_frame & has_direction, seen, normal)
}

/// A normal near that which a map has bent, without a derivative: what the map adds to the normal as it is
/// is rounded. Paths are scattered about it, so that they stay where they are when the map changes a little.
///
/// It is less than 1.6 degrees off, and, where facets reflect to a lobe of this `width`, by less than an
/// eighth of that.
pub fn rounded_normal<S: Real>(normal: Vec3<S>, bent: Vec3<S>, width: S) -> Vec3<S> {
    let steps = (S::from_f64(WIDTH_STEPS) / width).max(S::from_f64(LEAST_STEPS));
    let round = |x: S| (x * steps + S::HALF).floor() / steps;
    let added = bent - normal;
    let rounded = <Vec3<S>>::new(round(added.x()), round(added.y()), round(added.z()));
    (normal + rounded).normalize_or_zero()
}

/// How many steps of rounding a unit has at least.
const LEAST_STEPS: f64 = 32.0;
/// How many steps of rounding the width of a lobe has at least.
const WIDTH_STEPS: f64 = 8.0;
