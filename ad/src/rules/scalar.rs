//! Derivatives of the functions of one scalar and of pairs of scalars.

use super::{chain, is_infinite, scale};
use crate::{Mask, Real, Scalar};

/// The `_vjp` siblings of the methods of [`Real`].
pub trait RealRules: Real {
    /// The smaller one's cotangent; a tie is the receiver's.
    #[inline(always)]
    fn min_vjp(self, other: Self) -> (Self, impl FnOnce(Self) -> (Self, Self)) {
        let value = self.min(other);
        (value, move |g| route(value.cmpeq(self), g))
    }

    /// The larger one's cotangent; a tie is the receiver's.
    #[inline(always)]
    fn max_vjp(self, other: Self) -> (Self, impl FnOnce(Self) -> (Self, Self)) {
        let value = self.max(other);
        (value, move |g| route(value.cmpeq(self), g))
    }

    /// The receiver's within the bounds and on them, else the bound's.
    #[inline(always)]
    fn clamp_vjp(self, low: Self, high: Self) -> (Self, impl FnOnce(Self) -> (Self, Self, Self)) {
        let value = self.clamp(low, high);
        (value, move |g| {
            let (to_self, outside) = route(value.cmpeq(self), g);
            let (to_low, to_high) = route(self.cmplt(low), outside);
            (to_self, to_low, to_high)
        })
    }

    /// sign(x); 0 at 0.
    #[inline(always)]
    fn abs_vjp(self) -> (Self, impl FnOnce(Self) -> Self) {
        (self.abs(), move |g| regular(!self.cmpeq(Self::ZERO), g, self.signum()))
    }

    /// 0
    #[inline(always)]
    fn signum_vjp(self) -> (Self, impl FnOnce(Self) -> Self) {
        (self.signum(), |_| Self::zero())
    }

    /// 0
    #[inline(always)]
    fn floor_vjp(self) -> (Self, impl FnOnce(Self) -> Self) {
        (self.floor(), |_| Self::zero())
    }

    /// To the magnitude 1 or -1 as the sign stays or flips (0 at 0), to the sign 0.
    #[inline(always)]
    fn copysign_vjp(self, sign: Self) -> (Self, impl FnOnce(Self) -> (Self, Self)) {
        (self.copysign(sign), move |g| {
            let flip = self.signum() * sign.signum();
            (regular(!self.cmpeq(Self::ZERO), g, flip), Self::zero())
        })
    }

    /// -1/x^2; 0 where 1/x is infinite.
    #[inline(always)]
    fn recip_vjp(self) -> (Self, impl FnOnce(Self) -> Self) {
        let value = self.recip();
        (value, move |g| regular(!is_infinite(value), g, -value * value))
    }

    /// The cotangents of both factors and the summand.
    #[inline(always)]
    fn mul_add_vjp(self, a: Self, b: Self) -> (Self, impl FnOnce(Self) -> (Self, Self, Self)) {
        (self.mul_add(a, b), move |g| (scale(g, a), scale(g, self), g))
    }

    /// The cotangents of `a`, `b`, `c`, `d` in `a * b - c * d`.
    #[inline(always)]
    fn difference_of_products_vjp(
        a: Self,
        b: Self,
        c: Self,
        d: Self,
    ) -> (Self, impl FnOnce(Self) -> (Self, Self, Self, Self)) {
        (Self::difference_of_products(a, b, c, d), move |g| {
            (scale(g, b), scale(g, a), -scale(g, d), -scale(g, c))
        })
    }

    /// 1/(2 sqrt(x)); 0 at 0.
    #[inline(always)]
    fn sqrt_vjp(self) -> (Self, impl FnOnce(Self) -> Self) {
        let root = self.sqrt();
        (root, move |g| regular(!root.cmpeq(Self::ZERO), g, Self::HALF / root))
    }

    /// exp(x)
    #[inline(always)]
    fn exp_vjp(self) -> (Self, impl FnOnce(Self) -> Self) {
        let value = self.exp();
        (value, move |g| chain(g, value))
    }

    /// 1/x; 0 at 0.
    #[inline(always)]
    fn ln_vjp(self) -> (Self, impl FnOnce(Self) -> Self) {
        (self.ln(), move |g| regular(!self.cmpeq(Self::ZERO), g, self.recip()))
    }

    /// y x^(y-1) and x^y ln(x); at x = 0 and for negative x see
    /// [singular points](crate::rules#singular-points).
    #[inline(always)]
    fn powf_vjp(self, exponent: Self) -> (Self, impl FnOnce(Self) -> (Self, Self)) {
        let value = self.powf(exponent);
        (value, move |g| {
            let (base_partial, exponent_partial) = power_partials(self, exponent, value);
            (chain(g, base_partial), chain(g, exponent_partial))
        })
    }

    /// n x^(n-1); at 0: 1 for n = 1, else 0.
    #[inline(always)]
    fn powi_vjp(self, exponent: i32) -> (Self, impl FnOnce(Self) -> (Self, ())) {
        (self.powi(exponent), move |g| {
            let partial = match exponent {
                0 => Self::ZERO,
                // The exponent below the least one does not exist.
                i32::MIN => self.powi(exponent) / self * Self::from_f64(f64::from(exponent)),
                n => self.powi(n - 1) * Self::from_f64(f64::from(n)),
            };
            (regular(partial.is_finite() | !self.cmpeq(Self::ZERO), g, partial), ())
        })
    }

    /// cos(x)
    #[inline(always)]
    fn sin_vjp(self) -> (Self, impl FnOnce(Self) -> Self) {
        (self.sin(), move |g| chain(g, self.cos()))
    }

    /// -sin(x)
    #[inline(always)]
    fn cos_vjp(self) -> (Self, impl FnOnce(Self) -> Self) {
        (self.cos(), move |g| chain(g, -self.sin()))
    }

    /// 1 + tan(x)^2
    #[inline(always)]
    fn tan_vjp(self) -> (Self, impl FnOnce(Self) -> Self) {
        let value = self.tan();
        (value, move |g| chain(g, Self::ONE + value * value))
    }

    /// 1/sqrt(1 - x^2); 0 at -1 and 1.
    #[inline(always)]
    fn asin_vjp(self) -> (Self, impl FnOnce(Self) -> Self) {
        (self.asin(), move |g| arc_pullback(self, g))
    }

    /// -1/sqrt(1 - x^2); 0 at -1 and 1.
    #[inline(always)]
    fn acos_vjp(self) -> (Self, impl FnOnce(Self) -> Self) {
        (self.acos(), move |g| -arc_pullback(self, g))
    }

    /// 1/(1 + x^2)
    #[inline(always)]
    fn atan_vjp(self) -> (Self, impl FnOnce(Self) -> Self) {
        (self.atan(), move |g| chain(g, (Self::ONE + self * self).recip()))
    }

    /// x/(x^2 + y^2) and -y/(x^2 + y^2); 0 at the origin and at infinity.
    #[inline(always)]
    fn atan2_vjp(self, abscissa: Self) -> (Self, impl FnOnce(Self) -> (Self, Self)) {
        let (y, x) = (self, abscissa);
        (y.atan2(x), move |g| {
            // Divided by the larger coordinate first: the squares of tiny or huge ones would not
            // be representable.
            let size = x.abs().max(y.abs());
            let (v, u) = (y / size, x / size);
            let norm = (u * u + v * v) * size;
            let defined = !(size.cmpeq(Self::ZERO) | is_infinite(size));
            (regular(defined, g, u / norm), regular(defined, g, -v / norm))
        })
    }

    /// 1 - tanh(x)^2
    #[inline(always)]
    fn tanh_vjp(self) -> (Self, impl FnOnce(Self) -> Self) {
        let value = self.tanh();
        (value, move |g| chain(g, (Self::ONE - value) * (Self::ONE + value)))
    }
}

impl<S: Real> RealRules for S {}

/// The `_vjp` siblings of functions that only single numbers have.
pub trait ScalarRules: Scalar {
    /// Sine and cosine together.
    #[inline(always)]
    fn sin_cos_vjp(self) -> ((Self, Self), impl FnOnce((Self, Self)) -> Self) {
        let (sin, cos) = (self.sin(), self.cos());
        ((sin, cos), move |(g_sin, g_cos)| scale(g_sin, cos) - scale(g_cos, sin))
    }

    /// From degrees to radians.
    #[inline(always)]
    fn to_radians_vjp(self) -> (Self, impl FnOnce(Self) -> Self) {
        let factor = Self::PI / Self::from_f64(180.0);
        (self * factor, move |g| g * factor)
    }

    /// From radians to degrees.
    #[inline(always)]
    fn to_degrees_vjp(self) -> (Self, impl FnOnce(Self) -> Self) {
        let factor = Self::from_f64(180.0 / core::f64::consts::PI);
        (self * factor, move |g| g * factor)
    }
}

impl<S: Scalar> ScalarRules for S {}

/// `cotangent` to the first where `first` holds, else to the second.
#[inline(always)]
fn route<S: Real>(first: S::Mask, cotangent: S) -> (S, S) {
    (S::select(first, cotangent, S::zero()), S::select(first, S::zero(), cotangent))
}

/// [`chain`] where the partial is defined, else 0.
#[inline(always)]
pub(super) fn regular<S: Real>(defined: S::Mask, cotangent: S, partial: S) -> S {
    S::select(defined, chain(cotangent, partial), S::zero())
}

/// The pullback of `asin`. 1 - x^2 as a product, which does not cancel near -1 and 1.
#[inline(always)]
fn arc_pullback<S: Real>(x: S, cotangent: S) -> S {
    let root = ((S::ONE - x) * (S::ONE + x)).sqrt();
    regular(!root.cmpeq(S::ZERO), cotangent, root.recip())
}

/// The partial derivatives of `value = base ^ exponent` by base and exponent.
#[inline(always)]
fn power_partials<S: Real>(base: S, exponent: S, value: S) -> (S, S) {
    // y x^(y-1) as y x^y / x spares a power; where x^y has left the range of normal numbers the
    // quotient would not be accurate.
    let magnitude = value.abs();
    let at_zero = base.cmpeq(S::ZERO);
    let in_range = magnitude.cmpgt(S::MIN_POSITIVE) & magnitude.is_finite() & !at_zero;
    let quotient = exponent * value / base;
    let to_base = if in_range.all() {
        quotient
    } else {
        let singular = at_zero & exponent.cmplt(S::ONE);
        let power = chain(exponent, base.powf(exponent - S::ONE));
        S::select(in_range, quotient, S::select(singular, S::ZERO, power))
    };

    let to_exponent = regular(base.cmpgt(S::ZERO), base.ln(), value);
    (to_base, to_exponent)
}
