//! The operations that a tape records.
//!
//! The partial derivatives are written apart from those in [`rules`](crate::rules), so that each
//! can be the check of the other; at singular points they follow the same table.

use core::fmt;
use core::ops::{Add, Div, Mul, Neg, Sub};

use super::Var;
use crate::assigning::assigning;
use crate::real::compared_by_value;
use crate::vector::Xyz;
use crate::{Additive, Differentiable, Real, Scalar, Select};

/// `partial` where `defined`, else 0.
#[inline(always)]
fn guarded(defined: bool, partial: f64) -> f64 {
    if defined { partial } else { 0.0 }
}

impl fmt::Debug for Var {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.value.fmt(f)
    }
}

impl Default for Var {
    fn default() -> Self {
        Self::constant(0.0)
    }
}

/// Compares the numbers, not where they come from.
impl PartialEq for Var {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

/// Compares the numbers.
impl PartialOrd for Var {
    fn partial_cmp(&self, other: &Self) -> Option<core::cmp::Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

impl Differentiable for Var {
    type Tangent = Self;
    type Shape = ();

    fn shape(&self) {}
}

impl Additive for Var {
    fn zero() -> Self {
        Self::constant(-0.0)
    }

    fn accumulate(&mut self, other: Self) {
        *self += other;
    }
}

impl Select for Var {
    type Mask = bool;

    fn select(mask: bool, if_true: Self, if_false: Self) -> Self {
        if mask { if_true } else { if_false }
    }
}

impl Neg for Var {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        self.unary(-self.value, -1.0)
    }
}

impl Add for Var {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.binary(other, self.value + other.value, [1.0, 1.0])
    }
}

impl Sub for Var {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.binary(other, self.value - other.value, [1.0, -1.0])
    }
}

impl Mul for Var {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.binary(other, self.value * other.value, [other.value, self.value])
    }
}

impl Div for Var {
    type Output = Self;

    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let defined = other.value != 0.0;
        let recip = guarded(defined, 1.0 / other.value);
        self.binary(other, value, [recip, guarded(defined && value != 0.0, -value * recip)])
    }
}

assigning!([] Var);

/// The derivative of `asin`, 0 at -1 and 1.
#[inline(always)]
fn arc_slope(x: f64) -> f64 {
    let root = (1.0 - x * x).sqrt();
    guarded(root != 0.0, 1.0 / root)
}

/// Functions of one number: the derivative in terms of `x` and the value `y`.
macro_rules! unary {
    ($($name:ident |$x:ident, $y:ident| $partial:expr;)*) => {$(
        #[inline(always)]
        fn $name(self) -> Self {
            let $x = self.value;
            let $y = $x.$name();
            self.unary($y, $partial)
        }
    )*};
}

impl Real for Var {
    type Vec3 = Xyz<Self>;

    const ZERO: Self = Self::constant(0.0);
    const ONE: Self = Self::constant(1.0);
    const TWO: Self = Self::constant(2.0);
    const HALF: Self = Self::constant(0.5);
    const PI: Self = Self::constant(core::f64::consts::PI);
    const EPSILON: Self = Self::constant(f64::EPSILON);
    const MIN_POSITIVE: Self = Self::constant(f64::MIN_POSITIVE);

    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self::constant(value)
    }

    compared_by_value!(bool);

    #[inline(always)]
    fn is_finite(self) -> bool {
        self.value.is_finite()
    }

    /// A number that depends on a variable may be zero here and something else nearby.
    #[inline(always)]
    fn vanishes(self) -> bool {
        self.origin.is_constant() && self.value == 0.0
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        if self.value.min(other.value) == self.value { self } else { other }
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if self.value.max(other.value) == self.value { self } else { other }
    }

    #[inline(always)]
    fn clamp(self, low: Self, high: Self) -> Self {
        let bounded = if self.value < low.value { low } else { self };
        if bounded.value > high.value { high } else { bounded }
    }

    #[inline(always)]
    fn signum(self) -> Self {
        Self::constant(self.value.signum())
    }

    #[inline(always)]
    fn copysign(self, sign: Self) -> Self {
        let flip = self.value.signum() * sign.value.signum();
        self.unary(self.value.copysign(sign.value), guarded(self.value != 0.0, flip))
    }

    #[inline(always)]
    fn floor(self) -> Self {
        Self::constant(self.value.floor())
    }

    #[inline(always)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        let value = self.value.mul_add(a.value, b.value);
        let product = self.binary(a, self.value * a.value, [a.value, self.value]);
        product.binary(b, value, [1.0, 1.0])
    }

    #[inline(always)]
    fn difference_of_products(a: Self, b: Self, c: Self, d: Self) -> Self {
        let value = f64::difference_of_products(a.value, b.value, c.value, d.value);
        (a * b).binary(c * d, value, [1.0, -1.0])
    }

    #[inline(always)]
    fn powf(self, exponent: Self) -> Self {
        let (x, y) = (self.value, exponent.value);
        let value = x.powf(y);
        let by_base = x.powf(y - 1.0);
        let by_base = guarded((x != 0.0 || y >= 1.0) && by_base != 0.0, y * by_base);
        let by_exponent = guarded(x > 0.0 && value != 0.0, x.ln() * value);
        self.binary(exponent, value, [by_base, by_exponent])
    }

    #[inline(always)]
    fn powi(self, exponent: i32) -> Self {
        let value = self.value.powi(exponent);
        if exponent == 0 {
            return Self::constant(value);
        }
        let partial = f64::from(exponent) * self.value.powi(exponent.saturating_sub(1));
        self.unary(value, guarded(self.value != 0.0 || partial.is_finite(), partial))
    }

    #[inline(always)]
    fn atan2(self, abscissa: Self) -> Self {
        let (y, x) = (self.value, abscissa.value);
        let norm = y.hypot(x);
        let defined = norm != 0.0 && 1.0 / norm != 0.0;
        let partials = [x / norm / norm, -(y / norm / norm)];
        self.binary(abscissa, y.atan2(x), partials.map(|partial| guarded(defined, partial)))
    }

    unary! {
        abs |x, _y| guarded(x != 0.0, x.signum());
        recip |x, y| guarded(x != 0.0, -y * y);
        sqrt |_x, y| guarded(y != 0.0, 0.5 / y);
        exp |_x, y| y;
        ln |x, _y| guarded(x != 0.0, 1.0 / x);
        sin |x, _y| x.cos();
        cos |x, _y| -x.sin();
        tan |x, _y| 1.0 / (x.cos() * x.cos());
        asin |x, _y| arc_slope(x);
        acos |x, _y| -arc_slope(x);
        atan |x, _y| 1.0 / (1.0 + x * x);
        tanh |_x, y| 1.0 - y * y;
    }
}

impl Scalar for Var {
    fn to_f64(self) -> f64 {
        self.value
    }
}
