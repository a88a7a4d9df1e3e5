//! The smooth triangle: its shading normal is interpolated between normals of its corners.
//!
//! The shading normal decides how light is reflected, and which lights a point faces; the normal of the
//! flat triangle decides what is geometry: the side that the viewer sees, and where rays that leave
//! start. The shading normal depends on the corners of an edge alone where two triangles share it, so
//! that shading has no seam there unless the normals are [turned round](side_of()) on one of them alone.
//!
//! Where a light stands behind the flat triangle but before the shading normal (the terminator), shadow
//! rays from the flat triangle would be blocked by the mesh itself, triangle by triangle. They start at
//! [`curved_point()`] instead.

use ad::vector::{Vector, Vector3};
use ad::{Differentiable, Real, Vec3, differentiable, select};

use super::camera::Ray;
use super::surface::SurfacePoint;
use super::transform::{Transform, rotate};
use super::triangle::{Triangle, barycentric, exact_cross, triangle_point};
use super::vertex::next_ray;

/// How far a mirrored direction is lifted that would enter the surface: the sine of its angle from the
/// surface, at most.
const LIFT: f64 = 1e-3;

/// A point of a smooth triangle.
#[derive(Clone, Copy, Debug, Differentiable)]
pub struct SmoothPoint<S: Real> {
    /// The point, with the shading normal.
    pub surface: SurfacePoint<S>,
    /// The unit normal of the flat triangle, on the side of the viewer.
    pub outward: Vec3<S>,
}

/// The point where a ray meets the plane of a triangle whose corners have the unit normals `normals`, or
/// zeros in their place.
///
/// The normals of the corners are on the side of `outward` by their sum, so that it does not matter on which side
/// of the triangle they are given. The shading normal may look away from a viewer who sees the triangle at a grazing
/// angle, and where the surface is folded more sharply than it is tessellated it may be behind `outward`. Where the
/// interpolated normals cancel it is `outward`, and jumps.
#[differentiable]
#[inline]
pub fn smooth_point<S: Real>(
    triangle: Triangle<S>,
    normals: [Vec3<S>; 3],
    ray: Ray<S>,
) -> SmoothPoint<S> {
    let flat = triangle_point::<S>(triangle, ray);
    let [at_a, at_b, at_c] = barycentric::<S>(triangle, flat.point);
    let interpolated = normals[0] * at_a + normals[1] * at_b + normals[2] * at_c;
    let unit = interpolated.normalize_or_zero();
    let behind = side_of::<S>(normals, flat.normal).cmplt(S::ZERO);
    let vanishes = interpolated.length_squared().cmplt(S::EPSILON);
    let normal = select(vanishes, flat.normal, select(behind, -unit, unit));
    SmoothPoint {
        surface: SurfacePoint { point: flat.point, normal, view: flat.view },
        outward: flat.normal,
    }
}

/// The ray that goes on from a smooth triangle. A mirrored direction that would enter the flat triangle,
/// as happens at grazing angles, is lifted along `outward` until it does not.
#[differentiable]
#[inline]
pub fn next_ray_outward<S: Real>(point: SmoothPoint<S>, transparent: S::Mask) -> Ray<S> {
    let Ray { origin, direction } = next_ray::<S>(point.surface, transparent);
    let height = direction.dot(point.outward);
    let lifted = direction - point.outward * (height * S::from_f64(1.0 + LIFT));
    let enters = height.cmplt(S::ZERO);
    let outside = select(enters, lifted.normalize(), direction);
    Ray { origin, direction: select(transparent, direction, outside) }
}

/// The place above a point of a smooth triangle from which shadow rays start: a point of a curved surface
/// through the corners (Hanika, "Hacking the Shadow Terminator", Ray Tracing Gems II, 2021). Edges of
/// shadows move with it. `outward` decides for each normal on which side it is, so that the place is never below the
/// triangle, and has no derivative.
#[differentiable]
#[inline]
pub fn curved_point<S: Real>(
    triangle: Triangle<S>,
    normals: [Vec3<S>; 3],
    point: Vec3<S>,
    outward: Vec3<S>,
) -> Vec3<S> {
    let [at_a, at_b, at_c] = barycentric::<S>(triangle, point);
    let above = |corner: Vec3<S>, normal: Vec3<S>| {
        let behind = normal.dot(outward).cmplt(S::ZERO);
        let normal: Vec3<S> = select(behind, -normal, normal);
        normal * -(point - corner).dot(normal).min(S::ZERO)
    };
    point
        + above(triangle.a, normals[0]) * at_a
        + above(triangle.b, normals[1]) * at_b
        + above(triangle.c, normals[2]) * at_c
}

/// On which side of a triangle the normals of its corners are given: negative if not on that of `outward`. One answer
/// for all of the triangle, so that shading is continuous on it, and from one to the next where it is the same.
#[differentiable]
#[inline]
pub fn side_of<S: Real>(normals: [Vec3<S>; 3], outward: Vec3<S>) -> S {
    (normals[0] + normals[1] + normals[2]).dot(outward)
}

/// What a triangle adds to the normals of its corners: its normal, as long as twice its area. So triangles
/// without area add nothing, and large ones count for more.
#[differentiable]
#[inline]
pub fn weighted_normal<S: Real>(triangle: Triangle<S>) -> Vec3<S> {
    exact_cross::<S>(triangle.b - triangle.a, triangle.c - triangle.a)
}

/// The unit vector along a sum of normals; zero if they cancel.
#[differentiable]
#[inline]
pub fn mean_normal<S: Real>(sum: Vec3<S>) -> Vec3<S> {
    sum.normalize_or_zero()
}

/// The unit normal in the world of a surface that was placed: by the cofactors of the transform, which
/// exist for every scale. On which side it is does not matter.
#[differentiable]
#[inline]
pub fn place_normal<S: Real>(transform: Transform<S>, normal: Vec3<S>) -> Vec3<S> {
    let scale = transform.scale;
    let (x, y, z) = (scale.x(), scale.y(), scale.z());
    let cofactors = <Vec3<S>>::new(y * z, z * x, x * y);
    rotate::<S>(transform.rotation, (normal * cofactors).normalize_or_zero())
}
