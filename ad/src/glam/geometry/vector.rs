//! Vectors.
//!
//! What runs over the elements has rules of its own: a generated pullback would keep each step of a loop
//! whose length only the type tells on the heap.

#![allow(clippy::needless_range_loop, reason = "elements by their numbers")]

use ad_macros::differentiable;

use super::{Triple, holds};
use crate::rules::{chain, scale};
use crate::{Mask, Real};

#[differentiable(vjp = dot_vjp, jvp = dot_jvp)]
pub fn dot<S: Real, const N: usize>(a: [S; N], b: [S; N]) -> S {
    (0..N).fold(S::ZERO, |sum, i| sum + a[i] * b[i])
}

#[inline(always)]
fn dot_vjp<S: Real, const N: usize>(
    a: [S; N],
    b: [S; N],
) -> (S, impl FnOnce(S) -> ([S; N], [S; N])) {
    (dot(a, b), move |g| (b.map(|b| scale(g, b)), a.map(|a| scale(g, a))))
}

#[inline(always)]
fn dot_jvp<S: Real, const N: usize>(a: [S; N], b: [S; N], a_dot: [S; N], b_dot: [S; N]) -> (S, S) {
    let along = |sum, i| sum + chain(a_dot[i], b[i]) + chain(b_dot[i], a[i]);
    (dot(a, b), (0..N).fold(S::ZERO, along))
}

/// The first `R` numbers of the sum of columns, each times its weight.
#[differentiable(vjp = combined_vjp, jvp = combined_jvp)]
pub fn combined<S: Real, const C: usize, const N: usize, const R: usize>(
    columns: [[S; N]; C],
    weights: [S; C],
) -> [S; R] {
    std::array::from_fn(|j| (0..C).fold(S::ZERO, |sum, i| sum + columns[i][j] * weights[i]))
}

#[inline(always)]
fn combined_vjp<S: Real, const C: usize, const N: usize, const R: usize>(
    columns: [[S; N]; C],
    weights: [S; C],
) -> ([S; R], impl FnOnce([S; R]) -> ([[S; N]; C], [S; C])) {
    (combined(columns, weights), move |g| {
        let to_number = |i: usize, j| g.get(j).map_or(S::zero(), |&g| scale(g, weights[i]));
        let to_weight =
            |i: usize| (0..R).fold(S::zero(), |sum, j| sum + scale(g[j], columns[i][j]));
        let to_column = |i| std::array::from_fn(|j| to_number(i, j));
        (std::array::from_fn(to_column), std::array::from_fn(to_weight))
    })
}

#[inline(always)]
fn combined_jvp<S: Real, const C: usize, const N: usize, const R: usize>(
    columns: [[S; N]; C],
    weights: [S; C],
    columns_dot: [[S; N]; C],
    weights_dot: [S; C],
) -> ([S; R], [S; R]) {
    let sum = |term: &dyn Fn(usize, usize) -> S| {
        std::array::from_fn(|j| (0..C).fold(S::zero(), |sum, i| sum + term(i, j)))
    };
    // Only where zero meets what is infinite or NaN the comparisons with zero count.
    let plain: [S; R] =
        sum(&|i, j| columns_dot[i][j] * weights[i] + weights_dot[i] * columns[i][j]);
    let along = match plain.iter().all(|along| along.is_finite().all()) {
        true => plain,
        false => {
            sum(&|i, j| chain(columns_dot[i][j], weights[i]) + chain(weights_dot[i], columns[i][j]))
        }
    };
    (combined(columns, weights), along)
}

formulas! {
    times[N](a: [S; N], factor: S) -> [S; N] = combined::<S, 1, N, N>([a], [factor]);
    plus[N](a: [S; N], b: [S; N]) -> [S; N] = combined::<S, 2, N, N>([a, b], [S::ONE, S::ONE]);
    minus[N](a: [S; N], b: [S; N]) -> [S; N] = combined::<S, 2, N, N>([a, b], [S::ONE, -S::ONE]);
}

#[differentiable(vjp = quotient_vjp, jvp = quotient_jvp)]
pub fn quotient<S: Real, const N: usize>(a: [S; N], by: S) -> [S; N] {
    a.map(|a| a / by)
}

#[inline(always)]
fn quotient_vjp<S: Real, const N: usize>(
    a: [S; N],
    by: S,
) -> ([S; N], impl FnOnce([S; N]) -> ([S; N], S)) {
    (quotient(a, by), move |g| {
        let parts: [(S, S); N] = std::array::from_fn(|i| a[i].div_pullback(by, g[i]));
        let to_divisor = parts.iter().fold(S::zero(), |sum, (_, to_divisor)| sum + *to_divisor);
        (parts.map(|(to_element, _)| to_element), to_divisor)
    })
}

#[inline(always)]
fn quotient_jvp<S: Real, const N: usize>(
    a: [S; N],
    by: S,
    a_dot: [S; N],
    by_dot: S,
) -> ([S; N], [S; N]) {
    (quotient(a, by), std::array::from_fn(|i| a[i].div_jvp(by, a_dot[i], by_dot).1))
}

formulas! {
    length[N](a: [S; N]) -> S = dot::<S, N>(a, a).sqrt();
    length_recip[N](a: [S; N]) -> S = S::ONE / length::<S, N>(a);
    element_product[N](a: [S; N]) -> S = {
        let mut product = S::ONE;
        for i in 0..N {
            product *= a[i];
        }
        product
    };
    length_squared[N](a: [S; N]) -> S = dot::<S, N>(a, a);
    /// At 0 the quotients are 0.
    unit[N](a: [S; N]) -> [S; N] = quotient::<S, N>(a, length::<S, N>(a));
    /// The first axis and 0 where there is no direction, without derivative.
    unit_and_length[N](a: [S; N]) -> ([S; N], S) = {
        let length = length::<S, N>(a);
        if holds(length.cmpgt(S::ZERO)) {
            return (times::<S, N>(a, S::ONE / length), length);
        }
        let mut first = [S::ZERO; N];
        first[0] = S::ONE;
        (first, S::ZERO)
    };
    normalize_or[N](a: [S; N], fallback: [S; N]) -> [S; N] = {
        let length = length::<S, N>(a);
        if holds(length.cmpgt(S::ZERO)) { times::<S, N>(a, S::ONE / length) } else { fallback }
    };
    reject_from[N](a: [S; N], onto: [S; N]) -> [S; N] = {
        let share = dot::<S, N>(a, onto) / dot::<S, N>(onto, onto);
        minus::<S, N>(a, times::<S, N>(onto, share))
    };
    /// 0 to both where there is nothing to project onto.
    project_onto[N](a: [S; N], onto: [S; N]) -> [S; N] = {
        let square = dot::<S, N>(onto, onto);
        if holds(square.cmpeq(S::ZERO)) {
            return [S::ZERO; N];
        }
        times::<S, N>(onto, dot::<S, N>(a, onto) / square)
    };
    project_onto_normalized[N](a: [S; N], onto: [S; N]) -> [S; N]
        = times::<S, N>(onto, dot::<S, N>(a, onto));
    reject_from_normalized[N](a: [S; N], onto: [S; N]) -> [S; N]
        = minus::<S, N>(a, project_onto_normalized::<S, N>(a, onto));
    clamp_length_min[N](a: [S; N], min: S) -> [S; N] = {
        let length = length::<S, N>(a);
        if holds(length.cmplt(min)) { times::<S, N>(a, min / length) } else { a }
    };
    clamp_length_max[N](a: [S; N], max: S) -> [S; N] = {
        let length = length::<S, N>(a);
        if holds(length.cmpgt(max)) { times::<S, N>(a, max / length) } else { a }
    };
    clamp_length[N](a: [S; N], min: S, max: S) -> [S; N]
        = clamp_length_max::<S, N>(clamp_length_min::<S, N>(a, min), max);
    move_towards[N](a: [S; N], end: [S; N], way: S) -> [S; N] = {
        let apart = minus::<S, N>(end, a);
        let length = length::<S, N>(apart);
        // The threshold of glam.
        if holds(length.cmple(way) | length.cmple(S::from_f64(1e-4))) {
            return end;
        }
        plus::<S, N>(a, times::<S, N>(apart, way / length))
    };
    refract[N](a: [S; N], normal: [S; N], eta: S) -> [S; N] = {
        let cosine = dot::<S, N>(normal, a);
        let k = S::ONE - eta * eta * (S::ONE - cosine * cosine);
        if holds(k.cmplt(S::ZERO)) {
            return [S::ZERO; N];
        }
        minus::<S, N>(times::<S, N>(a, eta), times::<S, N>(normal, eta * cosine + k.sqrt()))
    };
    direction(angle: S) -> [S; 2] = [angle.cos(), angle.sin()];
    to_angle(a: [S; 2]) -> S = a[1].atan2(a[0]);
    perp(a: [S; 2]) -> [S; 2] = [-a[1], a[0]];
    perp_dot(a: [S; 2], b: [S; 2]) -> S = a[0] * b[1] - a[1] * b[0];
    angle_to(a: [S; 2], b: [S; 2]) -> S = perp_dot::<S>(a, b).atan2(dot::<S, 2>(a, b));
    rotate(a: [S; 2], b: [S; 2]) -> [S; 2] = [a[0] * b[0] - a[1] * b[1], a[1] * b[0] + a[0] * b[1]];
    rotate_angle(a: [S; 2], angle: S) -> [S; 2] = rotate::<S>(a, direction::<S>(angle));
    /// By a negative angle away from `b`, no further than to its opposite.
    rotate_towards(a: [S; 2], b: [S; 2], most: S) -> [S; 2] = {
        let angle = angle_to::<S>(a, b);
        let side = crate::no_diff(|| angle.signum());
        rotate_angle::<S>(a, most.clamp(angle * side - S::PI, angle * side) * side)
    };
    cross(a: Triple<S>, b: Triple<S>) -> Triple<S>
        = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    angle_between(a: Triple<S>, b: Triple<S>) -> S
        = length::<S, 3>(cross::<S>(a, b)).atan2(dot::<S, 3>(a, b));
    angle_about(a: Triple<S>, b: Triple<S>, axis: Triple<S>) -> S
        = dot::<S, 3>(cross::<S>(a, b), axis).atan2(dot::<S, 3>(a, b));
    /// Along the cross product with x or y, whichever is more across.
    any_orthogonal(a: Triple<S>) -> Triple<S> = match holds(a[0].abs().cmpgt(a[1].abs())) {
        true => [-a[2], S::ZERO, a[0]],
        false => [S::ZERO, a[2], -a[1]],
    };
    /// The basis of Duff et al., "Building an Orthonormal Basis, Revisited", 2017; the sign of z is not
    /// differentiated.
    any_orthonormal_pair(a: Triple<S>) -> (Triple<S>, Triple<S>) = {
        let sign = crate::no_diff(|| a[2].signum());
        let p = -S::ONE / (sign + a[2]);
        let q = a[0] * a[1] * p;
        (
            [S::ONE + sign * a[0] * a[0] * p, sign * q, -sign * a[0]],
            [q, sign + a[1] * a[1] * p, -a[1]],
        )
    };
    any_orthonormal(a: Triple<S>) -> Triple<S> = any_orthonormal_pair::<S>(a).1;
    from_homogeneous(a: [S; 4]) -> Triple<S> = quotient::<S, 3>([a[0], a[1], a[2]], a[3]);
    rotate_x(a: Triple<S>, angle: S) -> Triple<S> = {
        let [y, z] = rotate_angle::<S>([a[1], a[2]], angle);
        [a[0], y, z]
    };
    rotate_y(a: Triple<S>, angle: S) -> Triple<S> = {
        let [z, x] = rotate_angle::<S>([a[2], a[0]], angle);
        [x, a[1], z]
    };
    rotate_z(a: Triple<S>, angle: S) -> Triple<S> = {
        let [x, y] = rotate_angle::<S>([a[0], a[1]], angle);
        [x, y, a[2]]
    };
}
