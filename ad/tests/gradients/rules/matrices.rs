//! Matrices and quaternions.

use ad::rules::*;
use glam::{DMat2, DMat3, DMat4, DQuat, DVec2, DVec3, DVec4};
use glam::{Mat2, Mat3, Mat4, Quat, Vec2, Vec3, Vec4};

use super::case::{Case, anywhere, call, rule};

/// Far from having no inverse: the diagonal is large.
fn invertible<const N: usize>(x: &mut [f64]) -> bool {
    (0..N).for_each(|i| x[i * N + i] += 8.0_f64.copysign(x[i * N + i]));
    true
}

/// Makes the first and the second four numbers quaternions of length 1 that are neither near to
/// each other nor opposite.
fn two_rotations(x: &mut [f64]) -> bool {
    x[0] += 2.0;
    x[5] += 3.0;
    for q in x[..8].chunks_exact_mut(4) {
        let length = q.iter().map(|q| q * q).sum::<f64>().sqrt();
        q.iter_mut().for_each(|q| *q /= length);
    }
    let cosine: f64 = (0..4).map(|i| x[i] * x[4 + i]).sum();
    (0.05..0.9).contains(&cosine.abs())
}

/// The first numbers are not all small.
fn away_from_zero(x: &mut [f64]) -> bool {
    x[0] += 1.0_f64.copysign(x[0]);
    true
}

macro_rules! square {
    ($($name:ident $matrix:ident $scalar:ident $vector:ident $n:literal
        $times:ident $times_vjp:ident ($($x:ident),*);)*) => {$(
        pub fn $name() -> Vec<Case<$scalar>> {
            type S = $scalar;
            type V = $vector;
            type M = $matrix;
            vec![
                rule!("matrix + matrix" anywhere, (a: M, b: M) -> M,
                    a + b, |g| (a + b, M::add_pullback(&Default::default(), g))),
                rule!("matrix - matrix" anywhere, (a: M, b: M) -> M,
                    a - b, |g| (a - b, M::sub_pullback(&Default::default(), g))),
                rule!("-matrix" anywhere, (a: M) -> M, -a, |g| (-a, M::neg_pullback(&Default::default(), g))),
                rule!("matrix * matrix" anywhere, (a: M, b: M) -> M,
                    a * b, |g| (a * b, a.mul_pullback(b, g))),
                rule!("matrix * vector" anywhere, (a: M, b: V) -> V,
                    a * b, |g| (a * b, a.mul_pullback(b, g))),
                rule!("matrix * scalar" anywhere, (a: M, b: S) -> M,
                    a * b, |g| (a * b, a.mul_pullback(b, g))),
                rule!("scalar * matrix" anywhere, (a: S, b: M) -> M,
                    a * b, |g| (a * b, a.mul_pullback(b, g))),
                rule!("mul_vec" anywhere, (a: M, b: V) -> V,
                    a.$times(b), |g| call!(a.$times_vjp(b), g)),
                rule!("transpose" anywhere, (a: M) -> M,
                    a.transpose(), |g| call!(a.transpose_vjp(), g)),
                rule!("determinant" anywhere, (a: M) -> S,
                    a.determinant(), |g| call!(a.determinant_vjp(), g)),
                rule!("inverse" invertible::<$n>, (a: M) -> M,
                    a.inverse(), |g| call!(a.inverse_vjp(), g)),
                rule!("from_diagonal" anywhere, (a: V) -> M,
                    M::from_diagonal(a), |g| call!(M::from_diagonal_vjp(a), g)),
                rule!("col" anywhere, (a: M) -> V, a.col(1), |g| {
                    let (value, pullback) = a.col_vjp(1);
                    (value, pullback(g).0)
                }),
                rule!("from_cols" anywhere, ($($x: V),*) -> M,
                    M::from_cols($($x),*), |g| call!(M::from_cols_vjp($($x),*), g)),
            ]
        }
    )*};
}

square! {
    single2 Mat2 f32 Vec2 2 mul_vec2 mul_vec2_vjp (x, y);
    single3 Mat3 f32 Vec3 3 mul_vec3 mul_vec3_vjp (x, y, z);
    single4 Mat4 f32 Vec4 4 mul_vec4 mul_vec4_vjp (x, y, z, w);
    double2 DMat2 f64 DVec2 2 mul_vec2 mul_vec2_vjp (x, y);
    double3 DMat3 f64 DVec3 3 mul_vec3 mul_vec3_vjp (x, y, z);
    double4 DMat4 f64 DVec4 4 mul_vec4 mul_vec4_vjp (x, y, z, w);
}

macro_rules! motions {
    ($($name:ident $scalar:ident $vector:ident $quat:ident $two:ident $three:ident $four:ident;)*) => {$(
        pub fn $name() -> Vec<Case<$scalar>> {
            type S = $scalar;
            type V = $vector;
            type Q = $quat;
            let mut cases = vec![
                rule!("quat * quat" anywhere, (a: Q, b: Q) -> Q,
                    a * b, |g| (a * b, a.mul_pullback(b, g))),
                rule!("quat * vector" anywhere, (a: Q, b: V) -> V,
                    a * b, |g| (a * b, a.mul_pullback(b, g))),
                rule!("quat * scalar" anywhere, (a: Q, b: S) -> Q,
                    a * b, |g| (a * b, a.mul_pullback(b, g))),
                rule!("quat + quat" anywhere, (a: Q, b: Q) -> Q,
                    a + b, |g| (a + b, Q::add_pullback(&Default::default(), g))),
                rule!("quat - quat" anywhere, (a: Q, b: Q) -> Q,
                    a - b, |g| (a - b, Q::sub_pullback(&Default::default(), g))),
                rule!("mul_vec3" anywhere, (a: Q, b: V) -> V,
                    a.mul_vec3(b), |g| call!(a.mul_vec3_vjp(b), g)),
                rule!("mul_quat" anywhere, (a: Q, b: Q) -> Q,
                    a.mul_quat(b), |g| call!(a.mul_quat_vjp(b), g)),
                rule!("conjugate" anywhere, (a: Q) -> Q,
                    a.conjugate(), |g| call!(a.conjugate_vjp(), g)),
                rule!("quat inverse" anywhere, (a: Q) -> Q,
                    a.inverse(), |g| call!(a.inverse_vjp(), g)),
                rule!("quat normalize" away_from_zero, (a: Q) -> Q,
                    a.normalize(), |g| call!(a.normalize_vjp(), g)),
                rule!("quat length" away_from_zero, (a: Q) -> S,
                    a.length(), |g| call!(a.length_vjp(), g)),
                rule!("quat length_squared" anywhere, (a: Q) -> S,
                    a.length_squared(), |g| call!(a.length_squared_vjp(), g)),
                rule!("quat dot" anywhere, (a: Q, b: Q) -> S,
                    a.dot(b), |g| call!(a.dot_vjp(b), g)),
                rule!("xyz" anywhere, (a: Q) -> V, a.xyz(), |g| call!(a.xyz_vjp(), g)),
                rule!("from_xyzw" anywhere, (x: S, y: S, z: S, w: S) -> Q,
                    Q::from_xyzw(x, y, z, w), |g| call!(Q::from_xyzw_vjp(x, y, z, w), g)),
                rule!("quat from_axis_angle" anywhere, (a: V, b: S) -> Q,
                    Q::from_axis_angle(a, b), |g| call!(Q::from_axis_angle_vjp(a, b), g)),
                rule!("quat lerp" two_rotations, (a: Q, b: Q, s: S) -> Q,
                    a.lerp(b, s), |g| call!(a.lerp_vjp(b, s), g)),
                rule!("slerp" two_rotations, (a: Q, b: Q, s: S) -> Q,
                    a.slerp(b, s), |g| call!(a.slerp_vjp(b, s), g)),
                rule!("from_angle" anywhere, (a: S) -> $two,
                    $two::from_angle(a), |g| call!($two::from_angle_vjp(a), g)),
                rule!("transform_point3" anywhere, (a: $four, b: V) -> V,
                    a.transform_point3(b), |g| call!(a.transform_point3_vjp(b), g)),
                rule!("transform_vector3" anywhere, (a: $four, b: V) -> V,
                    a.transform_vector3(b), |g| call!(a.transform_vector3_vjp(b), g)),
                rule!("from_translation" anywhere, (a: V) -> $four,
                    $four::from_translation(a), |g| call!($four::from_translation_vjp(a), g)),
                rule!("from_scale" anywhere, (a: V) -> $four,
                    $four::from_scale(a), |g| call!($four::from_scale_vjp(a), g)),
                rule!("from_rotation_translation" anywhere, (a: Q, b: V) -> $four,
                    $four::from_rotation_translation(a, b),
                    |g| call!($four::from_rotation_translation_vjp(a, b), g)),
                rule!("from_scale_rotation_translation" anywhere, (a: V, b: Q, c: V) -> $four,
                    $four::from_scale_rotation_translation(a, b, c),
                    |g| call!($four::from_scale_rotation_translation_vjp(a, b, c), g)),
            ];
            cases.extend(motions!(@turned "quaternion" $quat S));
            cases.extend(motions!(@turned "3" $three S));
            cases.extend(motions!(@turned "4" $four S));
            cases.extend(motions!(@made "3" $three S V Q));
            cases.extend(motions!(@made "4" $four S V Q));
            cases
        }
    )*};
    (@turned $tag:literal $type:ident $s:ident) => {
        [
            rule!((concat!("from_rotation_x ", $tag)) anywhere, (a: $s) -> $type,
                $type::from_rotation_x(a), |g| call!($type::from_rotation_x_vjp(a), g)),
            rule!((concat!("from_rotation_y ", $tag)) anywhere, (a: $s) -> $type,
                $type::from_rotation_y(a), |g| call!($type::from_rotation_y_vjp(a), g)),
            rule!((concat!("from_rotation_z ", $tag)) anywhere, (a: $s) -> $type,
                $type::from_rotation_z(a), |g| call!($type::from_rotation_z_vjp(a), g)),
        ]
    };
    (@made $tag:literal $type:ident $s:ident $v:ident $q:ident) => {
        [
            rule!((concat!("from_axis_angle ", $tag)) anywhere, (a: $v, b: $s) -> $type,
                $type::from_axis_angle(a, b), |g| call!($type::from_axis_angle_vjp(a, b), g)),
            rule!((concat!("from_quat ", $tag)) anywhere, (a: $q) -> $type,
                $type::from_quat(a), |g| call!($type::from_quat_vjp(a), g)),
        ]
    };
}

motions! {
    single_motions f32 Vec3 Quat Mat2 Mat3 Mat4;
    double_motions f64 DVec3 DQuat DMat2 DMat3 DMat4;
}
