//! Methods of glam's quaternions.

#![allow(clippy::too_many_arguments)]

use glam::{DQuat, DVec3, DVec4, Quat, Vec3, Vec4};

use super::{VectorForward, rotated};
use crate::rules::rotation::{self, lerp, slerp};
use crate::rules::{MulPullback, QuaternionRules};

/// The `_jvp` siblings of functions and methods of quaternions, whose four numbers count as free.
pub trait QuaternionForward: QuaternionRules {
    /// The quaternion of the tangents.
    fn from_xyzw_jvp(
        x: Self::Scalar,
        y: Self::Scalar,
        z: Self::Scalar,
        w: Self::Scalar,
        x_dot: Self::Scalar,
        y_dot: Self::Scalar,
        z_dot: Self::Scalar,
        w_dot: Self::Scalar,
    ) -> (Self, Self);
    /// About an axis, all of whose elements count as free.
    fn from_axis_angle_jvp(
        axis: Self::Vector,
        angle: Self::Scalar,
        axis_tangent: Self::Vector,
        tangent: Self::Scalar,
    ) -> (Self, Self);
    /// About the first axis.
    fn from_rotation_x_jvp(angle: Self::Scalar, tangent: Self::Scalar) -> (Self, Self);
    /// About the second axis.
    fn from_rotation_y_jvp(angle: Self::Scalar, tangent: Self::Scalar) -> (Self, Self);
    /// About the third axis.
    fn from_rotation_z_jvp(angle: Self::Scalar, tangent: Self::Scalar) -> (Self, Self);
    /// The conjugate of the tangent.
    fn conjugate_jvp(self, tangent: Self) -> (Self, Self);
    /// The conjugate of the tangent.
    fn inverse_jvp(self, tangent: Self) -> (Self, Self);
    /// What of the tangent is across; 0 at 0.
    fn normalize_jvp(self, tangent: Self) -> (Self, Self);
    /// What of the tangent is along; 0 at 0.
    fn length_jvp(self, tangent: Self) -> (Self::Scalar, Self::Scalar);
    /// Twice the inner product.
    fn length_squared_jvp(self, tangent: Self) -> (Self::Scalar, Self::Scalar);
    /// Both inner products.
    fn dot_jvp(
        self,
        other: Self,
        tangent: Self,
        other_tangent: Self,
    ) -> (Self::Scalar, Self::Scalar);
    /// The vector of the tangent.
    fn xyz_jvp(self, tangent: Self) -> (Self::Vector, Self::Vector);
    /// By the rotation and by the vector.
    fn mul_vec3_jvp(
        self,
        vector: Self::Vector,
        tangent: Self,
        vector_tangent: Self::Vector,
    ) -> (Self::Vector, Self::Vector);
    /// Both products.
    fn mul_quat_jvp(self, other: Self, tangent: Self, other_tangent: Self) -> (Self, Self);
    /// By both ends and the parameter.
    fn lerp_jvp(
        self,
        end: Self,
        s: Self::Scalar,
        tangent: Self,
        end_tangent: Self,
        s_tangent: Self::Scalar,
    ) -> (Self, Self);
    /// By both ends and the parameter.
    fn slerp_jvp(
        self,
        end: Self,
        s: Self::Scalar,
        tangent: Self,
        end_tangent: Self,
        s_tangent: Self::Scalar,
    ) -> (Self, Self);
}

macro_rules! quaternions {
    ($($quat:ident $scalar:ident $vector:ident $vector4:ident;)*) => {$(
        impl QuaternionForward for $quat {
            #[inline(always)]
            fn from_xyzw_jvp(
                x: $scalar,
                y: $scalar,
                z: $scalar,
                w: $scalar,
                x_dot: $scalar,
                y_dot: $scalar,
                z_dot: $scalar,
                w_dot: $scalar,
            ) -> (Self, Self) {
                (Self::from_xyzw(x, y, z, w), Self::from_xyzw(x_dot, y_dot, z_dot, w_dot))
            }

            #[inline(always)]
            fn from_axis_angle_jvp(
                axis: $vector,
                angle: $scalar,
                axis_tangent: $vector,
                tangent: $scalar,
            ) -> (Self, Self) {
                let (axis_dot, numbers) = (axis_tangent.to_array(), axis.to_array());
                let (_, along) = rotation::from_axis_angle::jvp(numbers, angle, axis_dot, tangent);
                (Self::from_axis_angle(axis, angle), Self::from_array(along))
            }

            #[inline(always)]
            fn from_rotation_x_jvp(angle: $scalar, tangent: $scalar) -> (Self, Self) {
                let (sin, cos) = rotated(0.5 * angle, 0.5 * tangent);
                (Self::from_rotation_x(angle), Self::from_xyzw(cos, 0.0, 0.0, -sin))
            }

            #[inline(always)]
            fn from_rotation_y_jvp(angle: $scalar, tangent: $scalar) -> (Self, Self) {
                let (sin, cos) = rotated(0.5 * angle, 0.5 * tangent);
                (Self::from_rotation_y(angle), Self::from_xyzw(0.0, cos, 0.0, -sin))
            }

            #[inline(always)]
            fn from_rotation_z_jvp(angle: $scalar, tangent: $scalar) -> (Self, Self) {
                let (sin, cos) = rotated(0.5 * angle, 0.5 * tangent);
                (Self::from_rotation_z(angle), Self::from_xyzw(0.0, 0.0, cos, -sin))
            }

            #[inline(always)]
            fn conjugate_jvp(self, tangent: Self) -> (Self, Self) {
                (self.conjugate(), tangent.conjugate())
            }

            #[inline(always)]
            fn inverse_jvp(self, tangent: Self) -> (Self, Self) {
                (self.inverse(), tangent.conjugate())
            }

            #[inline(always)]
            fn normalize_jvp(self, tangent: Self) -> (Self, Self) {
                let (_, along) = $vector4::from(self).normalize_jvp(tangent.into());
                (self.normalize(), Self::from_vec4(along))
            }

            #[inline(always)]
            fn length_jvp(self, tangent: Self) -> ($scalar, $scalar) {
                (self.length(), $vector4::from(self).length_jvp(tangent.into()).1)
            }

            #[inline(always)]
            fn length_squared_jvp(self, tangent: Self) -> ($scalar, $scalar) {
                (self.length_squared(), $vector4::from(self).length_squared_jvp(tangent.into()).1)
            }

            #[inline(always)]
            fn dot_jvp(
                self,
                other: Self,
                tangent: Self,
                other_tangent: Self,
            ) -> ($scalar, $scalar) {
                let (left, right) = ($vector4::from(self), $vector4::from(other));
                let (_, along) = left.dot_jvp(right, tangent.into(), other_tangent.into());
                (self.dot(other), along)
            }

            #[inline(always)]
            fn xyz_jvp(self, tangent: Self) -> ($vector, $vector) {
                (self.xyz(), tangent.xyz())
            }

            #[inline(always)]
            fn mul_vec3_jvp(
                self,
                vector: $vector,
                tangent: Self,
                vector_tangent: $vector,
            ) -> ($vector, $vector) {
                (self.mul_vec3(vector), self.mul_jvp(vector, tangent, vector_tangent).1)
            }

            #[inline(always)]
            fn mul_quat_jvp(self, other: Self, tangent: Self, other_tangent: Self) -> (Self, Self) {
                (self.mul_quat(other), self.mul_jvp(other, tangent, other_tangent).1)
            }

            #[inline(always)]
            fn lerp_jvp(
                self,
                end: Self,
                s: $scalar,
                tangent: Self,
                end_tangent: Self,
                s_tangent: $scalar,
            ) -> (Self, Self) {
                let [a, b, a_dot, b_dot] = [self, end, tangent, end_tangent].map(|q| q.to_array());
                let (_, along) = lerp::jvp(a, b, s, a_dot, b_dot, s_tangent);
                (self.lerp(end, s), Self::from_array(along))
            }

            #[inline(always)]
            fn slerp_jvp(
                self,
                end: Self,
                s: $scalar,
                tangent: Self,
                end_tangent: Self,
                s_tangent: $scalar,
            ) -> (Self, Self) {
                let [a, b, a_dot, b_dot] = [self, end, tangent, end_tangent].map(|q| q.to_array());
                // The threshold of glam.
                let (_, along) = if self.dot(end).abs() > 1.0 - $scalar::EPSILON {
                    lerp::jvp(a, b, s, a_dot, b_dot, s_tangent)
                } else {
                    slerp::jvp(a, b, s, a_dot, b_dot, s_tangent)
                };
                (self.slerp(end, s), Self::from_array(along))
            }
        }
    )*};
}

quaternions! {
    Quat f32 Vec3 Vec4;
    DQuat f64 DVec3 DVec4;
}
