//! The rules of scalars.

use ad::rules::*;
use ad::{Real, Scalar};

use super::case::{Case, Flat, anywhere, apart, call, not_small, positive, rule};

/// The rules of every scalar.
pub fn cases<S: Real + Flat<S>>() -> Vec<Case<S>> {
    vec![
        rule!("neg" anywhere, (a: S) -> S, -a, |g| (-a, S::neg_pullback(&Default::default(), g))),
        rule!("add" anywhere, (a: S, b: S) -> S, a + b, |g| (a + b, S::add_pullback(&Default::default(), g))),
        rule!("sub" anywhere, (a: S, b: S) -> S, a - b, |g| (a - b, S::sub_pullback(&Default::default(), g))),
        rule!("mul" anywhere, (a: S, b: S) -> S, a * b, |g| (a * b, a.mul_pullback(b, g))),
        rule!("div" not_small, (a: S, b: S) -> S, a / b, |g| (a / b, a.div_pullback(b, g))),
        rule!("min" apart, (a: S, b: S) -> S, a.min(b), |g| call!(a.min_vjp(b), g)),
        rule!("max" apart, (a: S, b: S) -> S, a.max(b), |g| call!(a.max_vjp(b), g)),
        rule!("clamp" ordered_bounds, (x: S, low: S, high: S) -> S,
            x.clamp(low, high), |g| call!(x.clamp_vjp(low, high), g)),
        rule!("abs" not_small, (a: S) -> S, a.abs(), |g| call!(a.abs_vjp(), g)),
        rule!("signum" not_small, (a: S) -> S, a.signum(), |g| call!(a.signum_vjp(), g)),
        rule!("floor" between_integers, (a: S) -> S, a.floor(), |g| call!(a.floor_vjp(), g)),
        rule!("copysign" not_small, (a: S, b: S) -> S,
            a.copysign(b), |g| call!(a.copysign_vjp(b), g)),
        rule!("recip" not_small, (a: S) -> S, a.recip(), |g| call!(a.recip_vjp(), g)),
        rule!("mul_add" anywhere, (a: S, b: S, c: S) -> S,
            a.mul_add(b, c), |g| call!(a.mul_add_vjp(b, c), g)),
        rule!("difference_of_products" anywhere, (a: S, b: S, c: S, d: S) -> S,
            S::difference_of_products(a, b, c, d),
            |g| call!(S::difference_of_products_vjp(a, b, c, d), g)),
        rule!("sqrt" positive, (a: S) -> S, a.sqrt(), |g| call!(a.sqrt_vjp(), g)),
        rule!("exp" anywhere, (a: S) -> S, a.exp(), |g| call!(a.exp_vjp(), g)),
        rule!("ln" positive, (a: S) -> S, a.ln(), |g| call!(a.ln_vjp(), g)),
        rule!("powf" positive, (a: S, b: S) -> S, a.powf(b), |g| call!(a.powf_vjp(b), g)),
        power::<S, -3>("powi -3"),
        power::<S, -1>("powi -1"),
        power::<S, 0>("powi 0"),
        power::<S, 1>("powi 1"),
        power::<S, 2>("powi 2"),
        power::<S, 5>("powi 5"),
        rule!("sin" anywhere, (a: S) -> S, a.sin(), |g| call!(a.sin_vjp(), g)),
        rule!("cos" anywhere, (a: S) -> S, a.cos(), |g| call!(a.cos_vjp(), g)),
        rule!("tan" half, (a: S) -> S, a.tan(), |g| call!(a.tan_vjp(), g)),
        rule!("asin" half, (a: S) -> S, a.asin(), |g| call!(a.asin_vjp(), g)),
        rule!("acos" half, (a: S) -> S, a.acos(), |g| call!(a.acos_vjp(), g)),
        rule!("atan" anywhere, (a: S) -> S, a.atan(), |g| call!(a.atan_vjp(), g)),
        rule!("atan2" not_small, (a: S, b: S) -> S, a.atan2(b), |g| call!(a.atan2_vjp(b), g)),
        rule!("tanh" anywhere, (a: S) -> S, a.tanh(), |g| call!(a.tanh_vjp(), g)),
    ]
}

fn power<S: Real + Flat<S>, const N: i32>(name: &'static str) -> Case<S> {
    super::case::case(
        name,
        not_small,
        |a: S| a.powi(N),
        |a, g| {
            let (value, pullback) = a.powi_vjp(N);
            (value, pullback(g).0)
        },
    )
}

/// The rules of what only single numbers have. The methods are those of the primitive types.
pub fn single_number_cases<S: Primitive>() -> Vec<Case<S>> {
    vec![
        rule!("sin_cos" anywhere, (a: S) -> (S, S),
            a.plain_sin_cos(), |g| call!(a.sin_cos_vjp(), g)),
        rule!("to_radians" anywhere, (a: S) -> S,
            a.plain_to_radians(), |g| call!(a.to_radians_vjp(), g)),
        rule!("to_degrees" anywhere, (a: S) -> S,
            a.plain_to_degrees(), |g| call!(a.to_degrees_vjp(), g)),
        rule!("rem" away_from_jumps, (a: S, b: S) -> S,
            a.plain_rem(b), |g| (a.plain_rem(b), a.plain_rem_pullback(b, g))),
        rule!("cast" anywhere, (a: S) -> S, a, |g| (a, a.cast_there_and_back(g))),
    ]
}

/// What `f32` and `f64` have beyond [`Scalar`].
pub trait Primitive: Scalar + FloatRules + Flat<Self> {
    fn plain_sin_cos(self) -> (Self, Self);
    fn plain_to_radians(self) -> Self;
    fn plain_to_degrees(self) -> Self;
    fn plain_rem(self, other: Self) -> Self;
    fn plain_rem_pullback(self, other: Self, cotangent: Self) -> (Self, Self);
    /// The pullbacks of the casts to `f64` and from there to this type.
    fn cast_there_and_back(self, cotangent: Self) -> Self;
}

macro_rules! primitive {
    ($($type:ident)*) => {$(
        impl Primitive for $type {
            fn plain_sin_cos(self) -> (Self, Self) {
                self.sin_cos()
            }

            fn plain_to_radians(self) -> Self {
                self.to_radians()
            }

            fn plain_to_degrees(self) -> Self {
                self.to_degrees()
            }

            fn plain_rem(self, other: Self) -> Self {
                self % other
            }

            fn plain_rem_pullback(self, other: Self, cotangent: Self) -> (Self, Self) {
                self.rem_pullback(other, cotangent)
            }

            fn cast_there_and_back(self, cotangent: Self) -> Self {
                let wide = CastPullback::<$type>::cast_pullback(f64::from(self), cotangent);
                CastPullback::<f64>::cast_pullback(self, wide)
            }
        }
    )*};
}

primitive!(f32 f64);

/// The rules of the methods of primitive types, each with the plain method of the same name.
macro_rules! float_cases {
    ($function:ident $type:ident: $($name:ident $vjp:ident $domain:ident ($($x:ident),*);)*) => {
        pub fn $function() -> Vec<Case<$type>> {
            type S = $type;
            vec![$(
                rule!((stringify!($name)) $domain, ($($x: S),*) -> S,
                    $type::$name($($x),*), |g| call!($type::$vjp($($x),*), g)),
            )*]
        }
    };
}

macro_rules! all_float_cases {
    ($($function:ident $type:ident)*) => {$(
        float_cases! {
            $function $type:
            hypot hypot_vjp not_small (a, b);
            midpoint midpoint_vjp anywhere (a, b);
            cbrt cbrt_vjp not_small (a);
            sinh sinh_vjp anywhere (a);
            cosh cosh_vjp anywhere (a);
            asinh asinh_vjp anywhere (a);
            acosh acosh_vjp above_one (a);
            atanh atanh_vjp half (a);
            exp2 exp2_vjp anywhere (a);
            exp_m1 exp_m1_vjp anywhere (a);
            ln_1p ln_1p_vjp half (a);
            log2 log2_vjp positive (a);
            log10 log10_vjp positive (a);
            log log_vjp above_one (a, b);
            rem_euclid rem_euclid_vjp away_from_jumps (a, b);
            div_euclid div_euclid_vjp away_from_jumps (a, b);
            ceil ceil_vjp off_integers (a);
            round round_vjp off_integers (a);
            round_ties_even round_ties_even_vjp off_integers (a);
            trunc trunc_vjp off_integers (a);
            fract fract_vjp off_integers (a);
        }
    )*};
}

all_float_cases! {
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
