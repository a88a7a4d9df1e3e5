//! The extended precision that results are checked against: a number as the sum of two `f64`, about
//! 31 digits with the range of an `f64`.
//!
//! Sums and products by error-free transforms (Dekker 1971; Hida, Li & Bailey, "Library for
//! Double-Double and Quad-Double Arithmetic", 2001), functions by Taylor series and one step of
//! Newton's method from the `f64` function. The crate `twofloat` was turned down: its power is
//! documented as inaccurate, that of 0 to 0 is not a number, and it would need a wrapper of the same
//! length to be a [`Real`].

mod real;
#[cfg(test)]
mod tests;

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use ad::rules::{
    AddPullback, Arithmetic, DivPullback, MulPullback, NegPullback, Nothing, SubPullback,
};
use ad::{Additive, Differentiable, Real, Select};

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
            sum += term;
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

macro_rules! assigning {
    ($($name:ident $method:ident $operator:tt;)*) => {$(
        impl std::ops::$name for Extended {
            fn $method(&mut self, other: Self) {
                *self = *self $operator other;
            }
        }
    )*};
}

assigning! {
    AddAssign add_assign +;
    SubAssign sub_assign -;
    MulAssign mul_assign *;
    DivAssign div_assign /;
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
        *self += other;
    }
}

impl Select for Extended {
    type Mask = bool;

    fn select(mask: bool, if_true: Self, if_false: Self) -> Self {
        if mask { if_true } else { if_false }
    }
}

impl Arithmetic for Extended {}

impl NegPullback for Extended {
    type Kept = Nothing;

    fn neg_pullback(_: &Nothing, cotangent: Self) -> Self {
        -cotangent
    }

    fn neg_jvp(self, tangent: Self) -> (Self, Self) {
        (-self, -tangent)
    }
}

impl AddPullback for Extended {
    type Kept = Nothing;

    fn add_pullback(_: &Nothing, cotangent: Self) -> (Self, Self) {
        (cotangent, cotangent)
    }

    fn add_jvp(self, rhs: Self, tangent: Self, rhs_tangent: Self) -> (Self, Self) {
        (self + rhs, tangent + rhs_tangent)
    }
}

impl SubPullback for Extended {
    type Kept = Nothing;

    fn sub_pullback(_: &Nothing, cotangent: Self) -> (Self, Self) {
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
