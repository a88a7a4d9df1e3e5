//! Dual numbers: forward-mode derivatives by operator overloading.

use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::assigning::assigning;
use crate::real::compared_by_value;
use crate::vector::Xyz;
use crate::{Additive, Differentiable, Real, Select};

mod directions;
mod lift;

pub use directions::{Along, Directions};
pub(crate) use lift::along_each_coordinate;
pub use lift::{AT_ONCE, Lift, Split};

/// `value + derivative * e` with `e * e = 0`.
///
/// A function generic over [`Real`] evaluated on `Dual { value: x, derivative: v }` gives its value
/// at `x` and its directional derivative along `v`. Put under a generated adjoint, the derivative
/// parts of the cotangents are a Hessian-vector product (forward over reverse).
///
/// The formulas here are written apart from those in [`rules`](crate::rules), so that each can be
/// the check of the other; at singular points they follow the same table.
///
/// With [`Directions`] in the place of one derivative there are several directions at once, which
/// share what the value costs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Dual<S, D = S> {
    /// The number.
    pub value: S,
    /// The derivative of the value along the chosen direction, or directions.
    pub derivative: D,
}

impl<S: Real, D: Along<S>> Dual<S, D> {
    /// A number that moves with the direction.
    #[inline(always)]
    pub fn new(value: S, derivative: D) -> Self {
        Self { value, derivative }
    }

    /// A number that does not.
    #[inline(always)]
    pub fn constant(value: S) -> Self {
        Self::new(value, D::ZERO)
    }

    /// `f(self)` from the value and the derivative of `f`; a derivative of 0 stays 0.
    #[inline(always)]
    fn chain(self, value: S, slope: S) -> Self {
        Self::new(value, self.derivative.times(slope))
    }
}

impl<S: Real, D: Along<S>> Differentiable for Dual<S, D> {
    type Tangent = Self;
    type Shape = ();

    #[inline(always)]
    fn shape(&self) {}

    #[inline(always)]
    fn irregularity(&self) -> f64 {
        let value = self.value.irregularity();
        self.derivative.fold(value, |sum, along| sum + along.irregularity())
    }
}

impl<S: Real, D: Along<S>> Additive for Dual<S, D> {
    #[inline(always)]
    fn zero() -> Self {
        Self::new(S::zero(), D::neutral())
    }

    #[inline(always)]
    fn accumulate(&mut self, other: Self) {
        *self += other;
    }
}

impl<S: Real, D: Along<S>> Select for Dual<S, D> {
    type Mask = S::Mask;

    #[inline(always)]
    fn select(mask: S::Mask, if_true: Self, if_false: Self) -> Self {
        Self::new(
            S::select(mask, if_true.value, if_false.value),
            D::choose(mask, if_true.derivative, if_false.derivative),
        )
    }
}

impl<S: Real, D: Along<S>> Neg for Dual<S, D> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.value, self.derivative.map(|along| -along))
    }
}

impl<S: Real, D: Along<S>> Add for Dual<S, D> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::new(self.value + other.value, self.derivative.plus(other.derivative))
    }
}

impl<S: Real, D: Along<S>> Sub for Dual<S, D> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        let along = D::zip(self.derivative, other.derivative, |a, b| a - b);
        Self::new(self.value - other.value, along)
    }
}

impl<S: Real, D: Along<S>> Mul for Dual<S, D> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let from_self = self.chain(self.value, other.value).derivative;
        let from_other = other.chain(other.value, self.value).derivative;
        Self::new(self.value * other.value, from_self.plus(from_other))
    }
}

impl<S: Real, D: Along<S>> Div for Dual<S, D> {
    type Output = Self;

    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        let slope = D::zip(self.derivative, other.derivative, |along_self, along_other| {
            quotient_slope(quotient, other.value, along_self, along_other)
        });
        Self::new(quotient, slope)
    }
}

assigning!([S: Real, D: Along<S>] Dual<S, D>);

impl<S: Real, D: Along<S>> Real for Dual<S, D> {
    type Vec3 = Xyz<Self>;

    const ZERO: Self = Self { value: S::ZERO, derivative: D::ZERO };
    const ONE: Self = Self { value: S::ONE, derivative: D::ZERO };
    const TWO: Self = Self { value: S::TWO, derivative: D::ZERO };
    const HALF: Self = Self { value: S::HALF, derivative: D::ZERO };
    const PI: Self = Self { value: S::PI, derivative: D::ZERO };
    const EPSILON: Self = Self { value: S::EPSILON, derivative: D::ZERO };
    const MIN_POSITIVE: Self = Self { value: S::MIN_POSITIVE, derivative: D::ZERO };

    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self::constant(S::from_f64(value))
    }

    compared_by_value!(S::Mask);

    #[inline(always)]
    fn is_finite(self) -> S::Mask {
        self.value.is_finite()
    }

    #[inline(always)]
    fn vanishes(self) -> S::Mask {
        self.derivative.fold(self.value.vanishes(), |all, along| all & along.vanishes())
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self::select(self.value.min(other.value).cmpeq(self.value), self, other)
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self::select(self.value.max(other.value).cmpeq(self.value), self, other)
    }

    #[inline(always)]
    fn clamp(self, low: Self, high: Self) -> Self {
        let bounded = Self::select(self.value.cmplt(low.value), low, self);
        Self::select(bounded.value.cmpgt(high.value), high, bounded)
    }

    #[inline(always)]
    fn abs(self) -> Self {
        let slope = S::select(self.value.cmpeq(S::ZERO), S::ZERO, self.value.signum());
        self.chain(self.value.abs(), slope)
    }

    #[inline(always)]
    fn signum(self) -> Self {
        Self::constant(self.value.signum())
    }

    #[inline(always)]
    fn copysign(self, sign: Self) -> Self {
        let flip = self.value.signum() * sign.value.signum();
        let slope = S::select(self.value.cmpeq(S::ZERO), S::ZERO, flip);
        self.chain(self.value.copysign(sign.value), slope)
    }

    #[inline(always)]
    fn floor(self) -> Self {
        Self::constant(self.value.floor())
    }

    #[inline(always)]
    fn recip(self) -> Self {
        Self::ONE / self
    }

    #[inline(always)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        let derivative = (self * a + b).derivative;
        Self::new(self.value.mul_add(a.value, b.value), derivative)
    }

    #[inline(always)]
    fn difference_of_products(a: Self, b: Self, c: Self, d: Self) -> Self {
        let derivative = (a * b - c * d).derivative;
        Self::new(S::difference_of_products(a.value, b.value, c.value, d.value), derivative)
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        let slope = S::select(root.cmpeq(S::ZERO), S::ZERO, (root + root).recip());
        self.chain(root, slope)
    }

    #[inline(always)]
    fn exp(self) -> Self {
        let value = self.value.exp();
        self.chain(value, value)
    }

    #[inline(always)]
    fn ln(self) -> Self {
        let slope = S::select(self.value.cmpeq(S::ZERO), S::ZERO, self.value.recip());
        self.chain(self.value.ln(), slope)
    }

    #[inline(always)]
    fn powf(self, exponent: Self) -> Self {
        let (x, y) = (self.value, exponent.value);
        let value = x.powf(y);
        let singular = x.cmpeq(S::ZERO) & y.cmplt(S::ONE);
        let by_base = S::select(singular, S::ZERO, y.times(x.powf(y - S::ONE)));
        let by_exponent = S::select(x.cmpgt(S::ZERO), x.ln().times(value), S::ZERO);
        let along_base = self.chain(value, by_base).derivative;
        let along_exponent = exponent.chain(value, by_exponent).derivative;
        Self::new(value, along_base.plus(along_exponent))
    }

    #[inline(always)]
    fn powi(self, exponent: i32) -> Self {
        let value = self.value.powi(exponent);
        if exponent == 0 {
            return Self::constant(value);
        }
        let slope = self.value.powi(exponent.saturating_sub(1)) * S::from_f64(f64::from(exponent));
        let undefined = self.value.cmpeq(S::ZERO) & !slope.is_finite();
        self.chain(value, S::select(undefined, S::ZERO, slope))
    }

    #[inline(always)]
    fn sin(self) -> Self {
        self.chain(self.value.sin(), self.value.cos())
    }

    #[inline(always)]
    fn cos(self) -> Self {
        self.chain(self.value.cos(), -self.value.sin())
    }

    #[inline(always)]
    fn tan(self) -> Self {
        let cos = self.value.cos();
        self.chain(self.value.tan(), (cos * cos).recip())
    }

    #[inline(always)]
    fn asin(self) -> Self {
        self.chain(self.value.asin(), arc_slope(self.value))
    }

    #[inline(always)]
    fn acos(self) -> Self {
        self.chain(self.value.acos(), -arc_slope(self.value))
    }

    #[inline(always)]
    fn atan(self) -> Self {
        self.chain(self.value.atan(), (self.value * self.value + S::ONE).recip())
    }

    #[inline(always)]
    fn atan2(self, abscissa: Self) -> Self {
        let (y, x) = (self.value, abscissa.value);
        // Divided by the larger coordinate first: squares of tiny or huge ones are not representable.
        let size = x.abs().max(y.abs());
        let (v, u) = (y / size, x / size);
        let norm = (u * u + v * v) * size;
        // At the origin and at infinity.
        let still = size.cmpeq(S::ZERO) | size.recip().cmpeq(S::ZERO);
        let slope = D::zip(self.derivative, abscissa.derivative, |along_y, along_x| {
            let slope = (u * along_y - v * along_x) / norm;
            S::select(still, S::ZERO, slope)
        });
        Self::new(y.atan2(x), slope)
    }

    #[inline(always)]
    fn tanh(self) -> Self {
        let value = self.value.tanh();
        self.chain(value, S::ONE - value * value)
    }
}

/// The derivative of a quotient by those of numerator and denominator; 0 where both are, and where
/// the denominator is.
#[inline(always)]
fn quotient_slope<S: Real>(quotient: S, denominator: S, along: S, along_denominator: S) -> S {
    let slope = (along - along_denominator.times(quotient)) / denominator;
    let still = along.vanishes() & along_denominator.vanishes();
    let singular = denominator.cmpeq(S::ZERO) | denominator.recip().cmpeq(S::ZERO);
    S::select(still | singular, S::ZERO, slope)
}

/// The derivative of `asin`, 0 at -1 and 1.
#[inline(always)]
fn arc_slope<S: Real>(x: S) -> S {
    let root = (S::ONE - x * x).sqrt();
    S::select(root.cmpeq(S::ZERO), S::ZERO, root.recip())
}
