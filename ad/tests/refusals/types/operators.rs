//! Operators of one's own types that have no rule, or can have none.

use std::iter::Sum;
use std::ops::{Add, AddAssign, Mul, Neg};

use ad::{Differentiable, differentiable};

#[derive(Clone, Copy, Differentiable)]
struct Complex(f64, f64);

impl Add for Complex {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0, self.1 + other.1)
    }
}

impl AddAssign for Complex {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

#[differentiable(checkpoint)]
impl Mul for Complex {
    type Output = Complex;

    fn mul(self, other: Complex) -> Complex {
        Complex(self.0 * other.0, self.1 * other.1)
    }
}

#[differentiable]
impl Sum for Complex {
    fn sum<I: Iterator<Item = Self>>(iter: I) -> Self {
        iter.fold(Self(0.0, 0.0), |sum, z| z + sum)
    }
}

#[differentiable]
impl Neg for Complex {
    type Output = Self;

    fn neg(self) -> Self {
        let range = 0..2;
        Self(-self.0 * range.len() as f64, -self.1)
    }
}

#[derive(Differentiable)]
struct Polynomial(Vec<f64>);

#[differentiable]
impl Mul<f64> for Polynomial {
    type Output = Self;

    fn mul(self, by: f64) -> Self {
        Self(self.0.iter().map(|c| c * by).collect())
    }
}

#[differentiable]
impl Mul<&[f64]> for &Polynomial {
    type Output = Vec<f64>;

    fn mul(self, at: &[f64]) -> Vec<f64> {
        at.iter().map(|x| x * self.0[0]).collect()
    }
}

fn main() {}
