//! Motions of the plane and of space, as matrices of `M` columns of `N` numbers: `M = 2` or `3` without
//! a translation, and `N` by `N` with the last row of the identity, or without that row.

#![allow(clippy::needless_range_loop, reason = "rows and columns by their numbers")]

use ad_macros::differentiable;

use super::rotation::{axis_angle_matrix, rotation_matrix};
use super::vector::{cross, dot, perp_dot, times};
use super::{Columns, Quaternion, Triple};
use crate::{Additive, Real};

/// The upper left part of a matrix, or a matrix with it there that else is the identity.
#[differentiable(vjp = resized_vjp, jvp = resized_jvp)]
pub fn resized<S: Real, const A: usize, const B: usize, const N: usize, const M: usize>(
    a: [[S; A]; B],
) -> [[S; N]; M] {
    let identity = |i, j| if i == j { S::ONE } else { S::ZERO };
    overlaid(a, std::array::from_fn(|i| std::array::from_fn(|j| identity(i, j))))
}

fn resized_vjp<S: Real, const A: usize, const B: usize, const N: usize, const M: usize>(
    a: [[S; A]; B],
) -> ([[S; N]; M], impl FnOnce([[S; N]; M]) -> [[S; A]; B]) {
    (resized(a), |cotangent| overlaid(cotangent, Additive::zero()))
}

fn resized_jvp<S: Real, const A: usize, const B: usize, const N: usize, const M: usize>(
    a: [[S; A]; B],
    tangent: [[S; A]; B],
) -> ([[S; N]; M], [[S; N]; M]) {
    (resized(a), overlaid(tangent, Additive::zero()))
}

/// Replaces what two matrices have both of the second one.
fn overlaid<S: Real, const A: usize, const B: usize, const N: usize, const M: usize>(
    upper: [[S; A]; B],
    mut lower: [[S; N]; M],
) -> [[S; N]; M] {
    for (lower, upper) in lower.iter_mut().zip(upper) {
        lower.iter_mut().zip(upper).for_each(|(lower, upper)| *lower = upper);
    }
    lower
}

#[differentiable]
pub fn plane<S: Real, const N: usize, const M: usize>(
    scale: [S; 2],
    angle: S,
    translation: [S; 2],
) -> [[S; N]; M] {
    let (sin, cos) = (angle.sin(), angle.cos());
    let (x, y) = ([cos * scale[0], sin * scale[0]], [-sin * scale[1], cos * scale[1]]);
    resized::<S, 2, 3, N, M>([x, y, translation])
}

#[differentiable]
pub fn from_angle<S: Real, const N: usize, const M: usize>(angle: S) -> [[S; N]; M] {
    plane::<S, N, M>([S::ONE; 2], angle, [S::ZERO; 2])
}

#[differentiable]
pub fn from_angle_translation<S: Real, const N: usize, const M: usize>(
    angle: S,
    translation: [S; 2],
) -> [[S; N]; M] {
    plane::<S, N, M>([S::ONE; 2], angle, translation)
}

#[differentiable]
pub fn transform_vector2<S: Real, const N: usize>(a: [[S; N]; 3], v: [S; 2]) -> [S; 2] {
    std::array::from_fn(|i| a[0][i] * v[0] + a[1][i] * v[1])
}

#[differentiable]
pub fn transform_point2<S: Real, const N: usize>(a: [[S; N]; 3], v: [S; 2]) -> [S; 2] {
    std::array::from_fn(|i| a[0][i] * v[0] + a[1][i] * v[1] + a[2][i])
}

/// A matrix, and a translation as its last column.
#[differentiable]
pub fn moved<S: Real, const K: usize, const N: usize, const M: usize>(
    linear: [[S; K]; K],
    translation: [S; K],
) -> [[S; N]; M] {
    let mut columns = resized::<S, K, K, N, M>(linear);
    for i in 0..K {
        columns[K][i] = translation[i];
    }
    columns
}

#[differentiable]
pub fn from_translation<S: Real, const K: usize, const N: usize, const M: usize>(
    translation: [S; K],
) -> [[S; N]; M] {
    moved::<S, K, N, M>(diagonal::<S, K>([S::ONE; K]), translation)
}

#[differentiable]
pub fn diagonal<S: Real, const K: usize>(elements: [S; K]) -> [[S; K]; K] {
    let mut columns = [[S::ZERO; K]; K];
    for i in 0..K {
        columns[i][i] = elements[i];
    }
    columns
}

#[differentiable]
pub fn from_scale<S: Real, const K: usize, const N: usize, const M: usize>(
    scale: [S; K],
) -> [[S; N]; M] {
    resized::<S, K, K, N, M>(diagonal::<S, K>(scale))
}

#[differentiable]
pub fn from_quat<S: Real, const N: usize, const M: usize>(turn: Quaternion<S>) -> [[S; N]; M] {
    resized::<S, 3, 3, N, M>(rotation_matrix::<S>(turn))
}

#[differentiable]
pub fn from_axis_angle<S: Real, const N: usize, const M: usize>(
    axis: Triple<S>,
    angle: S,
) -> [[S; N]; M] {
    resized::<S, 3, 3, N, M>(axis_angle_matrix::<S>(axis, angle))
}

#[differentiable]
pub fn about_x<S: Real, const N: usize, const M: usize>(angle: S) -> [[S; N]; M] {
    from_axis_angle::<S, N, M>([S::ONE, S::ZERO, S::ZERO], angle)
}

#[differentiable]
pub fn about_y<S: Real, const N: usize, const M: usize>(angle: S) -> [[S; N]; M] {
    from_axis_angle::<S, N, M>([S::ZERO, S::ONE, S::ZERO], angle)
}

#[differentiable]
pub fn about_z<S: Real, const N: usize, const M: usize>(angle: S) -> [[S; N]; M] {
    from_axis_angle::<S, N, M>([S::ZERO, S::ZERO, S::ONE], angle)
}

#[differentiable]
pub fn from_rotation_translation<S: Real, const N: usize, const M: usize>(
    turn: Quaternion<S>,
    translation: Triple<S>,
) -> [[S; N]; M] {
    moved::<S, 3, N, M>(rotation_matrix::<S>(turn), translation)
}

#[differentiable]
pub fn from_scale_rotation_translation<S: Real, const N: usize, const M: usize>(
    scale: Triple<S>,
    turn: Quaternion<S>,
    translation: Triple<S>,
) -> [[S; N]; M] {
    let axes = rotation_matrix::<S>(turn);
    moved::<S, 3, N, M>(std::array::from_fn(|i| times::<S, 3>(axes[i], scale[i])), translation)
}

#[differentiable]
pub fn transform_vector3<S: Real, const N: usize>(a: [[S; N]; 4], v: Triple<S>) -> Triple<S> {
    std::array::from_fn(|i| a[0][i] * v[0] + a[1][i] * v[1] + a[2][i] * v[2])
}

#[differentiable]
pub fn transform_point3<S: Real, const N: usize>(a: [[S; N]; 4], v: Triple<S>) -> Triple<S> {
    std::array::from_fn(|i| a[0][i] * v[0] + a[1][i] * v[1] + a[2][i] * v[2] + a[3][i])
}

#[differentiable]
pub fn project_point3<S: Real>(a: [[S; 4]; 4], v: Triple<S>) -> Triple<S> {
    let w = a[0][3] * v[0] + a[1][3] * v[1] + a[2][3] * v[2] + a[3][3];
    std::array::from_fn(|i| (a[0][i] * v[0] + a[1][i] * v[1] + a[2][i] * v[2] + a[3][i]) / w)
}

#[differentiable]
pub fn product2<S: Real>(a: [[S; 2]; 3], b: [[S; 2]; 3]) -> [[S; 2]; 3] {
    let axis = |i: usize| transform_vector2::<S, 2>(a, b[i]);
    [axis(0), axis(1), transform_point2::<S, 2>(a, b[2])]
}

#[differentiable]
pub fn product3<S: Real>(a: [Triple<S>; 4], b: [Triple<S>; 4]) -> [Triple<S>; 4] {
    let axis = |i: usize| transform_vector3::<S, 3>(a, b[i]);
    [axis(0), axis(1), axis(2), transform_point3::<S, 3>(a, b[3])]
}

#[differentiable]
pub fn inverse2<S: Real>(a: [[S; 2]; 3]) -> [[S; 2]; 3] {
    let scale = S::ONE / perp_dot::<S>(a[0], a[1]);
    let (x, y) = ([a[1][1] * scale, -a[0][1] * scale], [-a[1][0] * scale, a[0][0] * scale]);
    let moved = transform_vector2::<S, 2>([x, y, [S::ZERO; 2]], a[2]);
    [x, y, [-moved[0], -moved[1]]]
}

#[differentiable]
pub fn inverse3<S: Real>(a: [Triple<S>; 4]) -> [Triple<S>; 4] {
    let [x, y, z, translation] = a;
    let rows = [cross::<S>(y, z), cross::<S>(z, x), cross::<S>(x, y)];
    let scale = S::ONE / dot::<S, 3>(x, rows[0]);
    let linear: Columns<S> =
        std::array::from_fn(|i| [rows[0][i] * scale, rows[1][i] * scale, rows[2][i] * scale]);
    let moved: Triple<S> = std::array::from_fn(|i| -dot::<S, 3>(rows[i], translation) * scale);
    [linear[0], linear[1], linear[2], moved]
}
