//! The extended precision that results are checked against: a number as the sum of two `f64`, about
//! 31 digits with the range of an `f64`.
//!
//! Sums and products by error-free transforms (Dekker 1971; Hida, Li & Bailey, "Library for
//! Double-Double and Quad-Double Arithmetic", 2001), functions by Taylor series and one step of
//! Newton's method from the `f64` function. The crate `twofloat` was turned down: its power is
//! documented as inaccurate, that of 0 to 0 is not a number, and it would need a wrapper of the same
//! length to be a [`Real`].

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use ad::lanes::Lanes;
use ad::rules::{AddPullback, DivPullback, MulPullback, NegPullback, SubPullback};
use ad::vector::Xyz;
use ad::{Additive, Differentiable, Real, Scalar, Select};

/// `high + low`, where `low` is at most half a unit in the last place of `high`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Extended {
    high: f64,
    low: f64,
}

const LN_2: Extended = Extended { high: std::f64::consts::LN_2, low: 2.319_046_813_846_299_6e-17 };

impl Extended {
    /// A number of double precision.
    pub const fn new(high: f64) -> Self {
        Self { high, low: 0.0 }
    }

    /// `a + b`, where `a` is 0 or not the smaller one.
    fn quick_sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let low = if high.is_finite() { b - (high - a) } else { 0.0 };
        Self { high, low }
    }

    fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        if !high.is_finite() {
            return Self::new(high);
        }
        let of_b = high - a;
        Self { high, low: (a - (high - of_b)) + (b - of_b) }
    }

    fn product(a: f64, b: f64) -> Self {
        let high = a * b;
        let low = if high.is_finite() { a.mul_add(b, -high) } else { 0.0 };
        Self { high, low }
    }

    /// `self * 2^exponent`
    fn scaled(self, exponent: i32) -> Self {
        let half = exponent / 2;
        let (a, b) = (2.0_f64.powi(half), 2.0_f64.powi(exponent - half));
        Self { high: self.high * a * b, low: self.low * a * b }
    }

    fn is_zero(self) -> bool {
        self.high == 0.0
    }

    /// The sum of a series, whose terms `next` gives from the one before and its number.
    fn series(first: Self, next: impl Fn(Self, f64) -> Self) -> Self {
        let (mut sum, mut term) = (first, first);
        for n in 1..60 {
            term = next(term, f64::from(n));
            sum = sum + term;
            if term.high.abs() <= 1e-34 * sum.high.abs() {
                break;
            }
        }
        sum
    }

    fn sin_cos(self) -> (Self, Self) {
        let quarters = (self.high / std::f64::consts::FRAC_PI_2).round();
        let r = self - Self::PI.scaled(-1) * Self::new(quarters);
        let step = |term: Self, a: f64, b: f64| -(term * r * r) / Self::new(a * b);
        let sin = Self::series(r, |term, n| step(term, 2.0 * n, 2.0 * n + 1.0));
        let cos = Self::series(Self::ONE, |term, n| step(term, 2.0 * n - 1.0, 2.0 * n));
        match quarters.rem_euclid(4.0) as i32 {
            0 => (sin, cos),
            1 => (cos, -sin),
            2 => (-sin, -cos),
            _ => (-cos, sin),
        }
    }
}

impl Neg for Extended {
    type Output = Self;

    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Add for Extended {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (high, low) = (Self::sum(self.high, other.high), Self::sum(self.low, other.low));
        let sum = Self::quick_sum(high.high, high.low + low.high);
        Self::quick_sum(sum.high, sum.low + low.low)
    }
}

impl Sub for Extended {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Extended {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let product = Self::product(self.high, other.high);
        let rest = self.high * other.low + self.low * other.high;
        if product.high.is_finite() {
            Self::quick_sum(product.high, product.low + rest)
        } else {
            product
        }
    }
}

impl Div for Extended {
    type Output = Self;

    /// Long division: three digits, each an `f64`.
    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        if !first.is_finite() || other.high.is_infinite() {
            return Self::new(first);
        }
        let rest = self - other * Self::new(first);
        let second = rest.high / other.high;
        let rest = rest - other * Self::new(second);
        Self::quick_sum(first, second) + Self::new(rest.high / other.high)
    }
}

impl PartialOrd for Extended {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let high = self.high.partial_cmp(&other.high)?;
        if high == Ordering::Equal { self.low.partial_cmp(&other.low) } else { Some(high) }
    }
}

impl Differentiable for Extended {
    type Tangent = Self;
    type Shape = ();

    fn shape(&self) {}
}

impl Additive for Extended {
    fn zero() -> Self {
        Self::new(-0.0)
    }

    fn accumulate(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Select for Extended {
    type Mask = bool;

    fn select(mask: bool, if_true: Self, if_false: Self) -> Self {
        if mask { if_true } else { if_false }
    }
}

impl NegPullback for Extended {
    fn neg_pullback(cotangent: Self) -> Self {
        -cotangent
    }

    fn neg_jvp(self, tangent: Self) -> (Self, Self) {
        (-self, -tangent)
    }
}

impl AddPullback for Extended {
    fn add_pullback(cotangent: Self) -> (Self, Self) {
        (cotangent, cotangent)
    }

    fn add_jvp(self, rhs: Self, tangent: Self, rhs_tangent: Self) -> (Self, Self) {
        (self + rhs, tangent + rhs_tangent)
    }
}

impl SubPullback for Extended {
    fn sub_pullback(cotangent: Self) -> (Self, Self) {
        (cotangent, -cotangent)
    }

    fn sub_jvp(self, rhs: Self, tangent: Self, rhs_tangent: Self) -> (Self, Self) {
        (self - rhs, tangent - rhs_tangent)
    }
}

impl MulPullback for Extended {
    fn mul_pullback(self, rhs: Self, cotangent: Self) -> (Self, Self) {
        (cotangent * rhs, cotangent * self)
    }

    fn mul_jvp(self, rhs: Self, tangent: Self, rhs_tangent: Self) -> (Self, Self) {
        (self * rhs, tangent * rhs + rhs_tangent * self)
    }
}

impl DivPullback for Extended {
    fn div_pullback(self, rhs: Self, cotangent: Self) -> (Self, Self) {
        let to_self = cotangent / rhs;
        (to_self, -to_self * (self / rhs))
    }

    fn div_jvp(self, rhs: Self, tangent: Self, rhs_tangent: Self) -> (Self, Self) {
        let quotient = self / rhs;
        (quotient, (tangent - quotient * rhs_tangent) / rhs)
    }
}

impl Real for Extended {
    type Vec3 = Xyz<Self>;

    const ZERO: Self = Self::new(0.0);
    const ONE: Self = Self::new(1.0);
    const TWO: Self = Self::new(2.0);
    const HALF: Self = Self::new(0.5);
    const PI: Self = Self { high: std::f64::consts::PI, low: 1.224_646_799_147_353_2e-16 };
    const EPSILON: Self = Self::new(f64::EPSILON * f64::EPSILON);
    const MIN_POSITIVE: Self = Self::new(f64::MIN_POSITIVE);

    fn from_f64(value: f64) -> Self {
        Self::new(value)
    }

    fn cmplt(self, other: Self) -> bool {
        self < other
    }

    fn cmple(self, other: Self) -> bool {
        self <= other
    }

    fn cmpgt(self, other: Self) -> bool {
        self > other
    }

    fn cmpge(self, other: Self) -> bool {
        self >= other
    }

    fn cmpeq(self, other: Self) -> bool {
        self == other
    }

    fn is_finite(self) -> bool {
        self.high.is_finite()
    }

    fn vanishes(self) -> bool {
        self.is_zero()
    }

    fn min(self, other: Self) -> Self {
        if self < other || other.high.is_nan() { self } else { other }
    }

    fn max(self, other: Self) -> Self {
        if self > other || other.high.is_nan() { self } else { other }
    }

    fn clamp(self, low: Self, high: Self) -> Self {
        self.max(low).min(high)
    }

    fn abs(self) -> Self {
        if self.high < 0.0 { -self } else { self }
    }

    fn signum(self) -> Self {
        Self::new(self.high.signum())
    }

    fn copysign(self, sign: Self) -> Self {
        if self.high.is_sign_negative() == sign.high.is_sign_negative() { self } else { -self }
    }

    fn floor(self) -> Self {
        let high = self.high.floor();
        let low = if high == self.high { self.low.floor() } else { 0.0 };
        Self::quick_sum(high, low)
    }

    fn recip(self) -> Self {
        Self::ONE / self
    }

    fn mul_add(self, a: Self, b: Self) -> Self {
        self * a + b
    }

    fn difference_of_products(a: Self, b: Self, c: Self, d: Self) -> Self {
        a * b - c * d
    }

    fn sqrt(self) -> Self {
        let root = self.high.sqrt();
        if self.is_zero() || !root.is_finite() {
            return Self::new(root);
        }
        let root = Self::new(root);
        root + (self - root * root) / (root + root)
    }

    /// Of a 256th of what powers of two leave, then squared eight times.
    fn exp(self) -> Self {
        if self.high.is_nan() || self.high.abs() > 700.0 {
            return Self::new(self.high.exp());
        }
        let powers = (self.high / LN_2.high).round();
        let r = (self - LN_2 * Self::new(powers)).scaled(-8);
        // What exceeds 1, which loses nothing when it is small.
        let mut excess = Self::series(r, |term, n| term * r / Self::new(n + 1.0));
        for _ in 0..8 {
            excess = excess + excess + excess * excess;
        }
        (Self::ONE + excess).scaled(powers as i32)
    }

    fn ln(self) -> Self {
        let near = self.high.ln();
        if !near.is_finite() {
            return Self::new(near);
        }
        let error = self * Self::new(-near).exp() - Self::ONE;
        Self::new(near) + error - error * error * Self::HALF
    }

    fn powf(self, exponent: Self) -> Self {
        let near = self.high.powf(exponent.high);
        if self.high <= 0.0 || !near.is_finite() || exponent.is_zero() {
            return Self::new(near);
        }
        (exponent * self.ln()).exp()
    }

    fn powi(self, exponent: i32) -> Self {
        let power = (0..exponent.unsigned_abs()).fold(Self::ONE, |power, _| power * self);
        if exponent < 0 { power.recip() } else { power }
    }

    fn sin(self) -> Self {
        self.sin_cos().0
    }

    fn cos(self) -> Self {
        self.sin_cos().1
    }

    fn tan(self) -> Self {
        let (sin, cos) = self.sin_cos();
        sin / cos
    }

    fn asin(self) -> Self {
        self.atan2(((Self::ONE - self) * (Self::ONE + self)).sqrt())
    }

    fn acos(self) -> Self {
        ((Self::ONE - self) * (Self::ONE + self)).sqrt().atan2(self)
    }

    fn atan(self) -> Self {
        self.atan2(Self::ONE)
    }

    fn atan2(self, abscissa: Self) -> Self {
        let near = self.high.atan2(abscissa.high);
        let norm = (self * self + abscissa * abscissa).sqrt();
        if norm.is_zero() || !near.is_finite() || !norm.is_finite() {
            return Self::new(near);
        }
        let near = Self::new(near);
        let (sin, cos) = near.sin_cos();
        near + (self * cos - abscissa * sin) / norm
    }

    fn tanh(self) -> Self {
        let square = (self + self).exp();
        Self::ONE - Self::TWO / (square + Self::ONE)
    }
}

impl Scalar for Extended {
    fn to_f64(self) -> f64 {
        self.high
    }
}

impl Lanes for Extended {
    type Element = Self;

    const COUNT: usize = 1;

    fn from_lanes(mut f: impl FnMut(usize) -> Self) -> Self {
        f(0)
    }

    fn lanes(self) -> impl AsRef<[Self]> {
        [self]
    }

    fn mask_from_bits(bits: u32) -> bool {
        bits & 1 == 1
    }

    fn mask_bits(mask: bool) -> u32 {
        mask.into()
    }
}

/// Against digits from tables, and against identities that hold exactly.
#[cfg(test)]
mod tests {
    use ad::Real;

    use super::Extended;

    /// Asserts that two numbers agree to 28 digits.
    fn assert_same(found: Extended, expected: Extended) {
        let error = (found - expected).abs() / expected.abs();
        assert!(error.high <= 1e-28, "{found:?} instead of {expected:?}");
    }

    fn x(high: f64, low: f64) -> Extended {
        Extended::sum(high, low)
    }

    #[test]
    fn constants_have_their_digits() {
        let n = Extended::new;
        assert_same(n(1.0).exp(), x(2.718281828459045, 1.4456468917292502e-16));
        assert_same(n(2.0).ln(), super::LN_2);
        assert_same(n(2.0).sqrt(), x(1.4142135623730951, -9.667293313452913e-17));
        assert_same(n(1.0).atan() * n(4.0), Extended::PI);
        assert_same(n(10.0).ln(), x(2.302585092994046, -2.1707562233822494e-16));
        assert_same((Extended::PI / n(6.0)).sin(), n(0.5));
        assert_same((Extended::PI / n(3.0)).cos(), n(0.5));
        assert_same((Extended::PI / n(4.0)).tan(), n(1.0));
        assert_same(n(0.5).asin() * n(6.0), Extended::PI);
        assert_same(n(0.5).acos() * n(3.0), Extended::PI);
        assert_same(n(3.0).powf(n(-30.0)), n(1.0) / n(205_891_132_094_649.0));
        assert_same(n(-3.0).atan2(n(-3.0)) * n(-4.0), Extended::PI * n(3.0));
    }

    #[test]
    fn identities_hold() {
        let n = Extended::new;
        for i in 1..200 {
            let a = n(f64::from(i) * 0.37 - 20.0) + n(1e-17 * f64::from(i));
            let b = n(f64::from(i * i % 83) + 0.1);
            assert_same(a / b * b, a);
            assert_same(b.sqrt() * b.sqrt(), b);
            assert_same(b.ln().exp(), b);
            let (sin, cos) = a.sin_cos();
            assert_same(sin * sin + cos * cos, n(1.0));
            let positive = a.abs();
            let (sum, product) = (positive + b, positive * b);
            assert_same(sum * sum, a * a + b * b + product + product);
            assert_same(sin.atan2(cos).tan(), a.tan());
            assert!((a.floor() <= a) && (a - a.floor()) < n(1.0));
        }
    }
}
