//! Derivatives of matrices that stand for rotations and other motions.

#![allow(clippy::type_complexity)]

use core::array;

use glam::{
    DMat2, DMat3, DMat4, DQuat, DVec2, DVec3, DVec4, Mat2, Mat3, Mat4, Quat, Vec2, Vec3, Vec4,
};

use super::rotation::{axis_angle_matrix, rotation_matrix};
use super::{MulPullback, scale, scale_elements};
use crate::{Differentiable, Real};

/// The `_vjp` sibling of the rotations of a plane.
pub trait AngleRules: Sized {
    /// A number.
    type Scalar: Real;

    /// The cotangent of the angle.
    fn from_angle_vjp(angle: Self::Scalar) -> (Self, impl FnOnce(Self) -> Self::Scalar);
}

/// The `_vjp` siblings of what matrices of three or four columns are made from.
pub trait RotationRules: Differentiable<Tangent = Self> + Sized {
    /// A number.
    type Scalar: Real;
    /// A vector of three numbers.
    type Vector;
    /// A quaternion.
    type Quaternion;

    /// The cotangent of the angle.
    fn from_rotation_x_vjp(angle: Self::Scalar) -> (Self, impl FnOnce(Self) -> Self::Scalar);
    /// The cotangent of the angle.
    fn from_rotation_y_vjp(angle: Self::Scalar) -> (Self, impl FnOnce(Self) -> Self::Scalar);
    /// The cotangent of the angle.
    fn from_rotation_z_vjp(angle: Self::Scalar) -> (Self, impl FnOnce(Self) -> Self::Scalar);
    /// The cotangents of axis and angle.
    fn from_axis_angle_vjp(
        axis: Self::Vector,
        angle: Self::Scalar,
    ) -> (Self, impl FnOnce(Self) -> (Self::Vector, Self::Scalar));
    /// The cotangent of the quaternion.
    fn from_quat_vjp(rotation: Self::Quaternion) -> (Self, impl FnOnce(Self) -> Self::Quaternion);
}

/// The `_vjp` siblings of the methods of affine motions of space.
pub trait TransformRules: Differentiable<Tangent = Self> + Sized {
    /// A vector.
    type Vector;
    /// A quaternion.
    type Quaternion;

    /// The cotangents of matrix and point.
    fn transform_point3_vjp(
        &self,
        point: Self::Vector,
    ) -> (Self::Vector, impl FnOnce(Self::Vector) -> (Self, Self::Vector) + use<Self>);
    /// The cotangents of matrix and vector.
    fn transform_vector3_vjp(
        &self,
        vector: Self::Vector,
    ) -> (Self::Vector, impl FnOnce(Self::Vector) -> (Self, Self::Vector) + use<Self>);
    /// The last column.
    fn from_translation_vjp(translation: Self::Vector)
    -> (Self, impl FnOnce(Self) -> Self::Vector);
    /// The diagonal.
    fn from_scale_vjp(scale: Self::Vector) -> (Self, impl FnOnce(Self) -> Self::Vector);
    /// The cotangents of rotation and translation.
    fn from_rotation_translation_vjp(
        rotation: Self::Quaternion,
        translation: Self::Vector,
    ) -> (Self, impl FnOnce(Self) -> (Self::Quaternion, Self::Vector));
    /// The cotangents of scale, rotation and translation.
    fn from_scale_rotation_translation_vjp(
        scale: Self::Vector,
        rotation: Self::Quaternion,
        translation: Self::Vector,
    ) -> (Self, impl FnOnce(Self) -> (Self::Vector, Self::Quaternion, Self::Vector));
}

macro_rules! transforms {
    ($($matrix2:ident $matrix3:ident $matrix4:ident $quat:ident
        $scalar:ident $vector2:ident $vector3:ident $vector4:ident;)*) => {$(
        impl AngleRules for $matrix2 {
            type Scalar = $scalar;

            #[inline(always)]
            fn from_angle_vjp(angle: $scalar) -> (Self, impl FnOnce(Self) -> $scalar) {
                (Self::from_angle(angle), move |g: Self| {
                    let (sin, cos) = angle.sin_cos();
                    scale_elements(g.x_axis, $vector2::new(-sin, cos)).element_sum()
                        + scale_elements(g.y_axis, $vector2::new(-cos, -sin)).element_sum()
                })
            }
        }

        transforms!(@rotation $matrix3 $scalar $vector3 $quat |g| g);
        transforms!(@rotation $matrix4 $scalar $vector3 $quat |g| $matrix3::from_mat4(g));

        impl TransformRules for $matrix4 {
            type Vector = $vector3;
            type Quaternion = $quat;

            #[inline(always)]
            fn transform_point3_vjp(
                &self,
                point: $vector3,
            ) -> ($vector3, impl FnOnce($vector3) -> (Self, $vector3) + use<>) {
                let matrix = *self;
                (self.transform_point3(point), move |g: $vector3| {
                    // The last row is that of an affine motion and enters nothing.
                    let (to_matrix, to_point) = matrix.mul_pullback(point.extend(1.0), g.extend(-0.0));
                    (to_matrix, to_point.truncate())
                })
            }

            #[inline(always)]
            fn transform_vector3_vjp(
                &self,
                vector: $vector3,
            ) -> ($vector3, impl FnOnce($vector3) -> (Self, $vector3) + use<>) {
                let matrix = *self;
                (self.transform_vector3(vector), move |g: $vector3| {
                    let (to_matrix, to_vector) =
                        matrix.mul_pullback(vector.extend(0.0), g.extend(-0.0));
                    (to_matrix, to_vector.truncate())
                })
            }

            #[inline(always)]
            fn from_translation_vjp(translation: $vector3) -> (Self, impl FnOnce(Self) -> $vector3) {
                (Self::from_translation(translation), |g: Self| g.w_axis.truncate())
            }

            #[inline(always)]
            fn from_scale_vjp(scale: $vector3) -> (Self, impl FnOnce(Self) -> $vector3) {
                (Self::from_scale(scale), |g: Self| {
                    $vector3::new(g.x_axis.x, g.y_axis.y, g.z_axis.z)
                })
            }

            #[inline(always)]
            fn from_rotation_translation_vjp(
                rotation: $quat,
                translation: $vector3,
            ) -> (Self, impl FnOnce(Self) -> ($quat, $vector3)) {
                (Self::from_rotation_translation(rotation, translation), move |g: Self| {
                    let (_, pullback) = $matrix4::from_quat_vjp(rotation);
                    (pullback(g), g.w_axis.truncate())
                })
            }

            #[inline(always)]
            fn from_scale_rotation_translation_vjp(
                scale: $vector3,
                rotation: $quat,
                translation: $vector3,
            ) -> (Self, impl FnOnce(Self) -> ($vector3, $quat, $vector3)) {
                let value = Self::from_scale_rotation_translation(scale, rotation, translation);
                (value, move |g: Self| {
                    let (turned, pullback) = $matrix3::from_quat_vjp(rotation);
                    let axes = [turned.x_axis, turned.y_axis, turned.z_axis];
                    let cotangents = [g.x_axis, g.y_axis, g.z_axis].map($vector4::truncate);
                    // Each axis times its scale.
                    let pairs: [_; 3] =
                        array::from_fn(|i| axes[i].mul_pullback(scale[i], cotangents[i]));
                    let [x, y, z] = pairs.map(|(to_axis, _)| to_axis);
                    let to_scale = $vector3::from_array(pairs.map(|(_, to_scale)| to_scale));
                    (to_scale, pullback($matrix3::from_cols(x, y, z)), g.w_axis.truncate())
                })
            }
        }
    )*};
    (@rotation $matrix:ident $scalar:ident $vector:ident $quat:ident |$g:ident| $part:expr) => {
        impl RotationRules for $matrix {
            type Scalar = $scalar;
            type Vector = $vector;
            type Quaternion = $quat;

            #[inline(always)]
            fn from_rotation_x_vjp(angle: $scalar) -> (Self, impl FnOnce(Self) -> $scalar) {
                (Self::from_rotation_x(angle), move |$g: Self| {
                    let g = $part;
                    turned(angle, [g.y_axis.y, g.y_axis.z, g.z_axis.y, g.z_axis.z])
                })
            }

            #[inline(always)]
            fn from_rotation_y_vjp(angle: $scalar) -> (Self, impl FnOnce(Self) -> $scalar) {
                (Self::from_rotation_y(angle), move |$g: Self| {
                    let g = $part;
                    turned(angle, [g.z_axis.z, g.z_axis.x, g.x_axis.z, g.x_axis.x])
                })
            }

            #[inline(always)]
            fn from_rotation_z_vjp(angle: $scalar) -> (Self, impl FnOnce(Self) -> $scalar) {
                (Self::from_rotation_z(angle), move |$g: Self| {
                    let g = $part;
                    turned(angle, [g.x_axis.x, g.x_axis.y, g.y_axis.x, g.y_axis.y])
                })
            }

            #[inline(always)]
            fn from_axis_angle_vjp(
                axis: $vector,
                angle: $scalar,
            ) -> (Self, impl FnOnce(Self) -> ($vector, $scalar)) {
                (Self::from_axis_angle(axis, angle), move |$g: Self| {
                    let (_, pullback) = axis_angle_matrix::vjp(axis.to_array(), angle);
                    let (axis, angle) = pullback($part.to_cols_array_2d());
                    ($vector::from_array(axis), angle)
                })
            }

            #[inline(always)]
            fn from_quat_vjp(rotation: $quat) -> (Self, impl FnOnce(Self) -> $quat) {
                (Self::from_quat(rotation), move |$g: Self| {
                    let (_, pullback) = rotation_matrix::vjp(rotation.to_array());
                    $quat::from_array(pullback($part.to_cols_array_2d()))
                })
            }
        }
    };
}

/// The cotangent of the angle of a rotation of a plane, whose two columns are (cos, sin) and
/// (-sin, cos), from those of its numbers.
#[inline(always)]
fn turned<S: Real>(angle: S, [xx, xy, yx, yy]: [S; 4]) -> S {
    let (sin, cos) = (angle.sin(), angle.cos());
    scale(xy, cos) - scale(xx, sin) - scale(yx, cos) - scale(yy, sin)
}

transforms! {
    Mat2 Mat3 Mat4 Quat f32 Vec2 Vec3 Vec4;
    DMat2 DMat3 DMat4 DQuat f64 DVec2 DVec3 DVec4;
}
