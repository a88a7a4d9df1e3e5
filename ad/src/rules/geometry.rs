//! What glam computes with vectors and motions, as formulas over any scalar.

#![allow(
    clippy::manual_memcpy,
    clippy::needless_range_loop,
    reason = "rows and columns by their numbers"
)]

use ad_macros::differentiable;

use super::rotation::{self, Columns, Quaternion, Triple};
use crate::Real;

#[differentiable]
fn dot<S: Real, const N: usize>(a: [S; N], b: [S; N]) -> S {
    let mut sum = S::ZERO;
    for i in 0..N {
        sum += a[i] * b[i];
    }
    sum
}

#[differentiable]
fn times<S: Real, const N: usize>(a: [S; N], factor: S) -> [S; N] {
    std::array::from_fn(|i| a[i] * factor)
}

#[differentiable]
fn plus<S: Real, const N: usize>(a: [S; N], b: [S; N]) -> [S; N] {
    std::array::from_fn(|i| a[i] + b[i])
}

#[differentiable]
fn minus<S: Real, const N: usize>(a: [S; N], b: [S; N]) -> [S; N] {
    std::array::from_fn(|i| a[i] - b[i])
}

#[differentiable]
fn length<S: Real, const N: usize>(a: [S; N]) -> S {
    dot::<S, N>(a, a).sqrt()
}

fn holds<M: crate::Mask>(condition: M) -> bool {
    condition.all()
}

#[differentiable]
pub fn normalize_or<S: Real, const N: usize>(a: [S; N], fallback: [S; N]) -> [S; N] {
    let length = length::<S, N>(a);
    if holds(length.cmpgt(S::ZERO)) { times::<S, N>(a, S::ONE / length) } else { fallback }
}

#[differentiable]
pub fn reject_from<S: Real, const N: usize>(a: [S; N], onto: [S; N]) -> [S; N] {
    let share = dot::<S, N>(a, onto) / dot::<S, N>(onto, onto);
    minus::<S, N>(a, times::<S, N>(onto, share))
}

#[differentiable]
pub fn project_onto_normalized<S: Real, const N: usize>(a: [S; N], onto: [S; N]) -> [S; N] {
    times::<S, N>(onto, dot::<S, N>(a, onto))
}

#[differentiable]
pub fn reject_from_normalized<S: Real, const N: usize>(a: [S; N], onto: [S; N]) -> [S; N] {
    minus::<S, N>(a, project_onto_normalized::<S, N>(a, onto))
}

#[differentiable]
pub fn clamp_length_min<S: Real, const N: usize>(a: [S; N], min: S) -> [S; N] {
    let length = length::<S, N>(a);
    if holds(length.cmplt(min)) { times::<S, N>(a, min / length) } else { a }
}

#[differentiable]
pub fn clamp_length_max<S: Real, const N: usize>(a: [S; N], max: S) -> [S; N] {
    let length = length::<S, N>(a);
    if holds(length.cmpgt(max)) { times::<S, N>(a, max / length) } else { a }
}

#[differentiable]
pub fn clamp_length<S: Real, const N: usize>(a: [S; N], min: S, max: S) -> [S; N] {
    clamp_length_max::<S, N>(clamp_length_min::<S, N>(a, min), max)
}

#[differentiable]
pub fn move_towards<S: Real, const N: usize>(a: [S; N], end: [S; N], way: S) -> [S; N] {
    let apart = minus::<S, N>(end, a);
    let length = length::<S, N>(apart);
    // The threshold of glam.
    if holds(length.cmple(way) | length.cmple(S::from_f64(1e-4))) {
        return end;
    }
    plus::<S, N>(a, times::<S, N>(apart, way / length))
}

#[differentiable]
pub fn refract<S: Real, const N: usize>(a: [S; N], normal: [S; N], eta: S) -> [S; N] {
    let cosine = dot::<S, N>(normal, a);
    let k = S::ONE - eta * eta * (S::ONE - cosine * cosine);
    if holds(k.cmplt(S::ZERO)) {
        return [S::ZERO; N];
    }
    minus::<S, N>(times::<S, N>(a, eta), times::<S, N>(normal, eta * cosine + k.sqrt()))
}

#[differentiable]
pub fn direction<S: Real>(angle: S) -> [S; 2] {
    [angle.cos(), angle.sin()]
}

#[differentiable]
pub fn to_angle<S: Real>(a: [S; 2]) -> S {
    a[1].atan2(a[0])
}

#[differentiable]
pub fn perp<S: Real>(a: [S; 2]) -> [S; 2] {
    [-a[1], a[0]]
}

#[differentiable]
pub fn perp_dot<S: Real>(a: [S; 2], b: [S; 2]) -> S {
    a[0] * b[1] - a[1] * b[0]
}

#[differentiable]
pub fn angle_to<S: Real>(a: [S; 2], b: [S; 2]) -> S {
    perp_dot::<S>(a, b).atan2(dot::<S, 2>(a, b))
}

#[differentiable]
pub fn rotate<S: Real>(a: [S; 2], b: [S; 2]) -> [S; 2] {
    [a[0] * b[0] - a[1] * b[1], a[1] * b[0] + a[0] * b[1]]
}

#[differentiable]
pub fn rotate_angle<S: Real>(a: [S; 2], angle: S) -> [S; 2] {
    rotate::<S>(a, direction::<S>(angle))
}

#[differentiable]
fn cross<S: Real>(a: Triple<S>, b: Triple<S>) -> Triple<S> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[differentiable]
pub fn angle_between<S: Real>(a: Triple<S>, b: Triple<S>) -> S {
    length::<S, 3>(cross::<S>(a, b)).atan2(dot::<S, 3>(a, b))
}

#[differentiable]
pub fn rotate_x<S: Real>(a: Triple<S>, angle: S) -> Triple<S> {
    let [y, z] = rotate_angle::<S>([a[1], a[2]], angle);
    [a[0], y, z]
}

#[differentiable]
pub fn rotate_y<S: Real>(a: Triple<S>, angle: S) -> Triple<S> {
    let [z, x] = rotate_angle::<S>([a[2], a[0]], angle);
    [x, a[1], z]
}

#[differentiable]
pub fn rotate_z<S: Real>(a: Triple<S>, angle: S) -> Triple<S> {
    let [x, y] = rotate_angle::<S>([a[0], a[1]], angle);
    [x, y, a[2]]
}

#[differentiable]
pub fn rotate_axis<S: Real>(a: Triple<S>, axis: Triple<S>, angle: S) -> Triple<S> {
    rotation::rotated::<S>(rotation::from_axis_angle::<S>(axis, angle), a)
}

/// At 0, where the axis has no direction, the limit.
#[differentiable]
pub fn from_scaled_axis<S: Real>(axis: Triple<S>) -> Quaternion<S> {
    let angle = length::<S, 3>(axis);
    let half = angle * S::HALF;
    let scale = if holds(angle.cmpgt(S::ZERO)) { half.sin() / angle } else { S::HALF };
    let [x, y, z] = times::<S, 3>(axis, scale);
    [x, y, z, half.cos()]
}

#[differentiable]
pub fn from_rotation_arc<S: Real>(from: Triple<S>, to: Triple<S>) -> Quaternion<S> {
    let [x, y, z] = cross::<S>(from, to);
    let arc = [x, y, z, S::ONE + dot::<S, 3>(from, to)];
    times::<S, 4>(arc, S::ONE / length::<S, 4>(arc))
}

#[differentiable]
pub fn to_axis_angle<S: Real>(q: Quaternion<S>) -> (Triple<S>, S) {
    let axis = [q[0], q[1], q[2]];
    let length = length::<S, 3>(axis);
    // The threshold of glam.
    if holds(length.cmplt(S::from_f64(1e-8))) {
        return ([S::ONE, S::ZERO, S::ZERO], S::ZERO);
    }
    (times::<S, 3>(axis, S::ONE / length), S::TWO * length.atan2(q[3]))
}

/// At the identity, where the axis has no direction, the limit.
#[differentiable]
pub fn to_scaled_axis<S: Real>(q: Quaternion<S>) -> Triple<S> {
    let axis = [q[0], q[1], q[2]];
    let length = length::<S, 3>(axis);
    let is_small = holds(length.cmplt(S::from_f64(1e-8)));
    let scale = if is_small { S::TWO / q[3] } else { S::TWO * length.atan2(q[3]) / length };
    times::<S, 3>(axis, scale)
}

#[differentiable]
pub fn angle_of_turns<S: Real>(a: Quaternion<S>, b: Quaternion<S>) -> S {
    S::TWO * dot::<S, 4>(a, b).abs().acos()
}

#[differentiable]
pub fn wider<S: Real, const N: usize, const M: usize>(a: [[S; N]; N]) -> [[S; M]; M] {
    let mut wider = [[S::ZERO; M]; M];
    for i in 0..N {
        for j in 0..N {
            wider[i][j] = a[i][j];
        }
    }
    wider[N][N] = S::ONE;
    wider
}

#[differentiable]
pub fn narrower<S: Real>(a: [[S; 4]; 4]) -> Columns<S> {
    std::array::from_fn(|i| [a[i][0], a[i][1], a[i][2]])
}

#[differentiable]
pub fn motion_of_plane<S: Real>(scale: [S; 2], angle: S, translation: [S; 2]) -> Columns<S> {
    let [[a, b], [c, d], [x, y]] = affine_scale_turn_shift::<S>(scale, angle, translation);
    [[a, b, S::ZERO], [c, d, S::ZERO], [x, y, S::ONE]]
}

#[differentiable]
pub fn turn_of_plane<S: Real>(angle: S) -> Columns<S> {
    motion_of_plane::<S>([S::ONE; 2], angle, [S::ZERO; 2])
}

#[differentiable]
pub fn scale_of_plane<S: Real>(scale: [S; 2]) -> Columns<S> {
    motion_of_plane::<S>(scale, S::ZERO, [S::ZERO; 2])
}

#[differentiable]
pub fn shift_of_plane<S: Real>(translation: [S; 2]) -> Columns<S> {
    motion_of_plane::<S>([S::ONE; 2], S::ZERO, translation)
}

#[differentiable]
pub fn transform_vector<S: Real>(a: Columns<S>, v: [S; 2]) -> [S; 2] {
    std::array::from_fn(|i| a[0][i] * v[0] + a[1][i] * v[1])
}

#[differentiable]
pub fn transform_point<S: Real>(a: Columns<S>, v: [S; 2]) -> [S; 2] {
    std::array::from_fn(|i| a[0][i] * v[0] + a[1][i] * v[1] + a[2][i])
}

#[differentiable]
pub fn project_point<S: Real>(a: [[S; 4]; 4], v: Triple<S>) -> Triple<S> {
    let moved: [S; 4] =
        std::array::from_fn(|i| a[0][i] * v[0] + a[1][i] * v[1] + a[2][i] * v[2] + a[3][i]);
    [moved[0] / moved[3], moved[1] / moved[3], moved[2] / moved[3]]
}

#[differentiable]
pub fn scaled<S: Real, const N: usize>(a: [[S; N]; N], factor: S) -> [[S; N]; N] {
    std::array::from_fn(|i| times::<S, N>(a[i], factor))
}

#[differentiable]
pub fn quotient<S: Real, const N: usize>(a: [S; N], by: S) -> [S; N] {
    std::array::from_fn(|i| a[i] / by)
}

#[differentiable]
pub fn divided<S: Real, const N: usize>(a: [[S; N]; N], by: S) -> [[S; N]; N] {
    std::array::from_fn(|i| quotient::<S, N>(a[i], by))
}

/// The columns of a matrix of `N` columns, and a translation.
#[differentiable]
pub fn affine<S: Real, const N: usize, const M: usize>(
    linear: [[S; N]; N],
    translation: [S; N],
) -> [[S; N]; M] {
    let mut columns = [translation; M];
    for i in 0..N {
        columns[i] = linear[i];
    }
    columns
}

#[differentiable]
pub fn affine_of<S: Real, const N: usize, const M: usize>(linear: [[S; N]; N]) -> [[S; N]; M] {
    affine::<S, N, M>(linear, [S::ZERO; N])
}

#[differentiable]
pub fn affine_of_matrix<S: Real>(a: [[S; 4]; 4]) -> [Triple<S>; 4] {
    std::array::from_fn(|i| [a[i][0], a[i][1], a[i][2]])
}

#[differentiable]
pub fn affine_scale<S: Real, const N: usize, const M: usize>(scale: [S; N]) -> [[S; N]; M] {
    let mut columns = [[S::ZERO; N]; M];
    for i in 0..N {
        columns[i][i] = scale[i];
    }
    columns
}

#[differentiable]
pub fn affine_shift<S: Real, const N: usize, const M: usize>(translation: [S; N]) -> [[S; N]; M] {
    let mut columns = [translation; M];
    for i in 0..N {
        columns[i] = [S::ZERO; N];
        columns[i][i] = S::ONE;
    }
    columns
}

#[differentiable]
pub fn affine_scale_turn_shift<S: Real>(
    scale: [S; 2],
    angle: S,
    translation: [S; 2],
) -> [[S; 2]; 3] {
    let (sin, cos) = (angle.sin(), angle.cos());
    [[cos * scale[0], sin * scale[0]], [-sin * scale[1], cos * scale[1]], translation]
}

#[differentiable]
pub fn affine_turn_shift<S: Real>(angle: S, translation: [S; 2]) -> [[S; 2]; 3] {
    affine_scale_turn_shift::<S>([S::ONE; 2], angle, translation)
}

#[differentiable]
pub fn affine_turn<S: Real>(angle: S) -> [[S; 2]; 3] {
    affine_turn_shift::<S>(angle, [S::ZERO; 2])
}

#[differentiable]
pub fn affine_of_scale_turn_shift<S: Real>(
    scale: Triple<S>,
    turn: Quaternion<S>,
    translation: Triple<S>,
) -> [Triple<S>; 4] {
    let [x, y, z] = rotation::rotation_matrix::<S>(turn);
    [
        times::<S, 3>(x, scale[0]),
        times::<S, 3>(y, scale[1]),
        times::<S, 3>(z, scale[2]),
        translation,
    ]
}

#[differentiable]
pub fn affine_of_turn_shift<S: Real>(
    turn: Quaternion<S>,
    translation: Triple<S>,
) -> [Triple<S>; 4] {
    affine::<S, 3, 4>(rotation::rotation_matrix::<S>(turn), translation)
}

#[differentiable]
pub fn affine_of_turn<S: Real>(turn: Quaternion<S>) -> [Triple<S>; 4] {
    affine_of_turn_shift::<S>(turn, [S::ZERO; 3])
}

#[differentiable]
pub fn affine_about<S: Real>(axis: Triple<S>, angle: S) -> [Triple<S>; 4] {
    affine_of::<S, 3, 4>(rotation::axis_angle_matrix::<S>(axis, angle))
}

#[differentiable]
pub fn affine_about_x<S: Real>(angle: S) -> [Triple<S>; 4] {
    affine_about::<S>([S::ONE, S::ZERO, S::ZERO], angle)
}

#[differentiable]
pub fn affine_about_y<S: Real>(angle: S) -> [Triple<S>; 4] {
    affine_about::<S>([S::ZERO, S::ONE, S::ZERO], angle)
}

#[differentiable]
pub fn affine_about_z<S: Real>(angle: S) -> [Triple<S>; 4] {
    affine_about::<S>([S::ZERO, S::ZERO, S::ONE], angle)
}

#[differentiable]
pub fn affine_vector<S: Real, const N: usize, const M: usize>(a: [[S; N]; M], v: [S; N]) -> [S; N] {
    let mut sum = [S::ZERO; N];
    for i in 0..N {
        sum = plus::<S, N>(sum, times::<S, N>(a[i], v[i]));
    }
    sum
}

#[differentiable]
pub fn affine_point<S: Real, const N: usize, const M: usize>(a: [[S; N]; M], v: [S; N]) -> [S; N] {
    plus::<S, N>(affine_vector::<S, N, M>(a, v), a[N])
}

#[differentiable]
pub fn affine_product<S: Real, const N: usize, const M: usize>(
    a: [[S; N]; M],
    b: [[S; N]; M],
) -> [[S; N]; M] {
    let mut columns = [affine_point::<S, N, M>(a, b[N]); M];
    for i in 0..N {
        columns[i] = affine_vector::<S, N, M>(a, b[i]);
    }
    columns
}

#[differentiable]
pub fn affine_inverse2<S: Real>(a: [[S; 2]; 3]) -> [[S; 2]; 3] {
    let scale = S::ONE / perp_dot::<S>(a[0], a[1]);
    let linear = [[a[1][1] * scale, -a[0][1] * scale], [-a[1][0] * scale, a[0][0] * scale]];
    let moved = affine_vector::<S, 2, 3>(affine_of::<S, 2, 3>(linear), a[2]);
    affine::<S, 2, 3>(linear, [-moved[0], -moved[1]])
}

#[differentiable]
pub fn affine_inverse3<S: Real>(a: [Triple<S>; 4]) -> [Triple<S>; 4] {
    let [x, y, z, translation] = a;
    let rows = [cross::<S>(y, z), cross::<S>(z, x), cross::<S>(x, y)];
    let scale = S::ONE / dot::<S, 3>(x, rows[0]);
    let linear: Columns<S> =
        std::array::from_fn(|i| [rows[0][i] * scale, rows[1][i] * scale, rows[2][i] * scale]);
    let moved = affine_vector::<S, 3, 4>(affine_of::<S, 3, 4>(linear), translation);
    affine::<S, 3, 4>(linear, [-moved[0], -moved[1], -moved[2]])
}
