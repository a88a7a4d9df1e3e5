//! The rules of quaternions, and of matrices that stand for motions. The four numbers of a quaternion
//! count as free: that a rotation has length 1 is no part of the derivative.

use glam::{
    Affine2, Affine3, DAffine2, DAffine3, DMat2, DMat3, DMat4, DQuat, EulerRot, Mat2, Mat3, Mat4,
    Quat,
};

use super::geometry::{motion, rotation, vector};
use super::kin::Kin;
use crate::Real;
use crate::rules::linear::{Maps, Symmetric, Zero};
use crate::rules::row::rules;

rules! {
    /// The rules of functions and methods of quaternions.
    QuaternionRules: Kin for Quat DQuat {
        from_xyzw(x: Self::S, y: Self::S, z: Self::S, w: Self::S) -> Self: |g| (g.x, g.y, g.z, g.w);
        from_axis_angle(axis: Self::V3, angle: Self::S) -> Self as rotation::from_axis_angle;
        from_rotation_x(angle: Self::S) -> Self as rotation::about_x;
        from_rotation_y(angle: Self::S) -> Self as rotation::about_y;
        from_rotation_z(angle: Self::S) -> Self as rotation::about_z;
        from_scaled_axis(axis: Self::V3) -> Self as rotation::from_scaled_axis;
        /// Each number is a wave of half of each angle: half of what it is half a turn later is its
        /// derivative.
        from_euler(order: EulerRot, a: Self::S, b: Self::S, c: Self::S) -> Self => {
            let half_turn = <Self::S as Real>::PI;
            let along = |later: Self| {
                let slope = later * 0.5;
                Maps(move |t| slope * t, move |g: Self| g.dot(slope))
            };
            (
                Zero(),
                along(Self::from_euler(order, a + half_turn, b, c)),
                along(Self::from_euler(order, a, b + half_turn, c)),
                along(Self::from_euler(order, a, b, c + half_turn)),
            )
        };
        from_rotation_axes(x: Self::V3, y: Self::V3, z: Self::V3) -> Self as rotation::of_axes;
        from_mat3(&m: Self::M3) -> Self as rotation::of_matrix;
        from_mat4(&m: Self::M4) -> Self as rotation::of_matrix;
        from_vec4(v: Self::V4) -> Self: |g| g.into();
        from_rotation_arc(from: Self::V3, to: Self::V3) -> Self as rotation::from_rotation_arc;
        from_rotation_arc_colinear(from: Self::V3, to: Self::V3) -> Self
            as rotation::from_rotation_arc_colinear;
        from_rotation_arc_2d(from: Self::V2, to: Self::V2) -> Self as rotation::from_rotation_arc_2d;
        from_affine3(&m: Self::A3) -> Self as rotation::of_matrix;
        to_axis_angle(q) -> (Self::V3, Self::S) as rotation::to_axis_angle;
        to_scaled_axis(q) -> Self::V3 as rotation::to_scaled_axis;
        angle_between(q, other: Self) -> Self::S as rotation::angle_between;
        conjugate(q) => Symmetric(|t: Self| t.conjugate());
        /// That of the conjugate, which the inverse of a rotation is.
        inverse(q) => Symmetric(|t: Self| t.conjugate());
        normalize(q) -> Self as vector::unit;
        length(q) -> Self::S as vector::length;
        length_recip(q) -> Self::S as vector::length_recip;
        length_squared(q) -> Self::S as vector::length_squared;
        dot(q, other: Self) -> Self::S as vector::dot;
        xyz(q) -> Self::V3: |g| Self::from_vec4(g.extend(-0.0));
        mul_vec3(q, v: Self::V3) -> Self::V3 as rotation::rotated;
        mul_quat(q, other: Self) -> Self as rotation::product;
        /// Which of `end` and `-end` is nearer is not differentiated.
        lerp(q, end: Self, s: Self::S) -> Self as rotation::lerp;
        /// That of `lerp` where the ends are so near that glam takes it.
        slerp(q, end: Self, s: Self::S) -> Self as rotation::slerp;
        slerp_long(q, end: Self, s: Self::S) -> Self as rotation::slerp_long;
        rotate_towards(q, end: Self, most: Self::S) -> Self as rotation::towards;
    }
}

rules! {
    /// The rules of rotations of the plane.
    AngleRules: Kin for Mat2 Mat3 Affine2 DMat2 DMat3 DAffine2 {
        from_angle(angle: Self::S) -> Self as motion::from_angle;
    }
}

rules! {
    /// The rules of matrices of the plane.
    ScaleAngleRules: Kin for Mat2 DMat2 {
        from_scale_angle(scale: Self::V2, angle: Self::S) -> Self as motion::from_scale_angle;
        from_mat3(matrix: Self::M3) -> Self as motion::resized;
    }
}

rules! {
    /// The rules of motions of the plane.
    PlaneMotionRules: Kin for Mat3 Affine2 DMat3 DAffine2 {
        from_scale(scale: Self::V2) -> Self as motion::from_scale2;
        from_translation(translation: Self::V2) -> Self as motion::from_translation2;
        from_scale_angle_translation(scale: Self::V2, angle: Self::S, translation: Self::V2) -> Self
            as motion::plane;
        transform_point2(&m, point: Self::V2) -> Self::V2 as motion::transform_point2;
        transform_vector2(&m, vector: Self::V2) -> Self::V2 as motion::transform_vector2;
    }
}

rules! {
    /// The rules of affine motions of the plane.
    Affine2Rules: Kin for Affine2 DAffine2 {
        from_mat2(linear: Self::M2) -> Self as motion::resized;
        from_mat2_translation(linear: Self::M2, translation: Self::V2) -> Self as motion::moved2;
        from_angle_translation(angle: Self::S, translation: Self::V2) -> Self
            as motion::from_angle_translation;
        from_mat3(matrix: Self::M3) -> Self as motion::resized;
        to_scale_angle_translation(&m) -> (Self::V2, Self::S, Self::V2) as motion::plane_parts;
        inverse(&m) -> Self as motion::inverse2;
    }
}

rules! {
    /// The rules of rotations of space.
    RotationRules: Kin for Mat3 Mat4 Affine3 DMat3 DMat4 DAffine3 {
        from_rotation_x(angle: Self::S) -> Self as motion::about_x;
        from_rotation_y(angle: Self::S) -> Self as motion::about_y;
        from_rotation_z(angle: Self::S) -> Self as motion::about_z;
        from_axis_angle(axis: Self::V3, angle: Self::S) -> Self as motion::from_axis_angle;
        from_quat(turn: Self::Q) -> Self as motion::from_quat;
    }
}

rules! {
    /// The rules of motions of space.
    TransformRules: Kin for Mat4 Affine3 DMat4 DAffine3 {
        from_scale(scale: Self::V3) -> Self as motion::from_scale3;
        from_translation(translation: Self::V3) -> Self as motion::from_translation3;
        from_rotation_translation(turn: Self::Q, translation: Self::V3) -> Self
            as motion::from_rotation_translation;
        from_scale_rotation_translation(scale: Self::V3, turn: Self::Q, translation: Self::V3) -> Self
            as motion::from_scale_rotation_translation;
        to_scale_rotation_translation(&m) -> (Self::V3, Self::Q, Self::V3) as motion::parts;
        transform_point3(&m, point: Self::V3) -> Self::V3 as motion::transform_point3;
        transform_vector3(&m, vector: Self::V3) -> Self::V3 as motion::transform_vector3;
    }
}

/// The rules of what makes affine motions of their columns, and gives these.
macro_rules! affine_columns {
    ($($rules:ident $($affine:ident)*, $n:literal $m:literal $column:ident(
        $($axis:ident),*) |$g:ident| $columns:expr;)*) => {$(
        rules! {
            /// The rules of the columns of affine motions.
            $rules: Kin for $($affine)* {
                from_cols($($axis: Self::$column),*) -> Self: |$g| $columns;
                from_cols_array(&array: [Self::S; { $n * $m }]) -> Self: |g| g.to_cols_array();
                from_cols_array_2d(&columns: [[Self::S; $n]; $m]) -> Self: |g| g.to_cols_array_2d();
                to_cols_array(&m) -> [Self::S; { $n * $m }]: |g| Self::from_cols_array(&g);
                to_cols_array_2d(&m) -> [[Self::S; $n]; $m]: |g| Self::from_cols_array_2d(&g);
            }
        }
    )*};
}

affine_columns! {
    PlaneColumnRules Affine2 DAffine2, 2 3 V2(x_axis, y_axis, z_axis)
        |g| (g.matrix2.x_axis, g.matrix2.y_axis, g.translation);
    SpaceColumnRules Affine3 DAffine3, 3 4 V3(x_axis, y_axis, z_axis, w_axis)
        |g| (g.matrix3.x_axis, g.matrix3.y_axis, g.matrix3.z_axis, g.translation);
}

rules! {
    /// The rules of affine motions of space.
    Affine3Rules: Kin for Affine3 DAffine3 {
        from_mat3(linear: Self::M3) -> Self as motion::resized;
        from_mat4(matrix: Self::M4) -> Self as motion::resized;
        from_mat3_translation(linear: Self::M3, translation: Self::V3) -> Self as motion::moved3;
        inverse(&m) -> Self as motion::inverse3;
    }
}
