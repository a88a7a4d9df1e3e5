//! The forward mode of methods: siblings with the suffix `_jvp`.
//!
//! `x.sqrt_jvp(x_dot)` returns the value, bit for bit that of `x.sqrt()`, and its derivative along
//! `x_dot`; the tangents of receiver and arguments follow the arguments in their order.
//!
//! Few of these are rules of their own. Most functions of scalars, and of vectors element by
//! element, have symmetric Jacobians by each argument: there the derivative along a tangent is the
//! pullback of that tangent, at singular points, too. For a vector to a scalar it is the inner
//! product of the tangent with the pullback of 1. After inlining both are what one would have
//! written. What remains is written out: what is linear or bilinear in vectors.
//!
//! Turned down: a table of pushforwards beside that of pullbacks (two to keep in agreement, with
//! all their singular points); pulling unit vectors back for every function with a vector as result
//! (three pullbacks, and the zeros in them do not vanish from products with numbers that may be
//! infinite).

mod glam_only;
mod matrix;
mod outcome;
mod quaternion;
mod vector;

pub use glam_only::{ExtendForward, GlamForward, TruncateForward};
pub use matrix::{
    AngleForward, DMat2Forward, DMat3Forward, DMat4Forward, Mat2Forward, Mat3Forward, Mat4Forward,
    MatrixForward, RotationForward, TransformForward,
};
pub use outcome::{CopiedForward, FlattenForward, OptionForward, ResultForward};
pub use quaternion::QuaternionForward;
pub use vector::{
    DVec2Forward, DVec4Forward, Vec2Forward, Vec4Forward, Vector3Forward, VectorForward,
};

/// Siblings from pullbacks whose Jacobians are symmetric by each argument.
macro_rules! symmetric {
    ($($jvp:ident = $vjp:ident($($argument:ident $tangent:ident $index:tt),*);)*) => {$(
        symmetric!(@one $jvp $vjp $($argument $tangent $index),*);
    )*};
    (@one $jvp:ident $vjp:ident) => {
        #[doc = concat!("From `", stringify!($vjp), "`.")]
        #[inline(always)]
        fn $jvp(self, tangent: Self) -> (Self, Self) {
            let (value, pullback) = self.$vjp();
            (value, pullback(tangent))
        }
    };
    (@one $jvp:ident $vjp:ident $a:ident $a_tangent:ident 1) => {
        #[doc = concat!("From `", stringify!($vjp), "`.")]
        #[inline(always)]
        fn $jvp(self, $a: Self, tangent: Self, $a_tangent: Self) -> (Self, Self) {
            let (value, pullback) = self.$vjp($a);
            (value, pullback(tangent).0 + self.$vjp($a).1($a_tangent).1)
        }
    };
    (@one $jvp:ident $vjp:ident $a:ident $a_tangent:ident 1, $b:ident $b_tangent:ident 2) => {
        #[doc = concat!("From `", stringify!($vjp), "`.")]
        #[inline(always)]
        fn $jvp(
            self,
            $a: Self,
            $b: Self,
            tangent: Self,
            $a_tangent: Self,
            $b_tangent: Self,
        ) -> (Self, Self) {
            let (value, pullback) = self.$vjp($a, $b);
            let along_self = pullback(tangent).0;
            let along_a = self.$vjp($a, $b).1($a_tangent).1;
            let along_b = self.$vjp($a, $b).1($b_tangent).2;
            (value, along_self + along_a + along_b)
        }
    };
}

use symmetric;

/// Sine and cosine of an angle, times its tangent.
#[inline(always)]
fn rotated<S: crate::Real>(angle: S, tangent: S) -> (S, S) {
    (super::chain(tangent, angle.sin()), super::chain(tangent, angle.cos()))
}
