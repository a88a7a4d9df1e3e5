//! What glam computes with rotations, as formulas over any scalar: the rules of quaternions and
//! matrices take their pullbacks from these, and their values from glam.

use ad_macros::differentiable;

use crate::Real;

/// A quaternion: x, y, z, w.
pub type Quaternion<S> = [S; 4];

/// A vector.
pub type Triple<S> = [S; 3];

/// The columns of a matrix.
pub type Columns<S> = [[S; 3]; 3];

#[differentiable]
pub fn product<S: Real>(a: Quaternion<S>, b: Quaternion<S>) -> Quaternion<S> {
    [
        a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
        a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
        a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3],
        a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2],
    ]
}

#[differentiable]
fn dot<S: Real>(a: Triple<S>, b: Triple<S>) -> S {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// A vector rotated as glam does: v (w² - b²) + 2 b (v·b) + 2 w (b × v), for the vector part b.
#[differentiable]
pub fn rotated<S: Real>(q: Quaternion<S>, v: Triple<S>) -> Triple<S> {
    let [x, y, z, w] = q;
    let b = [x, y, z];
    let along = S::TWO * dot::<S>(v, b);
    let across = w * w - dot::<S>(b, b);
    let cross = [y * v[2] - z * v[1], z * v[0] - x * v[2], x * v[1] - y * v[0]];
    std::array::from_fn(|i| v[i] * across + b[i] * along + cross[i] * (w + w))
}

#[differentiable]
pub fn rotation_matrix<S: Real>(q: Quaternion<S>) -> Columns<S> {
    let [x, y, z, w] = q;
    let (x2, y2, z2) = (x + x, y + y, z + z);
    [
        [S::ONE - (y * y2 + z * z2), x * y2 + w * z2, x * z2 - w * y2],
        [x * y2 - w * z2, S::ONE - (x * x2 + z * z2), y * z2 + w * x2],
        [x * z2 + w * y2, y * z2 - w * x2, S::ONE - (x * x2 + y * y2)],
    ]
}

#[differentiable]
pub fn from_axis_angle<S: Real>(axis: Triple<S>, angle: S) -> Quaternion<S> {
    let half = angle * S::HALF;
    let sin = half.sin();
    [axis[0] * sin, axis[1] * sin, axis[2] * sin, half.cos()]
}

/// The matrix of a rotation about an axis as glam computes it: not by way of a quaternion.
#[differentiable]
pub fn axis_angle_matrix<S: Real>(axis: Triple<S>, angle: S) -> Columns<S> {
    let (sin, cos) = (angle.sin(), angle.cos());
    let [x, y, z] = axis;
    let rest = S::ONE - cos;
    let (xy, xz, yz) = (x * y * rest, x * z * rest, y * z * rest);
    [
        [x * x * rest + cos, xy + z * sin, xz - y * sin],
        [xy - z * sin, y * y * rest + cos, yz + x * sin],
        [xz + y * sin, yz - x * sin, z * z * rest + cos],
    ]
}

#[differentiable]
fn weighted<S: Real>(a: Quaternion<S>, b: Quaternion<S>, to_a: S, to_b: S) -> Quaternion<S> {
    std::array::from_fn(|i| a[i] * to_a + b[i] * to_b)
}

#[differentiable]
fn inner<S: Real>(a: Quaternion<S>, b: Quaternion<S>) -> S {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]
}

#[differentiable]
fn unit<S: Real>(q: Quaternion<S>) -> Quaternion<S> {
    let length = inner::<S>(q, q).sqrt();
    std::array::from_fn(|i| q[i] / length)
}

/// `-1` where the way from `a` to `b` is shorter to `-b`.
fn side<S: Real>(a: Quaternion<S>, b: Quaternion<S>) -> S {
    let cosine = (0..4).fold(S::ZERO, |sum, i| sum + a[i] * b[i]);
    S::select(cosine.cmplt(S::ZERO), -S::ONE, S::ONE)
}

#[differentiable]
pub fn lerp<S: Real>(a: Quaternion<S>, b: Quaternion<S>, s: S) -> Quaternion<S> {
    let side = crate::no_diff(|| side::<S>(a, b));
    unit::<S>(weighted::<S>(a, b, S::ONE - s, side * s))
}

/// Along the arc, which has a length: where it has none, [`lerp`] is taken.
#[differentiable]
pub fn slerp<S: Real>(a: Quaternion<S>, b: Quaternion<S>, s: S) -> Quaternion<S> {
    let side = crate::no_diff(|| side::<S>(a, b));
    let angle = (inner::<S>(a, b) * side).acos();
    let scale = S::ONE / angle.sin();
    let (to_a, to_b) = ((angle * (S::ONE - s)).sin() * scale, (angle * s).sin() * scale * side);
    weighted::<S>(a, b, to_a, to_b)
}
