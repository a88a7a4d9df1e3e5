//! The functions of extended precision.

use ad::lanes::Lanes;
use ad::vector::Xyz;
use ad::{Real, Scalar};

use super::{Extended, LN_2};

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
