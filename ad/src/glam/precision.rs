//! The rules of the methods that convert what glam has in one precision to the other, each a trait: only one type
//! has it.

use glam::{Affine2, Affine3, Mat2, Mat3, Mat4, Quat, Vec2, Vec3, Vec4};
use glam::{DAffine2, DAffine3, DMat2, DMat3, DMat4, DQuat, DVec2, DVec3, DVec4};

use super::kin::Kin;
use crate::rules::row::rules;

/// The rules of both conversions of each pair of types, by value or by reference as glam's methods are.
macro_rules! pairs {
    ($($single:ident $double:ident $receiver:tt $to_double:ident $to_single:ident;)*) => { pastey::paste! {$(
        pairs!([<To $double>] $single $receiver $to_double $double $to_single);
        pairs!([<To $single>] $double $receiver $to_single $single $to_double);
    )*}};
    ($rules:ident $from:ident $receiver:tt $convert:ident $to:ident $back:ident) => {
        rules! {
            #[doc = concat!("The rule of `", stringify!($convert), "`.")]
            $rules: Kin for $from {
                $convert $receiver -> $to: |g| g.$back();
            }
        }
    };
}

pairs! {
    Vec2 DVec2 (v) as_dvec2 as_vec2;
    Vec3 DVec3 (v) as_dvec3 as_vec3;
    Vec4 DVec4 (v) as_dvec4 as_vec4;
    Quat DQuat (q) as_dquat as_quat;
    Mat2 DMat2 (&m) as_dmat2 as_mat2;
    Mat3 DMat3 (&m) as_dmat3 as_mat3;
    Mat4 DMat4 (&m) as_dmat4 as_mat4;
    Affine2 DAffine2 (&m) as_daffine2 as_affine2;
    Affine3 DAffine3 (&m) as_daffine3 as_affine3;
}
