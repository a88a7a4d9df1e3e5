//! The rules of scalars.

use ad::Real;
use ad::rules::*;

use super::case::{
    Case, Flat, anywhere, apart, case, functions, negative, not_small, operators, positive,
};

/// The rules of every scalar.
pub fn cases<S: Real + Flat<S>>() -> Vec<Case<S>> {
    let mut cases = functions! {
        min(a: S, b: S) -> S, apart;
        max(a: S, b: S) -> S, apart;
        clamp(x: S, low: S, high: S) -> S, ordered_bounds;
        abs(a: S) -> S, not_small;
        signum(a: S) -> S, not_small;
        floor(a: S) -> S, between_integers;
        copysign(a: S, b: S) -> S, not_small;
        recip(a: S) -> S, not_small;
        mul_add(a: S, b: S, c: S) -> S, anywhere;
        [S] difference_of_products(a: S, b: S, c: S, d: S) -> S, anywhere;
        sqrt(a: S) -> S, positive;
        exp(a: S) -> S, anywhere;
        ln(a: S) -> S, positive;
        powf(a: S, b: S) -> S, positive;
        sin(a: S) -> S, anywhere;
        cos(a: S) -> S, anywhere;
        tan(a: S) -> S, half;
        asin(a: S) -> S, half;
        acos(a: S) -> S, half;
        atan(a: S) -> S, anywhere;
        atan2(a: S, b: S) -> S, not_small;
        tanh(a: S) -> S, anywhere;
    };
    cases.extend(operators! {
        S + S -> S, anywhere;
        S - S -> S, anywhere;
        S * S -> S, anywhere;
        S / S -> S, not_small;
    });
    cases.push(negative::<S, S>());
    cases.extend([
        power::<S, -3>("powi -3"),
        power::<S, -1>("powi -1"),
        power::<S, 0>("powi 0"),
        power::<S, 1>("powi 1"),
        power::<S, 2>("powi 2"),
        power::<S, 5>("powi 5"),
    ]);
    cases
}

fn power<S: Real + Flat<S>, const N: i32>(name: &'static str) -> Case<S> {
    case(
        name,
        not_small,
        |a: S| a.powi(N),
        |a, g| {
            let (value, pullback) = a.powi_vjp(N);
            (value, pullback(g).0)
        },
        |a, a_dot| a.powi_jvp(N, a_dot, ()),
    )
}

/// The rules of the methods and operators that only `f32` and `f64` have.
macro_rules! float_cases {
    ($($name:ident $type:ident)*) => {$(
        pub fn $name() -> Vec<Case<$type>> {
            type S = $type;
            let mut cases = functions! {
                sin_cos(a: S) -> (S, S), anywhere;
                to_radians(a: S) -> S, anywhere;
                to_degrees(a: S) -> S, anywhere;
                hypot(a: S, b: S) -> S, not_small;
                midpoint(a: S, b: S) -> S, anywhere;
                cbrt(a: S) -> S, not_small;
                sinh(a: S) -> S, anywhere;
                cosh(a: S) -> S, anywhere;
                asinh(a: S) -> S, anywhere;
                acosh(a: S) -> S, above_one;
                atanh(a: S) -> S, half;
                exp2(a: S) -> S, anywhere;
                exp_m1(a: S) -> S, anywhere;
                ln_1p(a: S) -> S, half;
                log2(a: S) -> S, positive;
                log10(a: S) -> S, positive;
                log(a: S, b: S) -> S, above_one;
                rem_euclid(a: S, b: S) -> S, away_from_jumps;
                div_euclid(a: S, b: S) -> S, away_from_jumps;
                ceil(a: S) -> S, off_integers;
                round(a: S) -> S, off_integers;
                round_ties_even(a: S) -> S, off_integers;
                trunc(a: S) -> S, off_integers;
                fract(a: S) -> S, off_integers;
            };
            cases.extend(operators! { S % S -> S, away_from_jumps; });
            cases.push(case(
                "cast",
                anywhere,
                |a: S| a,
                |a, g| {
                    let wide = CastPullback::<S>::cast_pullback(f64::from(a), g);
                    (a, CastPullback::<f64>::cast_pullback(a, wide))
                },
                |a, a_dot| {
                    let wide = CastPullback::<f64>::cast_pushforward(a, a_dot);
                    (a, CastPullback::<S>::cast_pushforward(f64::from(a), wide))
                },
            ));
            cases
        }
    )*};
}

float_cases! {
    single_float_cases f32
    double_float_cases f64
}

fn ordered_bounds(x: &mut [f64]) -> bool {
    let (low, high) = (x[1].min(x[2]), x[1].max(x[2]));
    (x[1], x[2]) = (low, high);
    high - low > 0.1 && (x[0] - low).abs() > 0.1 && (x[0] - high).abs() > 0.1
}

fn between_integers(x: &mut [f64]) -> bool {
    x[0] = x[0].floor() + 0.5;
    true
}

/// Where asin and acos are smooth, and tan is not steep.
fn half(x: &mut [f64]) -> bool {
    x[0] *= 0.45;
    true
}

fn away_from_jumps(x: &mut [f64]) -> bool {
    let moved = not_small(x);
    let quotient = x[0] / x[1];
    let slack = 0.05 * (1.0 + quotient.abs()) / x[1].abs();
    moved && (quotient - quotient.round()).abs() > slack
}

fn above_one(x: &mut [f64]) -> bool {
    x.iter_mut().for_each(|x| *x = x.abs() + 1.2);
    true
}

/// Off the integers and the halves between them.
fn off_integers(x: &mut [f64]) -> bool {
    x[0] = x[0].floor() + 0.25;
    true
}
