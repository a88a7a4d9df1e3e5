//! The rules of quaternions, and of matrices that stand for motions. The four numbers of a quaternion
//! count as free: that a rotation has length 1 is no part of the derivative.

use glam::{Affine2, Affine3, DAffine2, DAffine3, DMat2, DMat3, DMat4, DQuat, Mat2, Mat3, Mat4, Quat};

use super::geometry::{motion, rotation, vector};
use super::kin::{Kin, Numbers};
use super::linear::{self, Linear, Symmetric};
use super::row::rules;
use crate::Tangent;

rules! {
    /// The rules of functions and methods of quaternions.
    QuaternionRules: Kin for Quat DQuat {
        from_xyzw from_xyzw_vjp from_xyzw_jvp
            (x: Self::S, y: Self::S, z: Self::S, w: Self::S) -> Self: |g| (g.x, g.y, g.z, g.w);
        from_axis_angle from_axis_angle_vjp from_axis_angle_jvp (axis: Self::V3, angle: Self::S)
            -> Self as rotation::from_axis_angle;
        from_rotation_x from_rotation_x_vjp from_rotation_x_jvp (angle: Self::S) -> Self
            as rotation::about_x;
        from_rotation_y from_rotation_y_vjp from_rotation_y_jvp (angle: Self::S) -> Self
            as rotation::about_y;
        from_rotation_z from_rotation_z_vjp from_rotation_z_jvp (angle: Self::S) -> Self
            as rotation::about_z;
        from_scaled_axis from_scaled_axis_vjp from_scaled_axis_jvp (axis: Self::V3) -> Self
            as rotation::from_scaled_axis;
        from_rotation_arc from_rotation_arc_vjp from_rotation_arc_jvp (from: Self::V3, to: Self::V3)
            -> Self as rotation::from_rotation_arc;
        to_axis_angle to_axis_angle_vjp to_axis_angle_jvp (q) -> (Self::V3, Self::S)
            as rotation::to_axis_angle;
        to_scaled_axis to_scaled_axis_vjp to_scaled_axis_jvp (q) -> Self::V3
            as rotation::to_scaled_axis;
        angle_between angle_between_vjp angle_between_jvp (q, other: Self) -> Self::S
            as rotation::angle_between;
        conjugate conjugate_vjp conjugate_jvp (q) => Symmetric(|t: Self| t.conjugate());
        /// That of the conjugate, which the inverse of a rotation is.
        inverse inverse_vjp inverse_jvp (q) => Symmetric(|t: Self| t.conjugate());
        normalize normalize_vjp normalize_jvp (q) -> Self as vector::unit;
        length length_vjp length_jvp (q) -> Self::S as vector::length;
        length_squared length_squared_vjp length_squared_jvp (q) -> Self::S as vector::length_squared;
        dot dot_vjp dot_jvp (q, other: Self) -> Self::S as vector::dot;
        xyz xyz_vjp xyz_jvp (q) -> Self::V3: |g| Self::from_vec4(g.extend(-0.0));
        mul_vec3 mul_vec3_vjp mul_vec3_jvp (q, v: Self::V3) -> Self::V3 as rotation::rotated;
        mul_quat mul_quat_vjp mul_quat_jvp (q, other: Self) -> Self as rotation::product;
        /// Which of `end` and `-end` is nearer is not differentiated.
        lerp lerp_vjp lerp_jvp (q, end: Self, s: Self::S) -> Self as rotation::lerp;
        /// That of `lerp` where the ends are so near that glam takes it.
        slerp slerp_vjp slerp_jvp (q, end: Self, s: Self::S) -> Self as rotation::slerp;
    }
}

rules! {
    /// The rules of rotations of the plane.
    AngleRules: Kin for Mat2 Mat3 Affine2 DMat2 DMat3 DAffine2 {
        from_angle from_angle_vjp from_angle_jvp (angle: Self::S) -> Self as motion::from_angle;
    }
}

rules! {
    /// The rules of motions of the plane.
    PlaneMotionRules: Kin for Mat3 Affine2 DMat3 DAffine2 {
        from_scale from_scale_vjp from_scale_jvp (scale: Self::V2) -> Self as motion::from_scale;
        from_translation from_translation_vjp from_translation_jvp (translation: Self::V2) -> Self
            as motion::from_translation;
        from_scale_angle_translation from_scale_angle_translation_vjp from_scale_angle_translation_jvp
            (scale: Self::V2, angle: Self::S, translation: Self::V2) -> Self as motion::plane;
        transform_point2 transform_point2_vjp transform_point2_jvp (&m, point: Self::V2) -> Self::V2
            as motion::transform_point2;
        transform_vector2 transform_vector2_vjp transform_vector2_jvp (&m, vector: Self::V2)
            -> Self::V2 as motion::transform_vector2;
    }
}

rules! {
    /// The rules of affine motions of the plane.
    Affine2Rules: Kin for Affine2 DAffine2 {
        from_mat2 from_mat2_vjp from_mat2_jvp (linear: Self::M2) -> Self as motion::resized;
        from_mat2_translation from_mat2_translation_vjp from_mat2_translation_jvp
            (linear: Self::M2, translation: Self::V2) -> Self as motion::moved;
        from_angle_translation from_angle_translation_vjp from_angle_translation_jvp
            (angle: Self::S, translation: Self::V2) -> Self as motion::from_angle_translation;
        inverse inverse_vjp inverse_jvp (&m) -> Self as motion::inverse2;
    }
}

rules! {
    /// The rules of rotations of space.
    RotationRules: Kin for Mat3 Mat4 Affine3 DMat3 DMat4 DAffine3 {
        from_rotation_x from_rotation_x_vjp from_rotation_x_jvp (angle: Self::S) -> Self
            as motion::about_x;
        from_rotation_y from_rotation_y_vjp from_rotation_y_jvp (angle: Self::S) -> Self
            as motion::about_y;
        from_rotation_z from_rotation_z_vjp from_rotation_z_jvp (angle: Self::S) -> Self
            as motion::about_z;
        from_axis_angle from_axis_angle_vjp from_axis_angle_jvp (axis: Self::V3, angle: Self::S)
            -> Self as motion::from_axis_angle;
        from_quat from_quat_vjp from_quat_jvp (turn: Self::Q) -> Self as motion::from_quat;
    }
}

rules! {
    /// The rules of motions of space.
    TransformRules: Kin for Mat4 Affine3 DMat4 DAffine3 {
        from_scale from_scale_vjp from_scale_jvp (scale: Self::V3) -> Self as motion::from_scale;
        from_translation from_translation_vjp from_translation_jvp (translation: Self::V3) -> Self
            as motion::from_translation;
        from_rotation_translation from_rotation_translation_vjp from_rotation_translation_jvp
            (turn: Self::Q, translation: Self::V3) -> Self as motion::from_rotation_translation;
        from_scale_rotation_translation
            from_scale_rotation_translation_vjp from_scale_rotation_translation_jvp
            (scale: Self::V3, turn: Self::Q, translation: Self::V3) -> Self
            as motion::from_scale_rotation_translation;
        transform_point3 transform_point3_vjp transform_point3_jvp (&m, point: Self::V3) -> Self::V3
            as motion::transform_point3;
        transform_vector3 transform_vector3_vjp transform_vector3_jvp (&m, vector: Self::V3)
            -> Self::V3 as motion::transform_vector3;
    }
}

rules! {
    /// The rules of affine motions of space.
    Affine3Rules: Kin for Affine3 DAffine3 {
        from_mat3 from_mat3_vjp from_mat3_jvp (linear: Self::M3) -> Self as motion::resized;
        from_mat4 from_mat4_vjp from_mat4_jvp (matrix: Self::M4) -> Self as motion::resized;
        from_mat3_translation from_mat3_translation_vjp from_mat3_translation_jvp
            (linear: Self::M3, translation: Self::V3) -> Self as motion::moved;
        inverse inverse_vjp inverse_jvp (&m) -> Self as motion::inverse3;
    }
}
