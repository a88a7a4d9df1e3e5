//! The rules of the functions of one scalar and of several scalars.

use core::f64::consts::{LN_2, LOG2_E, LOG10_E};

use super::linear::{Factor, Maps, Negated, Same, Times, Where, Zero, unless};
use super::row::rules;
use super::{chain, is_infinite, scale};
use crate::{Mask, Real};

rules! {
    /// The rules of the methods of [`Real`].
    RealRules for every Real {
        /// The smaller one; a tie is the receiver's.
        min(x, y) = value => {
            let is_first = value.cmpeq(x);
            (Where(is_first), Where(!is_first))
        };
        /// The larger one; a tie is the receiver's.
        max(x, y) = value => {
            let is_first = value.cmpeq(x);
            (Where(is_first), Where(!is_first))
        };
        /// The receiver within the bounds and on them, else the bound.
        clamp(x, low, high) = value => {
            let (within, below) = (value.cmpeq(x), x.cmplt(low));
            (Where(within), Where(!within & below), Where(!within & !below))
        };
        abs(x) => Times(unless(x.cmpeq(Self::ZERO), x.signum()));
        signum(x) => Zero();
        floor(x) => Zero();
        /// By the magnitude 1 or -1 as the sign stays or flips (0 at 0), by the sign 0.
        copysign(x, sign) => {
            (Times(unless(x.cmpeq(Self::ZERO), x.signum() * sign.signum())), Zero())
        };
        /// 0 where 1/x is infinite.
        recip(x) = value => Times(unless(is_infinite(value), -value * value));
        mul_add(x, a, b) => (Factor(a), Factor(x), Same());
        sqrt(x) = root => Times(unless(root.cmpeq(Self::ZERO), Self::HALF / root));
        exp(x) = value => Times(value);
        ln(x) => Times(unless(x.cmpeq(Self::ZERO), x.recip()));
        /// At x = 0 and for negative x see [singular points](crate::rules#singular-points).
        powf(x, exponent) = value => {
            let (by_base, by_exponent) = power_partials(x, exponent, value);
            (Times(by_base), Times(by_exponent))
        };
        /// n x^(n-1); at 0: 1 for n = 1, else 0.
        powi(x, exponent: i32) -> Self = value => {
            let partial = match exponent {
                0 => Self::ZERO,
                // The exponent below the least one does not exist.
                i32::MIN => value / x * Self::from_f64(f64::from(exponent)),
                n => x.powi(n - 1) * Self::from_f64(f64::from(n)),
            };
            (Times(unless(x.cmpeq(Self::ZERO) & !partial.is_finite(), partial)), Zero())
        };
        sin(x) => Times(x.cos());
        cos(x) => Times(-x.sin());
        tan(x) = value => Times(Self::ONE + value * value);
        asin(x) => Times(arc_partial(x));
        acos(x) => Times(-arc_partial(x));
        atan(x) => Times((Self::ONE + x * x).recip());
        /// x/(x^2 + y^2) and -y/(x^2 + y^2); 0 at the origin and at infinity.
        atan2(y, x) => {
            // Divided by the larger coordinate first: the squares of tiny or huge ones would not
            // be representable.
            let size = x.abs().max(y.abs());
            let (v, u) = (y / size, x / size);
            let norm = (u * u + v * v) * size;
            let singular = size.cmpeq(Self::ZERO) | is_infinite(size);
            (Times(unless(singular, u / norm)), Times(unless(singular, -v / norm)))
        };
        tanh(x) = value => Times((Self::ONE - value) * (Self::ONE + value));
        /// The partial derivatives of `a * b - c * d`.
        difference_of_products(a: Self, b: Self, c: Self, d: Self) -> Self
            => (Factor(b), Factor(a), Negated(Factor(d)), Negated(Factor(c)));
    }
}

rules! {
    /// The rules of the methods that only `f32` and `f64` have.
    FloatRules: Real for f32 f64 {
        sin_cos(x) -> (Self, Self) = value => {
            let (sin, cos) = value;
            Maps(
                move |t| (chain(t, cos), -chain(t, sin)),
                move |(to_sin, to_cos)| scale(to_sin, cos) - scale(to_cos, sin),
            )
        };
        to_radians(x) -> Self: Self::to_radians;
        to_degrees(x) -> Self: Self::to_degrees;
        hypot(x, y) = norm => {
            (Times(unless(norm == 0.0, x / norm)), Times(unless(norm == 0.0, y / norm)))
        };
        midpoint(x, y) => (Factor(0.5), Factor(0.5));
        cbrt(x) = root => Times(unless(x == 0.0, 1.0 / (3.0 * root * root)));
        sinh(x) => Times(x.cosh());
        cosh(x) => Times(x.sinh());
        asinh(x) => Times(1.0 / x.hypot(1.0));
        /// 1/sqrt(x^2 - 1); 0 at 1. One root for each factor: their product might overflow.
        acosh(x) => Times(unless(x == 1.0, 1.0 / ((x - 1.0).sqrt() * (x + 1.0).sqrt())));
        atanh(x) => Times(unless(x.abs() == 1.0, 1.0 / ((1.0 - x) * (1.0 + x))));
        exp2(x) = value => Times(value * Self::from_f64(LN_2));
        exp_m1(x) => Times(x.exp());
        ln_1p(x) => Times(unless(x == -1.0, 1.0 / (1.0 + x)));
        log2(x) => Times(unless(x == 0.0, Self::from_f64(LOG2_E) / x));
        log10(x) => Times(unless(x == 0.0, Self::from_f64(LOG10_E) / x));
        /// 1/(x ln(b)) and -log(x)/(b ln(b)); 0 to both at x = 0, and where the base is 0 or 1.
        log(x, base) = value => {
            let singular = x == 0.0 || base == 0.0 || base == 1.0;
            let recip = 1.0 / base.ln();
            (Times(unless(singular, recip / x)), Times(unless(singular, -value * recip / base)))
        };
        /// The jumps carry no derivative.
        rem_euclid(x, y) = rest => (Same(), Times(-multiples(x, rest, y)));
        div_euclid(x, y) => (Zero(), Zero());
        ceil(x) => Zero();
        round(x) => Zero();
        round_ties_even(x) => Zero();
        trunc(x) => Zero();
        /// The jumps carry no derivative.
        fract(x) => Same();
    }
}

/// How many times the divisor was taken from `x` to leave `rest`. Rounding may make the quotient of the two
/// a whole number that is larger by one: 1 leaves almost .1 of ten times .1.
#[inline(always)]
pub(crate) fn multiples<S: Real>(x: S, rest: S, divisor: S) -> S {
    ((x - rest) / divisor + S::HALF).floor()
}

/// The derivative of `asin`; 0 at -1 and 1. 1 - x^2 as a product, which does not cancel near these.
#[inline(always)]
fn arc_partial<S: Real>(x: S) -> S {
    let root = ((S::ONE - x) * (S::ONE + x)).sqrt();
    unless(root.cmpeq(S::ZERO), root.recip())
}

/// The partial derivatives of `value = base ^ exponent` by base and exponent.
#[inline(always)]
pub(super) fn power_partials<S: Real>(base: S, exponent: S, value: S) -> (S, S) {
    // y x^(y-1) as y x^y / x spares a power; where x^y or y x^y has left the range of normal numbers
    // the quotient would not be accurate.
    let at_zero = base.cmpeq(S::ZERO);
    let quotient = exponent * value / base;
    let in_range = value.abs().cmpgt(S::MIN_POSITIVE) & quotient.is_finite() & !at_zero;
    let to_base = if in_range.all() {
        quotient
    } else {
        let singular = at_zero & exponent.cmplt(S::ONE);
        let power = chain(exponent, base.powf(exponent - S::ONE));
        S::select(in_range, quotient, S::select(singular, S::ZERO, power))
    };
    (to_base, unless(!base.cmpgt(S::ZERO), chain(base.ln(), value)))
}
