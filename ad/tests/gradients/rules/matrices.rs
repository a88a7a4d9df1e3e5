//! Matrices and quaternions.

use ad::rules::*;
use glam::EulerRot;
use glam::{Affine2, Affine3, Mat2, Mat3, Mat4, Quat, Vec2, Vec3, Vec4};
use glam::{DAffine2, DAffine3, DMat2, DMat3, DMat4, DQuat, DVec2, DVec3, DVec4};

use super::case::{Case, anywhere, case, functions, negative, not_small, operators};

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

/// Makes the first and the second three numbers vectors of length 1 that are neither near to each
/// other nor opposite.
fn two_directions(x: &mut [f64]) -> bool {
    for v in x[..6].chunks_exact_mut(3) {
        let length = v.iter().map(|v| v * v).sum::<f64>().sqrt();
        v.iter_mut().for_each(|v| *v /= length);
    }
    let cosine: f64 = (0..3).map(|i| x[i] * x[3 + i]).sum();
    cosine.abs() < 0.8
}

/// Makes the first and the second two numbers vectors of length 1 that are neither near to
/// each other nor opposite.
fn off_one_line(x: &mut [f64]) -> bool {
    for v in x.chunks_exact_mut(2) {
        let length = v[0].hypot(v[1]);
        v.iter_mut().for_each(|v| *v /= length);
    }
    (x[0] * x[2] + x[1] * x[3]).abs() < 0.8
}

/// Two rotations far apart, and a short angle in either direction.
fn by_a_third(x: &mut [f64]) -> bool {
    x[8] = 0.3_f64.copysign(x[8]) + 0.01 * x[8];
    two_rotations(x) && (0.3..0.7).contains(&(0..4).map(|i| x[i] * x[4 + i]).sum::<f64>().abs())
}

/// Two directions that are not nearly across each other.
fn in_one_half(x: &mut [f64]) -> bool {
    two_directions(x) && (0..3).map(|i| x[i] * x[3 + i]).sum::<f64>().abs() > 0.1
}

/// No number is small.
fn off_zero(x: &mut [f64]) -> bool {
    x.iter_mut().for_each(|x| *x += 0.3_f64.copysign(*x));
    true
}

/// What the projection divides by is large.
fn with_a_far_eye(x: &mut [f64]) -> bool {
    x[15] += 20.0;
    true
}

/// The cases of methods that take their argument by reference, too.
macro_rules! of_references {
    ($($name:ident(a: $A:ty, b: $B:ty) -> $R:ty;)*) => { pastey::paste! { vec![$(case(
        stringify!($name),
        anywhere,
        |(a, b): ($A, $B)| -> $R { a.$name(&b) },
        |(a, b), g| {
            let (value, pullback) = a.[<$name _vjp>](&b);
            (value, pullback(g))
        },
        |(a, b), (a_dot, b_dot)| a.[<$name _jvp>](&b, &a_dot, &b_dot),
    )),*] }};
}

/// The cases of methods that give the part of a matrix with an index.
macro_rules! by_index {
    ($M:ident -> $V:ident: $($name:ident)*) => { pastey::paste! { [$(case(
        stringify!($name),
        anywhere,
        |a: $M| -> $V { a.$name(1) },
        |a, g| {
            let (value, pullback) = a.[<$name _vjp>](1);
            (value, pullback(g).0)
        },
        |a, a_dot| a.[<$name _jvp>](1, &a_dot, ()),
    )),*] }};
}

/// The cases of functions of one reference.
macro_rules! from_references {
    ($($R:ty, $name:ident(a: $A:ty);)*) => { pastey::paste! { vec![$(case(
        concat!(stringify!($R), "::", stringify!($name)),
        anywhere,
        |a: $A| -> $R { <$R>::$name(&a) },
        |a, g| {
            let (value, pullback) = <$R>::[<$name _vjp>](&a);
            (value, pullback(g))
        },
        |a, a_dot| <$R>::[<$name _jvp>](&a, &a_dot),
    )),*] }};
}

/// The cases of a function of three angles, by the order of axes: three of them and two, about those that
/// turn with it and about those that stay.
macro_rules! from_angles {
    ($R:ty) => { from_angles!($R: XYZ YXZ ZXZ ZYXEx YZYEx) };
    ($R:ty: $($order:ident)*) => {
        [$(case(
            concat!(stringify!($R), "::from_euler ", stringify!($order)),
            anywhere,
            |(a, b, c): (S, S, S)| -> $R { <$R>::from_euler(EulerRot::$order, a, b, c) },
            |(a, b, c), g| {
                let (value, pullback) = <$R>::from_euler_vjp(EulerRot::$order, a, b, c);
                let (_, a, b, c) = pullback(g);
                (value, (a, b, c))
            },
            |(a, b, c), (a_dot, b_dot, c_dot)| {
                <$R>::from_euler_jvp(EulerRot::$order, a, b, c, (), a_dot, b_dot, c_dot)
            },
        )),*]
    };
}

/// The diagonal is far from where the number by whose way the quaternion is computed changes.
fn certain(x: &mut [f64]) -> bool {
    let n = if x.len() == 16 { 4 } else { 3 };
    let [a, b, c] = [0, 1, 2].map(|i| x[i * n + i]);
    c.abs() > 0.1 && (b - a).abs() > 0.1 && (b + a).abs() > 0.1
}

macro_rules! square {
    ($($name:ident $matrix:ident $scalar:ident $vector:ident $n:literal $size:ident $times:ident $by_rows:ident ($($x:ident),*);)*) => {$(
        pub fn $name() -> Vec<Case<$scalar>> {
            type S = $scalar;
            type V = $vector;
            type M = $matrix;
            let mut cases = functions! {
                $times(a: M, b: V) -> V, anywhere;
                mul_scalar(a: M, b: S) -> M, anywhere;
                div_scalar(a: M, b: S) -> M, not_small;
                determinant(a: M) -> S, anywhere;
                inverse(a: M) -> M, invertible::<$n>;
                transpose(a: M) -> M, anywhere;
                [M] from_diagonal(a: V) -> M, anywhere;
                [M] from_cols($($x: V),*) -> M, anywhere;
                [M] from_rows($($x: V),*) -> M, anywhere;
                diagonal(a: M) -> V, anywhere;
                to_rows_array(a: M) -> [S; $n * $n], anywhere;
                abs(a: M) -> M, not_small;
                recip(a: M) -> M, off_zero;
                inverse_or_zero(a: M) -> M, invertible::<$n>;
                mul_diagonal_scale(a: M, b: V) -> M, anywhere;
                $by_rows(a: M, b: V) -> V, anywhere;
            };
            cases.extend(operators! {
                M + M -> M, anywhere;
                M - M -> M, anywhere;
                M * M -> M, anywhere;
                M * V -> V, anywhere;
                M * S -> M, anywhere;
                S * M -> M, anywhere;
                M / S -> M, not_small;
            });
            cases.push(negative::<S, M>());
            cases.extend(by_index!(M -> V: col row));
            pastey::paste! {
                cases.extend(of_references! {
                    [<mul_ $size>](a: M, b: M) -> M;
                    [<add_ $size>](a: M, b: M) -> M;
                    [<sub_ $size>](a: M, b: M) -> M;
                });
            }
            cases.extend(from_references! {
                M, from_cols_array_2d(a: [[S; $n]; $n]);
                M, from_cols_array(a: [S; $n * $n]);
                M, from_rows_array(a: [S; $n * $n]);
            });
            cases
        }
    )*};
}

square! {
    single2 Mat2 f32 Vec2 2 mat2 mul_vec2 transpose_mul_vec2 (x, y);
    single3 Mat3 f32 Vec3 3 mat3 mul_vec3 transpose_mul_vec3 (x, y, z);
    single4 Mat4 f32 Vec4 4 mat4 mul_vec4 transpose_mul_vec4 (x, y, z, w);
    double2 DMat2 f64 DVec2 2 mat2 mul_vec2 transpose_mul_vec2 (x, y);
    double3 DMat3 f64 DVec3 3 mat3 mul_vec3 transpose_mul_vec3 (x, y, z);
    double4 DMat4 f64 DVec4 4 mat4 mul_vec4 transpose_mul_vec4 (x, y, z, w);
}

macro_rules! motions {
    ($($name:ident $scalar:ident $vector:ident $quat:ident $two:ident $three:ident $four:ident
        $plane:ident $space:ident;)*) => {$(
        pub fn $name() -> Vec<Case<$scalar>> {
            type S = $scalar;
            type V = $vector;
            type Q = $quat;
            type M2 = $two;
            type M3 = $three;
            type M4 = $four;
            type A2 = $plane;
            type A3 = $space;
            type U = <A2 as Kin>::V2;
            type W = <A2 as Kin>::V4;
            let mut cases = functions! {
                mul_vec3(a: Q, b: V) -> V, anywhere;
                mul_quat(a: Q, b: Q) -> Q, anywhere;
                conjugate(a: Q) -> Q, anywhere;
                inverse(a: Q) -> Q, anywhere;
                normalize(a: Q) -> Q, away_from_zero;
                length(a: Q) -> S, away_from_zero;
                length_squared(a: Q) -> S, anywhere;
                dot(a: Q, b: Q) -> S, anywhere;
                xyz(a: Q) -> V, anywhere;
                [Q] from_xyzw(x: S, y: S, z: S, w: S) -> Q, anywhere;
                [Q] from_axis_angle(a: V, b: S) -> Q, anywhere;
                [Q] from_rotation_x(a: S) -> Q, anywhere;
                [Q] from_rotation_y(a: S) -> Q, anywhere;
                [Q] from_rotation_z(a: S) -> Q, anywhere;
                lerp(a: Q, b: Q, s: S) -> Q, two_rotations;
                slerp(a: Q, b: Q, s: S) -> Q, two_rotations;
                [Q] from_scaled_axis(a: V) -> Q, not_small;
                [Q] from_rotation_axes(a: V, b: V, c: V) -> Q, certain;
                [Q] from_array(a: [S; 4]) -> Q, anywhere;
                [Q] from_vec4(a: W) -> Q, anywhere;
                to_array(a: Q) -> [S; 4], anywhere;
                length_recip(a: Q) -> S, away_from_zero;
                to_scale_rotation_translation(a: M4) -> (V, Q, V), invertible::<4>;
                to_scale_rotation_translation(a: A3) -> (V, Q, V), invertible::<3>;
                [M4] from_mat3_translation(a: M3, b: V) -> M4, anywhere;
                [Q] from_rotation_arc(a: V, b: V) -> Q, two_directions;
                [Q] from_rotation_arc_colinear(a: V, b: V) -> Q, in_one_half;
                [Q] from_rotation_arc_2d(a: U, b: U) -> Q, off_one_line;
                slerp_long(a: Q, b: Q, s: S) -> Q, two_rotations;
                rotate_towards(a: Q, b: Q, s: S) -> Q, by_a_third;
                [M2] from_scale_angle(a: U, b: S) -> M2, anywhere;
                [M2] from_mat3(a: M3) -> M2, anywhere;
                [A2] from_mat3(a: M3) -> A2, anywhere;
                [A2] from_cols(a: U, b: U, c: U) -> A2, anywhere;
                [A3] from_cols(a: V, b: V, c: V, d: V) -> A3, anywhere;
                to_cols_array(a: A2) -> [S; 6], anywhere;
                to_cols_array_2d(a: A3) -> [[S; 3]; 4], anywhere;
                to_scale_angle_translation(a: A2) -> (U, S, U), invertible::<2>;
                to_axis_angle(a: Q) -> (V, S), not_small;
                to_scaled_axis(a: Q) -> V, not_small;
                angle_between(a: Q, b: Q) -> S, two_rotations;
                [M2] from_angle(a: S) -> M2, anywhere;
                [M3] from_mat2(a: M2) -> M3, anywhere;
                [M3] from_mat4(a: M4) -> M3, anywhere;
                [M3] from_scale(a: U) -> M3, anywhere;
                [M3] from_translation(a: U) -> M3, anywhere;
                [M3] from_scale_angle_translation(a: U, b: S, c: U) -> M3, anywhere;
                transform_point2(a: M3, b: U) -> U, anywhere;
                transform_vector2(a: M3, b: U) -> U, anywhere;
                [A2] from_angle(a: S) -> A2, anywhere;
                [A2] from_scale(a: U) -> A2, anywhere;
                [A2] from_translation(a: U) -> A2, anywhere;
                [A2] from_angle_translation(a: S, b: U) -> A2, anywhere;
                [A2] from_scale_angle_translation(a: U, b: S, c: U) -> A2, anywhere;
                [A2] from_mat2(a: M2) -> A2, anywhere;
                [A2] from_mat2_translation(a: M2, b: U) -> A2, anywhere;
                transform_point2(a: A2, b: U) -> U, anywhere;
                transform_vector2(a: A2, b: U) -> U, anywhere;
                inverse(a: A2) -> A2, invertible::<2>;
                [M3] from_angle(a: S) -> M3, anywhere;
                [M3] from_rotation_x(a: S) -> M3, anywhere;
                [M3] from_rotation_y(a: S) -> M3, anywhere;
                [M3] from_rotation_z(a: S) -> M3, anywhere;
                [M3] from_axis_angle(a: V, b: S) -> M3, anywhere;
                [M3] from_quat(a: Q) -> M3, anywhere;
                [M4] from_rotation_x(a: S) -> M4, anywhere;
                [M4] from_rotation_y(a: S) -> M4, anywhere;
                [M4] from_rotation_z(a: S) -> M4, anywhere;
                [M4] from_axis_angle(a: V, b: S) -> M4, anywhere;
                [M4] from_quat(a: Q) -> M4, anywhere;
                transform_point3(a: M4, b: V) -> V, anywhere;
                transform_vector3(a: M4, b: V) -> V, anywhere;
                [M4] from_mat3(a: M3) -> M4, anywhere;
                [M4] from_translation(a: V) -> M4, anywhere;
                [M4] from_scale(a: V) -> M4, anywhere;
                [M4] from_rotation_translation(a: Q, b: V) -> M4, anywhere;
                [M4] from_scale_rotation_translation(a: V, b: Q, c: V) -> M4, anywhere;
                project_point3(a: M4, b: V) -> V, with_a_far_eye;
                [A3] from_rotation_x(a: S) -> A3, anywhere;
                [A3] from_rotation_y(a: S) -> A3, anywhere;
                [A3] from_rotation_z(a: S) -> A3, anywhere;
                [A3] from_axis_angle(a: V, b: S) -> A3, anywhere;
                [A3] from_quat(a: Q) -> A3, anywhere;
                [A3] from_scale(a: V) -> A3, anywhere;
                [A3] from_translation(a: V) -> A3, anywhere;
                [A3] from_rotation_translation(a: Q, b: V) -> A3, anywhere;
                [A3] from_scale_rotation_translation(a: V, b: Q, c: V) -> A3, anywhere;
                [A3] from_mat3(a: M3) -> A3, anywhere;
                [A3] from_mat4(a: M4) -> A3, anywhere;
                [A3] from_mat3_translation(a: M3, b: V) -> A3, anywhere;
                transform_point3(a: A3, b: V) -> V, anywhere;
                transform_vector3(a: A3, b: V) -> V, anywhere;
                inverse(a: A3) -> A3, invertible::<3>;
            };
            cases.extend(operators! {
                Q * Q -> Q, anywhere;
                Q * V -> V, anywhere;
                Q * S -> Q, anywhere;
                Q / S -> Q, not_small;
                Q + Q -> Q, anywhere;
                Q - Q -> Q, anywhere;
                A2 * A2 -> A2, anywhere;
                A3 * A3 -> A3, anywhere;
            });
            cases.push(negative::<S, Q>());
            cases.extend(from_references! {
                A2, from_cols_array(a: [S; 6]);
                A2, from_cols_array_2d(a: [[S; 2]; 3]);
                A3, from_cols_array(a: [S; 12]);
                A3, from_cols_array_2d(a: [[S; 3]; 4]);
            });
            cases.extend(from_angles!(Q));
            cases.extend(from_angles!(M3));
            cases.extend(from_angles!(M4));
            cases
        }
    )*};
}

motions! {
    single_motions f32 Vec3 Quat Mat2 Mat3 Mat4 Affine2 Affine3;
    double_motions f64 DVec3 DQuat DMat2 DMat3 DMat4 DAffine2 DAffine3;
}
