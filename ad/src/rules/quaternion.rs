//! Derivatives of glam's quaternions. The four numbers count as free: that a rotation has length 1
//! is no part of the derivative.

#![allow(clippy::type_complexity)]

use glam::{DQuat, DVec3, DVec4, Quat, Vec3, Vec4};

use super::rotation::{self, lerp, product, rotated, slerp};
use super::{MulPullback, VectorRules, bilinear, scale};
use crate::{Additive, Differentiable, Real};

/// The `_vjp` siblings of the methods of quaternions.
pub trait QuaternionRules: Differentiable<Tangent = Self> + Sized {
    /// A number.
    type Scalar: Real;
    /// A vector of three numbers.
    type Vector;

    /// The cotangents of the numbers.
    fn from_xyzw_vjp(
        x: Self::Scalar,
        y: Self::Scalar,
        z: Self::Scalar,
        w: Self::Scalar,
    ) -> (Self, impl FnOnce(Self) -> (Self::Scalar, Self::Scalar, Self::Scalar, Self::Scalar));
    /// The cotangents of axis and angle.
    fn from_axis_angle_vjp(
        axis: Self::Vector,
        angle: Self::Scalar,
    ) -> (Self, impl FnOnce(Self) -> (Self::Vector, Self::Scalar));
    /// The cotangent of the angle.
    fn from_rotation_x_vjp(angle: Self::Scalar) -> (Self, impl FnOnce(Self) -> Self::Scalar);
    /// The cotangent of the angle.
    fn from_rotation_y_vjp(angle: Self::Scalar) -> (Self, impl FnOnce(Self) -> Self::Scalar);
    /// The cotangent of the angle.
    fn from_rotation_z_vjp(angle: Self::Scalar) -> (Self, impl FnOnce(Self) -> Self::Scalar);
    /// The conjugate of the cotangent.
    fn conjugate_vjp(self) -> (Self, impl FnOnce(Self) -> Self);
    /// That of [`conjugate_vjp`](Self::conjugate_vjp), which the inverse of a rotation is.
    fn inverse_vjp(self) -> (Self, impl FnOnce(Self) -> Self);
    /// As that of a vector; 0 at 0.
    fn normalize_vjp(self) -> (Self, impl FnOnce(Self) -> Self);
    /// q/|q|; 0 at 0.
    fn length_vjp(self) -> (Self::Scalar, impl FnOnce(Self::Scalar) -> Self);
    /// 2 q
    fn length_squared_vjp(self) -> (Self::Scalar, impl FnOnce(Self::Scalar) -> Self);
    /// Each, times the cotangent, to the other.
    fn dot_vjp(self, other: Self) -> (Self::Scalar, impl FnOnce(Self::Scalar) -> (Self, Self));
    /// The vector part.
    fn xyz_vjp(self) -> (Self::Vector, impl FnOnce(Self::Vector) -> Self);
    /// The cotangents of the rotation and of the vector.
    fn mul_vec3_vjp(
        self,
        vector: Self::Vector,
    ) -> (Self::Vector, impl FnOnce(Self::Vector) -> (Self, Self::Vector));
    /// The cotangents of both rotations.
    fn mul_quat_vjp(self, other: Self) -> (Self, impl FnOnce(Self) -> (Self, Self));
    /// The cotangents of both ends and of the parameter. Which of `end` and `-end` is nearer is not
    /// differentiated.
    fn lerp_vjp(
        self,
        end: Self,
        s: Self::Scalar,
    ) -> (Self, impl FnOnce(Self) -> (Self, Self, Self::Scalar));
    /// The same along the arc; that of [`lerp_vjp`](Self::lerp_vjp) where the ends are so near that
    /// glam takes it.
    fn slerp_vjp(
        self,
        end: Self,
        s: Self::Scalar,
    ) -> (Self, impl FnOnce(Self) -> (Self, Self, Self::Scalar));
}

macro_rules! quaternions {
    ($($quat:ident $scalar:ident $vector:ident $vector4:ident;)*) => {$(
        impl Differentiable for $quat {
            type Tangent = Self;
            type Shape = ();

            #[inline(always)]
            fn shape(&self) {}

            #[inline(always)]
            fn irregularity(&self) -> f64 {
                if self.is_finite() { 0.0 } else { f64::NAN }
            }
        }

        impl Additive for $quat {
            #[inline(always)]
            fn zero() -> Self {
                Self::from_array([-0.0; 4])
            }

            #[inline(always)]
            fn accumulate(&mut self, other: Self) {
                *self += other;
            }
        }

        impl MulPullback for $quat {
            #[inline(always)]
            fn mul_pullback(self, rhs: Self, cotangent: Self) -> (Self, Self) {
                let (_, pullback) = product::vjp(self.to_array(), rhs.to_array());
                let (left, right) = pullback(cotangent.to_array());
                (Self::from_array(left), Self::from_array(right))
            }

            #[inline(always)]
            fn mul_jvp(
                self,
                rhs: Self,
                tangent: Self,
                rhs_tangent: Self,
            ) -> (Self, Self) {
                let along = bilinear(|a: Self, b: Self| a * b, (self, rhs), (tangent, rhs_tangent));
                (self * rhs, along)
            }
        }

        impl MulPullback<$vector> for $quat {
            #[inline(always)]
            fn mul_pullback(self, rhs: $vector, cotangent: $vector) -> (Self, $vector) {
                let (_, pullback) = rotated::vjp(self.to_array(), rhs.to_array());
                let (left, right) = pullback(cotangent.to_array());
                (Self::from_array(left), $vector::from_array(right))
            }

            #[inline(always)]
            fn mul_jvp(
                self,
                rhs: $vector,
                tangent: Self,
                rhs_tangent: $vector,
            ) -> ($vector, $vector) {
                let (_, along) = rotated::jvp(
                    self.to_array(),
                    rhs.to_array(),
                    tangent.to_array(),
                    rhs_tangent.to_array(),
                );
                (self * rhs, $vector::from_array(along))
            }
        }

        impl MulPullback<$scalar> for $quat {
            #[inline(always)]
            fn mul_pullback(self, rhs: $scalar, cotangent: Self) -> (Self, $scalar) {
                let (left, right) = $vector4::from(self).mul_pullback(rhs, cotangent.into());
                (Self::from_vec4(left), right)
            }

            #[inline(always)]
            fn mul_jvp(
                self,
                rhs: $scalar,
                tangent: Self,
                rhs_tangent: $scalar,
            ) -> (Self, Self) {
                let along = bilinear(|a: Self, b: $scalar| a * b, (self, rhs), (tangent, rhs_tangent));
                (self * rhs, along)
            }
        }

        impl QuaternionRules for $quat {
            type Scalar = $scalar;
            type Vector = $vector;

            #[inline(always)]
            fn from_xyzw_vjp(
                x: $scalar,
                y: $scalar,
                z: $scalar,
                w: $scalar,
            ) -> (Self, impl FnOnce(Self) -> ($scalar, $scalar, $scalar, $scalar)) {
                (Self::from_xyzw(x, y, z, w), |g: Self| (g.x, g.y, g.z, g.w))
            }

            #[inline(always)]
            fn from_axis_angle_vjp(
                axis: $vector,
                angle: $scalar,
            ) -> (Self, impl FnOnce(Self) -> ($vector, $scalar)) {
                (Self::from_axis_angle(axis, angle), move |g: Self| {
                    let (_, pullback) = rotation::from_axis_angle::vjp(axis.to_array(), angle);
                    let (axis, angle) = pullback(g.to_array());
                    ($vector::from_array(axis), angle)
                })
            }

            quaternions!(@about $scalar: from_rotation_x_vjp from_rotation_x x,
                from_rotation_y_vjp from_rotation_y y, from_rotation_z_vjp from_rotation_z z);

            #[inline(always)]
            fn conjugate_vjp(self) -> (Self, impl FnOnce(Self) -> Self) {
                (self.conjugate(), |g: Self| g.conjugate())
            }

            #[inline(always)]
            fn inverse_vjp(self) -> (Self, impl FnOnce(Self) -> Self) {
                (self.inverse(), |g: Self| g.conjugate())
            }

            #[inline(always)]
            fn normalize_vjp(self) -> (Self, impl FnOnce(Self) -> Self) {
                let (_, pullback) = $vector4::from(self).normalize_vjp();
                (self.normalize(), |g: Self| Self::from_vec4(pullback(g.into())))
            }

            #[inline(always)]
            fn length_vjp(self) -> ($scalar, impl FnOnce($scalar) -> Self) {
                let (_, pullback) = $vector4::from(self).length_vjp();
                (self.length(), |g| Self::from_vec4(pullback(g)))
            }

            #[inline(always)]
            fn length_squared_vjp(self) -> ($scalar, impl FnOnce($scalar) -> Self) {
                let (_, pullback) = $vector4::from(self).length_squared_vjp();
                (self.length_squared(), |g| Self::from_vec4(pullback(g)))
            }

            #[inline(always)]
            fn dot_vjp(self, other: Self) -> ($scalar, impl FnOnce($scalar) -> (Self, Self)) {
                let (_, pullback) = $vector4::from(self).dot_vjp(other.into());
                (self.dot(other), |g| {
                    let (left, right) = pullback(g);
                    (Self::from_vec4(left), Self::from_vec4(right))
                })
            }

            #[inline(always)]
            fn xyz_vjp(self) -> ($vector, impl FnOnce($vector) -> Self) {
                (self.xyz(), |g: $vector| Self::from_vec4(g.extend(-0.0)))
            }

            #[inline(always)]
            fn mul_vec3_vjp(
                self,
                vector: $vector,
            ) -> ($vector, impl FnOnce($vector) -> (Self, $vector)) {
                (self.mul_vec3(vector), move |g| self.mul_pullback(vector, g))
            }

            #[inline(always)]
            fn mul_quat_vjp(self, other: Self) -> (Self, impl FnOnce(Self) -> (Self, Self)) {
                (self.mul_quat(other), move |g| self.mul_pullback(other, g))
            }

            #[inline(always)]
            fn lerp_vjp(
                self,
                end: Self,
                s: $scalar,
            ) -> (Self, impl FnOnce(Self) -> (Self, Self, $scalar)) {
                (self.lerp(end, s), move |g: Self| {
                    let (_, pullback) = lerp::vjp(self.to_array(), end.to_array(), s);
                    let (start, end, s) = pullback(g.to_array());
                    (Self::from_array(start), Self::from_array(end), s)
                })
            }

            #[inline(always)]
            fn slerp_vjp(
                self,
                end: Self,
                s: $scalar,
            ) -> (Self, impl FnOnce(Self) -> (Self, Self, $scalar)) {
                (self.slerp(end, s), move |g: Self| {
                    let (start, other) = (self.to_array(), end.to_array());
                    // The threshold of glam.
                    let (start, end, s) = if self.dot(end).abs() > 1.0 - $scalar::EPSILON {
                        lerp::vjp(start, other, s).1(g.to_array())
                    } else {
                        slerp::vjp(start, other, s).1(g.to_array())
                    };
                    (Self::from_array(start), Self::from_array(end), s)
                })
            }
        }
    )*};
    (@about $scalar:ident: $($vjp:ident $method:ident $axis:ident),*) => {$(
        #[inline(always)]
        fn $vjp(angle: $scalar) -> (Self, impl FnOnce(Self) -> $scalar) {
            (Self::$method(angle), move |g: Self| {
                let (sin, cos) = (0.5 * angle).sin_cos();
                0.5 * (scale(g.$axis, cos) - scale(g.w, sin))
            })
        }
    )*};
}

quaternions! {
    Quat f32 Vec3 Vec4;
    DQuat f64 DVec3 DVec4;
}
