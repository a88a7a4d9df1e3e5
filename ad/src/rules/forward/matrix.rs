//! Methods of glam's matrices.

#![allow(clippy::too_many_arguments)]

use glam::{
    DMat2, DMat3, DMat4, DQuat, DVec2, DVec3, DVec4, Mat2, Mat3, Mat4, Quat, Vec2, Vec3, Vec4,
};

use super::rotated;
use crate::rules::rotation::{axis_angle_matrix, rotation_matrix};
use crate::rules::{MatrixRules, MulPullback};
use crate::{Additive, Tangent};

/// The `_jvp` siblings of the methods that all square matrices have.
pub trait MatrixForward: MatrixRules {
    /// The transpose of the tangent.
    fn transpose_jvp(&self, tangent: &Self) -> (Self, Self);
    /// The inner product of the tangent with the cofactors.
    fn determinant_jvp(&self, tangent: &Self) -> (Self::Scalar, Self::Scalar);
    /// -W T W for the inverse W; 0 where there is none.
    fn inverse_jvp(&self, tangent: &Self) -> (Self, Self);
    /// The matrix with the tangent as its diagonal.
    fn from_diagonal_jvp(diagonal: Self::Column, tangent: Self::Column) -> (Self, Self);
    /// The column of the tangent.
    fn col_jvp(&self, index: usize, tangent: &Self, _: ()) -> (Self::Column, Self::Column);
}

macro_rules! matrices {
    ($($matrix:ident $scalar:ident $column:ident $forward:ident $times:ident $times_jvp:ident
        ($($axis:ident $dot:ident),*);)*) => {$(
        impl MatrixForward for $matrix {
            #[inline(always)]
            fn transpose_jvp(&self, tangent: &Self) -> (Self, Self) {
                (self.transpose(), tangent.transpose())
            }

            #[inline(always)]
            fn determinant_jvp(&self, tangent: &Self) -> ($scalar, $scalar) {
                let (value, pullback) = self.determinant_vjp();
                let cofactors = pullback(1.0);
                let along = $(super::vector::inner(tangent.$axis, cofactors.$axis) +)* 0.0;
                (value, along)
            }

            #[inline(always)]
            fn inverse_jvp(&self, tangent: &Self) -> (Self, Self) {
                let inverse = self.inverse();
                match inverse.is_finite() && *tangent != Self::ZERO {
                    true => (inverse, -(inverse * *tangent * inverse)),
                    false => (inverse, Self::zero()),
                }
            }

            #[inline(always)]
            fn from_diagonal_jvp(diagonal: $column, tangent: $column) -> (Self, Self) {
                (Self::from_diagonal(diagonal), Self::from_diagonal(tangent))
            }

            #[inline(always)]
            fn col_jvp(&self, index: usize, tangent: &Self, (): ()) -> ($column, $column) {
                (self.col(index), tangent.col(index))
            }
        }

        #[doc = concat!("The `_jvp` siblings of methods of `", stringify!($matrix), "` alone.")]
        pub trait $forward: Sized {
            /// The matrix of the tangents.
            fn from_cols_jvp($($axis: $column,)* $($dot: $column),*) -> (Self, Self);
            /// Both products.
            fn $times_jvp(
                &self,
                vector: $column,
                tangent: &Self,
                vector_tangent: $column,
            ) -> ($column, $column);
        }

        impl $forward for $matrix {
            #[inline(always)]
            fn from_cols_jvp($($axis: $column,)* $($dot: $column),*) -> (Self, Self) {
                (Self::from_cols($($axis),*), Self::from_cols($($dot),*))
            }

            #[inline(always)]
            fn $times_jvp(
                &self,
                vector: $column,
                tangent: &Self,
                vector_tangent: $column,
            ) -> ($column, $column) {
                (self.$times(vector), self.mul_jvp(vector, *tangent, vector_tangent).1)
            }
        }
    )*};
}

matrices! {
    Mat2 f32 Vec2 Mat2Forward mul_vec2 mul_vec2_jvp (x_axis x_dot, y_axis y_dot);
    Mat3 f32 Vec3 Mat3Forward mul_vec3 mul_vec3_jvp (x_axis x_dot, y_axis y_dot, z_axis z_dot);
    Mat4 f32 Vec4 Mat4Forward mul_vec4 mul_vec4_jvp
        (x_axis x_dot, y_axis y_dot, z_axis z_dot, w_axis w_dot);
    DMat2 f64 DVec2 DMat2Forward mul_vec2 mul_vec2_jvp (x_axis x_dot, y_axis y_dot);
    DMat3 f64 DVec3 DMat3Forward mul_vec3 mul_vec3_jvp (x_axis x_dot, y_axis y_dot, z_axis z_dot);
    DMat4 f64 DVec4 DMat4Forward mul_vec4 mul_vec4_jvp
        (x_axis x_dot, y_axis y_dot, z_axis z_dot, w_axis w_dot);
}

/// The `_jvp` sibling of `Mat2::from_angle`.
pub trait AngleForward: Sized {
    /// An angle.
    type Angle;
    /// The turned matrix, times the tangent.
    fn from_angle_jvp(angle: Self::Angle, tangent: Self::Angle) -> (Self, Self);
}

/// The `_jvp` siblings of what makes a rotation.
pub trait RotationForward: Sized {
    /// An angle.
    type Angle;
    /// An axis.
    type Axis;
    /// A rotation.
    type Rotation;

    /// About the first axis.
    fn from_rotation_x_jvp(angle: Self::Angle, tangent: Self::Angle) -> (Self, Self);
    /// About the second axis.
    fn from_rotation_y_jvp(angle: Self::Angle, tangent: Self::Angle) -> (Self, Self);
    /// About the third axis.
    fn from_rotation_z_jvp(angle: Self::Angle, tangent: Self::Angle) -> (Self, Self);
    /// About an axis, all of whose elements count as free.
    fn from_axis_angle_jvp(
        axis: Self::Axis,
        angle: Self::Angle,
        axis_tangent: Self::Axis,
        tangent: Self::Angle,
    ) -> (Self, Self);
    /// That of a quaternion.
    fn from_quat_jvp(rotation: Self::Rotation, tangent: Self::Rotation) -> (Self, Self);
}

/// The `_jvp` siblings of methods of matrices of four columns that stand for motions.
pub trait TransformForward: Sized {
    /// A point or a direction.
    type Point;
    /// A rotation.
    type Turn;

    /// Of a point.
    fn transform_point3_jvp(
        &self,
        point: Self::Point,
        tangent: &Self,
        point_tangent: Self::Point,
    ) -> (Self::Point, Self::Point);
    /// Of a direction.
    fn transform_vector3_jvp(
        &self,
        vector: Self::Point,
        tangent: &Self,
        vector_tangent: Self::Point,
    ) -> (Self::Point, Self::Point);
    /// A translation.
    fn from_translation_jvp(translation: Self::Point, tangent: Self::Point) -> (Self, Self);
    /// A scaling.
    fn from_scale_jvp(scale: Self::Point, tangent: Self::Point) -> (Self, Self);
    /// A rotation, then a translation.
    fn from_rotation_translation_jvp(
        rotation: Self::Turn,
        translation: Self::Point,
        rotation_tangent: Self::Turn,
        translation_tangent: Self::Point,
    ) -> (Self, Self);
    /// A scaling, a rotation, a translation.
    fn from_scale_rotation_translation_jvp(
        scale: Self::Point,
        rotation: Self::Turn,
        translation: Self::Point,
        scale_tangent: Self::Point,
        rotation_tangent: Self::Turn,
        translation_tangent: Self::Point,
    ) -> (Self, Self);
}

macro_rules! transforms {
    ($($matrix2:ident $matrix3:ident $matrix4:ident $quat:ident $scalar:ident $vector:ident;)*) => {$(
        impl AngleForward for $matrix2 {
            type Angle = $scalar;

            #[inline(always)]
            fn from_angle_jvp(angle: $scalar, tangent: $scalar) -> (Self, Self) {
                let (sin, cos) = rotated(angle, tangent);
                (Self::from_angle(angle), Self::from_cols_array(&[-sin, cos, -cos, -sin]))
            }
        }

        transforms!(@rotation $matrix3 $quat $scalar $vector |columns| {
            $matrix3::from_cols_array_2d(&columns)
        });
        transforms!(@rotation $matrix4 $quat $scalar $vector |columns| {
            let [x, y, z] = columns.map(|column| $vector::from_array(column).extend(0.0));
            $matrix4::from_cols(x, y, z, Default::default())
        });

        impl TransformForward for $matrix4 {
            type Point = $vector;
            type Turn = $quat;

            #[inline(always)]
            fn transform_point3_jvp(
                &self,
                point: $vector,
                tangent: &Self,
                point_tangent: $vector,
            ) -> ($vector, $vector) {
                let (_, along) =
                    self.mul_jvp(point.extend(1.0), *tangent, point_tangent.extend(0.0));
                (self.transform_point3(point), along.truncate())
            }

            #[inline(always)]
            fn transform_vector3_jvp(
                &self,
                vector: $vector,
                tangent: &Self,
                vector_tangent: $vector,
            ) -> ($vector, $vector) {
                let (_, along) =
                    self.mul_jvp(vector.extend(0.0), *tangent, vector_tangent.extend(0.0));
                (self.transform_vector3(vector), along.truncate())
            }

            #[inline(always)]
            fn from_translation_jvp(translation: $vector, tangent: $vector) -> (Self, Self) {
                let along = Self { w_axis: tangent.extend(0.0), ..Self::ZERO };
                (Self::from_translation(translation), along)
            }

            #[inline(always)]
            fn from_scale_jvp(scale: $vector, tangent: $vector) -> (Self, Self) {
                (Self::from_scale(scale), Self::from_diagonal(tangent.extend(0.0)))
            }

            #[inline(always)]
            fn from_rotation_translation_jvp(
                rotation: $quat,
                translation: $vector,
                rotation_tangent: $quat,
                translation_tangent: $vector,
            ) -> (Self, Self) {
                let (_, mut along) = Self::from_quat_jvp(rotation, rotation_tangent);
                along.w_axis = translation_tangent.extend(0.0);
                (Self::from_rotation_translation(rotation, translation), along)
            }

            #[inline(always)]
            fn from_scale_rotation_translation_jvp(
                scale: $vector,
                rotation: $quat,
                translation: $vector,
                scale_tangent: $vector,
                rotation_tangent: $quat,
                translation_tangent: $vector,
            ) -> (Self, Self) {
                let value = Self::from_scale_rotation_translation(scale, rotation, translation);
                let (turned, along) = $matrix3::from_quat_jvp(rotation, rotation_tangent);
                let axis = |i: usize| {
                    let (_, axis) =
                        turned.col(i).mul_jvp(scale[i], along.col(i), scale_tangent[i]);
                    axis.extend(0.0)
                };
                let along =
                    Self::from_cols(axis(0), axis(1), axis(2), translation_tangent.extend(0.0));
                (value, along)
            }
        }
    )*};
    (@rotation $matrix:ident $quat:ident $scalar:ident $vector:ident |$columns:ident| $made:expr) => {
        impl RotationForward for $matrix {
            type Angle = $scalar;
            type Axis = $vector;
            type Rotation = $quat;

            #[inline(always)]
            fn from_rotation_x_jvp(angle: $scalar, tangent: $scalar) -> (Self, Self) {
                let (sin, cos) = rotated(angle, tangent);
                let $columns = [[0.0; 3], [0.0, -sin, cos], [0.0, -cos, -sin]];
                (Self::from_rotation_x(angle), $made)
            }

            #[inline(always)]
            fn from_rotation_y_jvp(angle: $scalar, tangent: $scalar) -> (Self, Self) {
                let (sin, cos) = rotated(angle, tangent);
                let $columns = [[-sin, 0.0, -cos], [0.0; 3], [cos, 0.0, -sin]];
                (Self::from_rotation_y(angle), $made)
            }

            #[inline(always)]
            fn from_rotation_z_jvp(angle: $scalar, tangent: $scalar) -> (Self, Self) {
                let (sin, cos) = rotated(angle, tangent);
                let $columns = [[-sin, cos, 0.0], [-cos, -sin, 0.0], [0.0; 3]];
                (Self::from_rotation_z(angle), $made)
            }

            #[inline(always)]
            fn from_axis_angle_jvp(
                axis: $vector,
                angle: $scalar,
                axis_tangent: $vector,
                tangent: $scalar,
            ) -> (Self, Self) {
                let (_, $columns) = axis_angle_matrix::jvp(
                    axis.to_array(),
                    angle,
                    axis_tangent.to_array(),
                    tangent,
                );
                (Self::from_axis_angle(axis, angle), $made)
            }

            #[inline(always)]
            fn from_quat_jvp(rotation: $quat, tangent: Tangent<$quat>) -> (Self, Self) {
                let (_, $columns) =
                    rotation_matrix::jvp(rotation.to_array(), tangent.to_array());
                (Self::from_quat(rotation), $made)
            }
        }
    };
}

transforms! {
    Mat2 Mat3 Mat4 Quat f32 Vec3;
    DMat2 DMat3 DMat4 DQuat f64 DVec3;
}
