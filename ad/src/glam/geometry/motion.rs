//! Motions of the plane and of space, as matrices of `M` columns of `N` numbers: `M = 2` or `3` without
//! a translation, and `N` by `N` with the last row of the identity, or without that row.

use ad_macros::differentiable;

use super::rotation::{axis_angle_matrix, of_axes, rotation_matrix};
use super::vector::{combined, cross, dot, length, perp_dot, quotient, times};
use super::{Columns, Quaternion, Triple, holds};
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

formulas! {
    plane[N, M](scale: [S; 2], angle: S, translation: [S; 2]) -> [[S; N]; M] = {
        let (sin, cos) = (angle.sin(), angle.cos());
        let (x, y) = ([cos * scale[0], sin * scale[0]], [-sin * scale[1], cos * scale[1]]);
        resized::<S, 2, 3, N, M>([x, y, translation])
    };
    from_scale_angle(scale: [S; 2], angle: S) -> [[S; 2]; 2]
        = plane::<S, 2, 2>(scale, angle, [S::ZERO; 2]);
    /// Scale, angle and translation; a reflection is one along x.
    plane_parts(a: [[S; 2]; 3]) -> ([S; 2], S, [S; 2]) = {
        let [x, y, translation] = a;
        let orientation = crate::no_diff(|| perp_dot::<S>(x, y).signum());
        let scale = [length::<S, 2>(x) * orientation, length::<S, 2>(y)];
        (scale, (-y[0]).atan2(y[1]), translation)
    };
    from_angle[N, M](angle: S) -> [[S; N]; M] = plane::<S, N, M>([S::ONE; 2], angle, [S::ZERO; 2]);
    from_angle_translation[N, M](angle: S, translation: [S; 2]) -> [[S; N]; M]
        = plane::<S, N, M>([S::ONE; 2], angle, translation);
    from_scale2[N, M]([x, y]: [S; 2]) -> [[S; N]; M]
        = resized::<S, 2, 2, N, M>([[x, S::ZERO], [S::ZERO, y]]);
    from_translation2[N, M](translation: [S; 2]) -> [[S; N]; M]
        = resized::<S, 2, 3, N, M>([[S::ONE, S::ZERO], [S::ZERO, S::ONE], translation]);
    moved2([x, y]: [[S; 2]; 2], translation: [S; 2]) -> [[S; 2]; 3] = [x, y, translation];
    transform_vector2[N](a: [[S; N]; 3], v: [S; 2]) -> [S; 2]
        = combined::<S, 3, N, 2>(a, [v[0], v[1], S::ZERO]);
    transform_point2[N](a: [[S; N]; 3], v: [S; 2]) -> [S; 2]
        = combined::<S, 3, N, 2>(a, [v[0], v[1], S::ONE]);
    from_scale3[N, M]([x, y, z]: Triple<S>) -> [[S; N]; M] = {
        let zero = S::ZERO;
        resized::<S, 3, 3, N, M>([[x, zero, zero], [zero, y, zero], [zero, zero, z]])
    };
    moved3[N, M]([x, y, z]: Columns<S>, translation: Triple<S>) -> [[S; N]; M]
        = resized::<S, 3, 4, N, M>([x, y, z, translation]);
    from_translation3[N, M](translation: Triple<S>) -> [[S; N]; M] = {
        let (zero, one) = (S::ZERO, S::ONE);
        moved3::<S, N, M>([[one, zero, zero], [zero, one, zero], [zero, zero, one]], translation)
    };
    from_quat[N, M](turn: Quaternion<S>) -> [[S; N]; M]
        = resized::<S, 3, 3, N, M>(rotation_matrix::<S>(turn));
    from_axis_angle[N, M](axis: Triple<S>, angle: S) -> [[S; N]; M]
        = resized::<S, 3, 3, N, M>(axis_angle_matrix::<S>(axis, angle));
    about_x[N, M](angle: S) -> [[S; N]; M]
        = from_axis_angle::<S, N, M>([S::ONE, S::ZERO, S::ZERO], angle);
    about_y[N, M](angle: S) -> [[S; N]; M]
        = from_axis_angle::<S, N, M>([S::ZERO, S::ONE, S::ZERO], angle);
    about_z[N, M](angle: S) -> [[S; N]; M]
        = from_axis_angle::<S, N, M>([S::ZERO, S::ZERO, S::ONE], angle);
    /// Scale, rotation and translation; a reflection is one along x.
    parts[N, M](a: [[S; N]; M]) -> (Triple<S>, Quaternion<S>, Triple<S>) = {
        let column = |i: usize| [a[i][0], a[i][1], a[i][2]];
        let (x, y, z) = (column(0), column(1), column(2));
        let orientation = crate::no_diff(|| dot::<S, 3>(x, cross::<S>(y, z)).signum());
        let scale = [
            length::<S, 3>(x) * orientation,
            length::<S, 3>(y),
            length::<S, 3>(z),
        ];
        let turn = of_axes::<S>(
            quotient::<S, 3>(x, scale[0]),
            quotient::<S, 3>(y, scale[1]),
            quotient::<S, 3>(z, scale[2]),
        );
        (scale, turn, column(3))
    };
    from_rotation_translation[N, M](turn: Quaternion<S>, translation: Triple<S>) -> [[S; N]; M]
        = moved3::<S, N, M>(rotation_matrix::<S>(turn), translation);
    from_scale_rotation_translation[N, M]
        (scale: Triple<S>, turn: Quaternion<S>, translation: Triple<S>) -> [[S; N]; M] = {
        let [x, y, z] = rotation_matrix::<S>(turn);
        let scaled =
            [times::<S, 3>(x, scale[0]), times::<S, 3>(y, scale[1]), times::<S, 3>(z, scale[2])];
        moved3::<S, N, M>(scaled, translation)
    };
    transform_vector3[N](a: [[S; N]; 4], v: Triple<S>) -> Triple<S>
        = combined::<S, 4, N, 3>(a, [v[0], v[1], v[2], S::ZERO]);
    transform_point3[N](a: [[S; N]; 4], v: Triple<S>) -> Triple<S>
        = combined::<S, 4, N, 3>(a, [v[0], v[1], v[2], S::ONE]);
    project_point3(a: [[S; 4]; 4], v: Triple<S>) -> Triple<S> = {
        let [x, y, z, w] = combined::<S, 4, 4, 4>(a, [v[0], v[1], v[2], S::ONE]);
        quotient::<S, 3>([x, y, z], w)
    };
    product2(a: [[S; 2]; 3], b: [[S; 2]; 3]) -> [[S; 2]; 3] = {
        let axis = |i: usize| transform_vector2::<S, 2>(a, b[i]);
        [axis(0), axis(1), transform_point2::<S, 2>(a, b[2])]
    };
    product3(a: [Triple<S>; 4], b: [Triple<S>; 4]) -> [Triple<S>; 4] = {
        let axis = |i: usize| transform_vector3::<S, 3>(a, b[i]);
        [axis(0), axis(1), axis(2), transform_point3::<S, 3>(a, b[3])]
    };
    /// 0 for 0: where there is no inverse nothing is pulled back.
    reciprocal(determinant: S) -> S
        = if holds(determinant.cmpeq(S::ZERO)) { S::ZERO } else { S::ONE / determinant };
    inverse2(a: [[S; 2]; 3]) -> [[S; 2]; 3] = {
        let scale = reciprocal::<S>(perp_dot::<S>(a[0], a[1]));
        let (x, y) = ([a[1][1] * scale, -a[0][1] * scale], [-a[1][0] * scale, a[0][0] * scale]);
        let moved = transform_vector2::<S, 2>([x, y, [S::ZERO; 2]], a[2]);
        [x, y, [-moved[0], -moved[1]]]
    };
    inverse3(a: [Triple<S>; 4]) -> [Triple<S>; 4] = {
        let [x, y, z, translation] = a;
        let rows = [cross::<S>(y, z), cross::<S>(z, x), cross::<S>(x, y)];
        let scale = reciprocal::<S>(dot::<S, 3>(x, rows[0]));
        let axis = |i: usize| times::<S, 3>([rows[0][i], rows[1][i], rows[2][i]], scale);
        let linear = [axis(0), axis(1), axis(2), [S::ZERO; 3]];
        let moved = times::<S, 3>(transform_vector3::<S, 3>(linear, translation), -S::ONE);
        [linear[0], linear[1], linear[2], moved]
    };
}
