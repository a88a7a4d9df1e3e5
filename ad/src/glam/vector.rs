//! The rules of the methods that glam's float vectors have beyond those of [`Vector`](crate::vector::Vector).

#![allow(clippy::useless_conversion, reason = "one row for aligned vectors and others")]

use glam::{BVec2, BVec3, BVec3A, BVec4, BVec4A, DVec2, DVec3, DVec4, Vec2, Vec3, Vec3A, Vec4};

use super::geometry::{rotation, vector as geometry};
use super::kin::Kin;
use crate::rules::linear::{Along, Chosen, Elements, Maps, Same, Scaled, Symmetric, Zero, inner};
use crate::rules::row::rules;
use crate::rules::scale_vector::{scale_elements, scale_vector};
use crate::rules::vector::normalize_pullback;
use crate::rules::{FloatRules, RealRules, chain};
use crate::vector::Vector;

rules! {
    /// The rules of methods that all of glam's float vectors have beyond [`Vector`](crate::vector::Vector).
    GlamRules: Kin for Vec2 Vec3 Vec3A Vec4 DVec2 DVec3 DVec4 {
        signum(v) => Zero();
        floor(v) => Zero();
        ceil(v) => Zero();
        round(v) => Zero();
        trunc(v) => Zero();
        /// The jumps carry no derivative.
        fract(v) => Same();
        fract_gl(v) => Same();
        /// Where the second is below the first it is 0, else 1.
        step(edge, v) => (Zero(), Zero());
        sin(v) => Elements(v.cos());
        cos(v) => Elements(-v.sin());
        sin_cos(v) -> (Self, Self) = value => {
            let (sin, cos) = value;
            Maps(
                move |t: Self| (t.zip_elements(cos, chain), -t.zip_elements(sin, chain)),
                move |(to_sin, to_cos): (Self, Self)| {
                    scale_elements(to_sin, cos) - scale_elements(to_cos, sin)
                },
            )
        };
        ln(v) => Elements(v.map_elements(|x| x.ln_vjp().1(1.0)));
        log2(v) => Elements(v.map_elements(|x| x.log2_vjp().1(1.0)));
        exp2(v) => Elements(v.map_elements(|x| x.exp2_vjp().1(1.0)));
        copysign(v, sign)
            => (Elements(v.zip_elements(sign, |x, sign| x.copysign_vjp(sign).1(1.0).0)), Zero());
        rem_euclid(v, by) => (Same(), Elements(v.zip_elements(by, |x, y| x.rem_euclid_vjp(y).1(1.0).1)));
        div_euclid(v, by) => (Zero(), Zero());
        dot_into_vec(a, b: Self) -> Self => {
            let along = |v: Self| Maps(move |t: Self| Self::splat(inner(t, v)), move |g: Self| {
                scale_vector(g.element_sum(), v)
            });
            (along(b), along(a))
        };
        midpoint(a, b) => (Scaled(0.5), Scaled(0.5));
        lerp_monotonic(a, b: Self, s: Self::S) -> Self => (Scaled(1.0 - s), Scaled(s), Along(b - a));
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
        rotate_towards(v, end: Self, most: Self::S) -> Self as geometry::rotate_towards;
    }
}

rules! {
    /// The rules of methods of vectors of space.
    SpaceRules: Kin for Vec3 Vec3A DVec3 {
        extend(v, w: Self::S) -> Self::V4: |g| (g.truncate().into(), g.w);
        truncate(v) -> Self::V2: |g| g.extend(-0.0).into();
        from_homogeneous(v: Self::V4) -> Self as geometry::from_homogeneous;
        to_homogeneous(v) -> Self::V4
            => Maps(|t: Self| t.extend(-0.0), |g: Self::V4| g.truncate().into());
        any_orthogonal_vector(v) -> Self as geometry::any_orthogonal;
        any_orthonormal_vector(v) -> Self as geometry::any_orthonormal;
        any_orthonormal_pair(v) -> (Self, Self) as geometry::any_orthonormal_pair;
        angle_between(v, other: Self) -> Self::S as geometry::angle_between;
        rotate_x(v, angle: Self::S) -> Self as geometry::rotate_x;
        rotate_y(v, angle: Self::S) -> Self as geometry::rotate_y;
        rotate_z(v, angle: Self::S) -> Self as geometry::rotate_z;
        rotate_axis(v, axis: Self, angle: Self::S) -> Self as rotation::rotate_axis;
        angle_to(v, other: Self, axis: Self) -> Self::S as geometry::angle_about;
        rotate_towards(v, end: Self, most: Self::S) -> Self as rotation::vector_towards;
        slerp(v, end: Self, s: Self::S) -> Self as rotation::slerp_vectors;
    }
}

rules! {
    /// The rules of functions and methods of vectors of four elements.
    Vec4Rules: Kin for Vec4 DVec4 {
        new(x: Self::S, y: Self::S, z: Self::S, w: Self::S) -> Self: |g| (g.x, g.y, g.z, g.w);
        truncate(v) -> Self::V3: |g| g.extend(-0.0);
        project(v) -> Self::V3 as geometry::from_homogeneous;
    }
}

/// The rules of what takes each element from one of two vectors, by the type of the mask.
macro_rules! selections {
    ($($rules:ident $mask:ident $($type:ident)*;)*) => {$(
        rules! {
            /// The rule of `select`.
            $rules: Kin for $($type)* {
                select(mask: $mask, a: Self, b: Self) -> Self => {
                    let first = Self::select(mask, Self::ONE, Self::ZERO);
                    (Zero(), Chosen(first), Chosen(Self::ONE - first))
                };
            }
        }
    )*};
}

selections! {
    Select2Rules BVec2 Vec2 DVec2;
    Select3Rules BVec3 Vec3 DVec3;
    Select4Rules BVec4 DVec4;
    SelectAlignedRules BVec3A Vec3A;
    SelectWideRules BVec4A Vec4;
}
