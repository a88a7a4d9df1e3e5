//! Rotations as quaternions and as matrices.

use super::vector::{combined, cross, dot, length, times, unit};
use super::{Columns, Quaternion, Triple, holds};
use crate::Real;

formulas! {
    product(a: Quaternion<S>, b: Quaternion<S>) -> Quaternion<S> = [
        a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
        a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
        a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3],
        a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2],
    ];
    /// A vector rotated as glam does: v (w² - b²) + 2 b (v·b) + 2 w (b × v), for the vector part b.
    rotated(q: Quaternion<S>, v: Triple<S>) -> Triple<S> = {
        let [x, y, z, w] = q;
        let b = [x, y, z];
        let along = S::TWO * dot::<S, 3>(v, b);
        let across = w * w - dot::<S, 3>(b, b);
        let turned = cross::<S>(b, v);
        combined::<S, 3, 3, 3>([v, b, turned], [across, along, w + w])
    };
    rotation_matrix(q: Quaternion<S>) -> Columns<S> = {
        let [x, y, z, w] = q;
        let (x2, y2, z2) = (x + x, y + y, z + z);
        [
            [S::ONE - (y * y2 + z * z2), x * y2 + w * z2, x * z2 - w * y2],
            [x * y2 - w * z2, S::ONE - (x * x2 + z * z2), y * z2 + w * x2],
            [x * z2 + w * y2, y * z2 - w * x2, S::ONE - (x * x2 + y * y2)],
        ]
    };
    /// The quaternion of the rotation with this matrix, by way of the number that glam chooses: it is not
    /// small.
    of_axes(x: Triple<S>, y: Triple<S>, z: Triple<S>) -> Quaternion<S> = {
        let (sx, sy, sz) = (y[2] + z[1], z[0] + x[2], x[1] + y[0]);
        let (dx, dy, dz) = (y[2] - z[1], z[0] - x[2], x[1] - y[0]);
        let (parts, square) = if holds(z[2].cmple(S::ZERO)) {
            let (rest, across) = (S::ONE - z[2], y[1] - x[0]);
            if holds(across.cmple(S::ZERO)) {
                ([rest - across, sz, sy, dx], rest - across)
            } else {
                ([sz, rest + across, sx, dy], rest + across)
            }
        } else {
            let (rest, along) = (S::ONE + z[2], y[1] + x[0]);
            if holds(along.cmple(S::ZERO)) {
                ([sy, sx, rest - along, dz], rest - along)
            } else {
                ([dx, dy, dz, rest + along], rest + along)
            }
        };
        times::<S, 4>(parts, S::HALF / square.sqrt())
    };
    of_matrix[N, M](a: [[S; N]; M]) -> Quaternion<S> = {
        let axis = |i: usize| [a[i][0], a[i][1], a[i][2]];
        of_axes::<S>(axis(0), axis(1), axis(2))
    };
    from_axis_angle(axis: Triple<S>, angle: S) -> Quaternion<S> = {
        let half = angle * S::HALF;
        let sin = half.sin();
        [axis[0] * sin, axis[1] * sin, axis[2] * sin, half.cos()]
    };
    /// The matrix of a rotation about an axis as glam computes it: not by way of a quaternion.
    axis_angle_matrix(axis: Triple<S>, angle: S) -> Columns<S> = {
        let (sin, cos) = (angle.sin(), angle.cos());
        let [x, y, z] = axis;
        let rest = S::ONE - cos;
        let (xy, xz, yz) = (x * y * rest, x * z * rest, y * z * rest);
        [
            [x * x * rest + cos, xy + z * sin, xz - y * sin],
            [xy - z * sin, y * y * rest + cos, yz + x * sin],
            [xz + y * sin, yz - x * sin, z * z * rest + cos],
        ]
    };
}

/// `-1` where the way from `a` to `b` is shorter to `-b`.
fn side<S: Real>(a: Quaternion<S>, b: Quaternion<S>) -> S {
    let cosine = (0..4).fold(S::ZERO, |sum, i| sum + a[i] * b[i]);
    S::select(cosine.cmplt(S::ZERO), -S::ONE, S::ONE)
}

formulas! {
    lerp(a: Quaternion<S>, b: Quaternion<S>, s: S) -> Quaternion<S> = {
        let side = crate::no_diff(|| side::<S>(a, b));
        unit::<S, 4>(combined::<S, 2, 4, 4>([a, b], [S::ONE - s, side * s]))
    };
    /// Along the arc, which has a length: where it has none, [`lerp`] is taken.
    slerp(a: Quaternion<S>, b: Quaternion<S>, s: S) -> Quaternion<S> = {
        let cosine = dot::<S, 4>(a, b);
        // The threshold of glam.
        if holds(cosine.abs().cmpgt(S::ONE - S::EPSILON)) {
            return lerp::<S>(a, b, s);
        }
        let side = crate::no_diff(|| side::<S>(a, b));
        let angle = (cosine * side).acos();
        let scale = S::ONE / angle.sin();
        let (to_a, to_b) = ((angle * (S::ONE - s)).sin() * scale, (angle * s).sin() * scale * side);
        combined::<S, 2, 4, 4>([a, b], [to_a, to_b])
    };
    about_x(angle: S) -> Quaternion<S> = from_axis_angle::<S>([S::ONE, S::ZERO, S::ZERO], angle);
    about_y(angle: S) -> Quaternion<S> = from_axis_angle::<S>([S::ZERO, S::ONE, S::ZERO], angle);
    about_z(angle: S) -> Quaternion<S> = from_axis_angle::<S>([S::ZERO, S::ZERO, S::ONE], angle);
    /// At 0, where the axis has no direction, the limit.
    from_scaled_axis(axis: Triple<S>) -> Quaternion<S> = {
        let angle = length::<S, 3>(axis);
        let half = angle * S::HALF;
        let scale = if holds(angle.cmpgt(S::ZERO)) { half.sin() / angle } else { S::HALF };
        let [x, y, z] = times::<S, 3>(axis, scale);
        [x, y, z, half.cos()]
    };
    from_rotation_arc(from: Triple<S>, to: Triple<S>) -> Quaternion<S> = {
        let [x, y, z] = cross::<S>(from, to);
        let arc = [x, y, z, S::ONE + dot::<S, 3>(from, to)];
        unit::<S, 4>(arc)
    };
    to_axis_angle(q: Quaternion<S>) -> (Triple<S>, S) = {
        let axis = [q[0], q[1], q[2]];
        let length = length::<S, 3>(axis);
        // The threshold of glam.
        if holds(length.cmplt(S::from_f64(1e-8))) {
            return ([S::ONE, S::ZERO, S::ZERO], S::ZERO);
        }
        (times::<S, 3>(axis, S::ONE / length), S::TWO * length.atan2(q[3]))
    };
    /// At the identity, where the axis has no direction, the limit.
    to_scaled_axis(q: Quaternion<S>) -> Triple<S> = {
        let axis = [q[0], q[1], q[2]];
        let length = length::<S, 3>(axis);
        let is_small = holds(length.cmplt(S::from_f64(1e-8)));
        let scale = if is_small { S::TWO / q[3] } else { S::TWO * length.atan2(q[3]) / length };
        times::<S, 3>(axis, scale)
    };
    /// The cosine of the same rotation twice may be rounded to more than 1.
    angle_between(a: Quaternion<S>, b: Quaternion<S>) -> S
        = S::TWO * dot::<S, 4>(a, b).abs().min(S::ONE).acos();
    rotate_axis(a: Triple<S>, axis: Triple<S>, angle: S) -> Triple<S>
        = rotated::<S>(from_axis_angle::<S>(axis, angle), a);
}
