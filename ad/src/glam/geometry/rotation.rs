//! Rotations as quaternions and as matrices.

use super::vector::{self, any_orthogonal, combined, cross, dot, length, minus, times, unit};
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
        let (to_a, to_b) = on_the_arc::<S>(cosine * side, s);
        combined::<S, 2, 4, 4>([a, b], [to_a, to_b * side])
    };
    /// The weights of the ends of an arc a part `s` of the way along it, by the cosine of its angle.
    on_the_arc(cosine: S, s: S) -> (S, S) = {
        let angle = cosine.acos();
        let scale = S::ONE / angle.sin();
        ((angle * (S::ONE - s)).sin() * scale, (angle * s).sin() * scale)
    };
    /// Along the arc from one to the other, be it the shorter one or not.
    slerp_long(a: Quaternion<S>, b: Quaternion<S>, s: S) -> Quaternion<S> = {
        let cosine = dot::<S, 4>(a, b);
        // The threshold of glam.
        if holds(cosine.abs().cmpgt(S::ONE - S::EPSILON)) {
            return unit::<S, 4>(combined::<S, 2, 4, 4>([a, b], [S::ONE - s, s]));
        }
        let (to_a, to_b) = on_the_arc::<S>(cosine, s);
        combined::<S, 2, 4, 4>([a, b], [to_a, to_b])
    };
    /// By a negative angle away from `b`, no further than to its opposite.
    towards(a: Quaternion<S>, b: Quaternion<S>, most: S) -> Quaternion<S> = {
        let away = holds(most.cmplt(S::ZERO));
        let apart = angle_between::<S>(a, b);
        // The threshold of glam.
        let threshold = S::from_f64(1e-4);
        if holds(apart.cmple(threshold)) {
            return b;
        }
        if !away {
            return slerp::<S>(a, b, (most / apart).clamp(S::ZERO, S::ONE));
        }
        let opposite = unit::<S, 4>(minus::<S, 4>(a, times::<S, 4>(b, dot::<S, 4>(a, b))));
        let apart = angle_between::<S>(a, opposite);
        if holds(apart.cmple(threshold)) {
            return opposite;
        }
        slerp::<S>(a, opposite, (-most / apart).clamp(S::ZERO, S::ONE))
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
    from_rotation_arc_colinear(from: Triple<S>, to: Triple<S>) -> Quaternion<S> = {
        let is_opposite = holds(dot::<S, 3>(from, to).cmplt(S::ZERO));
        from_rotation_arc::<S>(from, if is_opposite { [-to[0], -to[1], -to[2]] } else { to })
    };
    from_rotation_arc_2d(from: [S; 2], to: [S; 2]) -> Quaternion<S> = from_rotation_arc::<S>(
        [from[0], from[1], S::ZERO],
        [to[0], to[1], S::ZERO],
    );
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
    /// By a negative angle away from `b`, no further than to its opposite.
    vector_towards(a: Triple<S>, b: Triple<S>, most: S) -> Triple<S> = {
        let apart = vector::angle_between::<S>(a, b);
        let across = cross::<S>(a, b);
        let is_certain = holds(length::<S, 3>(across).cmpgt(S::ZERO));
        let axis = unit::<S, 3>(if is_certain { across } else { any_orthogonal::<S>(a) });
        rotate_axis::<S>(a, axis, most.clamp(apart - S::PI, apart))
    };
    /// Along the arc, with the length that lies between those of the ends.
    slerp_vectors(a: Triple<S>, b: Triple<S>, s: S) -> Triple<S> = {
        let (from, to) = (length::<S, 3>(a), length::<S, 3>(b));
        let between = from + (to - from) * s;
        let cosine = dot::<S, 3>(a, b) / (from * to);
        // The threshold of glam.
        if holds(cosine.abs().cmplt(S::from_f64(1.0 - 3e-7))) {
            let (to_a, to_b) = on_the_arc::<S>(cosine, s);
            let weights = [between / from * to_a, between / to * to_b];
            return combined::<S, 2, 3, 3>([a, b], weights);
        }
        if holds(cosine.cmplt(S::ZERO)) {
            let axis = unit::<S, 3>(any_orthogonal::<S>(a));
            return times::<S, 3>(rotate_axis::<S>(a, axis, S::PI * s), between / from);
        }
        combined::<S, 2, 3, 3>([a, b], [S::ONE - s, s])
    };
}
