//! The rules of the methods that glam's float vectors have beyond those of [`Vector`](crate::vector::Vector).

use glam::{DVec2, DVec3, DVec4, Vec2, Vec3, Vec4};

use super::geometry::{rotation, vector as geometry};
use super::kin::Kin;
use crate::rules::linear::{Chosen, Elements, Maps, Same, Scaled, Symmetric, Zero};
use crate::rules::row::rules;
use crate::rules::vector::normalize_pullback;
use crate::vector::Vector;

rules! {
    /// The rules of methods that all of glam's float vectors have beyond [`Vector`](crate::vector::Vector).
    GlamRules: Kin for Vec2 Vec3 Vec4 DVec2 DVec3 DVec4 {
        signum(v) => Zero();
        floor(v) => Zero();
        ceil(v) => Zero();
        round(v) => Zero();
        trunc(v) => Zero();
        /// The jumps carry no derivative.
        fract(v) => Same();
        fract_gl(v) => Same();
        midpoint(a, b) => (Scaled(0.5), Scaled(0.5));
        mul_add(x, a, b) => (Elements(a), Elements(x), Same());
        element_product(v) -> Self::S as geometry::element_product;
        project_onto(v, onto: Self) -> Self as geometry::project_onto;
        project_onto_normalized(v, onto: Self) -> Self as geometry::project_onto_normalized;
        reject_from(v, onto: Self) -> Self as geometry::reject_from;
        reject_from_normalized(v, onto: Self) -> Self as geometry::reject_from_normalized;
        normalize_and_length(v) -> (Self, Self::S) as geometry::unit_and_length;
        try_normalize(v) -> Option<Self> = unit => Symmetric(|g| {
            unit.map_or(Self::ZERO, |unit| normalize_pullback(unit, v.length_recip(), g))
        });
        /// The bounds belong to the vector, as those of `clamp` do.
        saturate(v) = value => Chosen(v.zip_elements(value, |v, value| (v == value).into()));
        /// 6 t (1 - t) times the derivatives of the part t of the way between the edges; 0 at and beyond them.
        smoothstep(v, low, high) => {
            let t = ((v - low) / (high - low)).clamp(Self::ZERO, Self::ONE);
            let wave = 6.0 * t * (Self::ONE - t);
            let slope =
                wave.zip_elements(high - low, |wave, width| if wave > 0.0 { wave / width } else { 0.0 });
            (Elements(slope), Elements(slope * (t - Self::ONE)), Elements(-slope * t))
        };
        normalize_or(v, fallback: Self) -> Self as geometry::normalize_or;
        clamp_length(v, min: Self::S, max: Self::S) -> Self as geometry::clamp_length;
        clamp_length_max(v, max: Self::S) -> Self as geometry::clamp_length_max;
        clamp_length_min(v, min: Self::S) -> Self as geometry::clamp_length_min;
        move_towards(v, end: Self, way: Self::S) -> Self as geometry::move_towards;
        refract(v, normal: Self, eta: Self::S) -> Self as geometry::refract;
    }
}

rules! {
    /// The rules of functions and methods of vectors of the plane.
    Vec2Rules: Kin for Vec2 DVec2 {
        new(x: Self::S, y: Self::S) -> Self: |g| (g.x, g.y);
        extend(v, z: Self::S) -> Self::V3: |g| (g.truncate(), g.z);
        from_angle(angle: Self::S) -> Self as geometry::direction;
        to_angle(v) -> Self::S as geometry::to_angle;
        angle_to(v, other: Self) -> Self::S as geometry::angle_to;
        perp(v) -> Self as geometry::perp;
        perp_dot(v, other: Self) -> Self::S as geometry::perp_dot;
        rotate(v, other: Self) -> Self as geometry::rotate;
        rotate_angle(v, angle: Self::S) -> Self as geometry::rotate_angle;
    }
}

rules! {
    /// The rules of methods of vectors of space.
    SpaceRules: Kin for Vec3 DVec3 {
        extend(v, w: Self::S) -> Self::V4: |g| (g.truncate(), g.w);
        truncate(v) -> Self::V2: |g| g.extend(-0.0);
        from_homogeneous(v: Self::V4) -> Self as geometry::from_homogeneous;
        to_homogeneous(v) -> Self::V4 => Maps(|t: Self| t.extend(-0.0), |g: Self::V4| g.truncate());
        any_orthogonal_vector(v) -> Self as geometry::any_orthogonal;
        any_orthonormal_vector(v) -> Self as geometry::any_orthonormal;
        any_orthonormal_pair(v) -> (Self, Self) as geometry::any_orthonormal_pair;
        angle_between(v, other: Self) -> Self::S as geometry::angle_between;
        rotate_x(v, angle: Self::S) -> Self as geometry::rotate_x;
        rotate_y(v, angle: Self::S) -> Self as geometry::rotate_y;
        rotate_z(v, angle: Self::S) -> Self as geometry::rotate_z;
        rotate_axis(v, axis: Self, angle: Self::S) -> Self as rotation::rotate_axis;
    }
}

rules! {
    /// The rules of functions and methods of vectors of four elements.
    Vec4Rules: Kin for Vec4 DVec4 {
        new(x: Self::S, y: Self::S, z: Self::S, w: Self::S) -> Self: |g| (g.x, g.y, g.z, g.w);
        truncate(v) -> Self::V3: |g| g.extend(-0.0);
    }
}
