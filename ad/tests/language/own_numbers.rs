//! A trait of one's own for numbers, whose methods have the names of those that numbers have.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[differentiable]
trait Float: Differentiable + Copy {
    fn exp(self) -> Self;
    fn sqrt(self) -> Self;
    fn hypot(self, other: Self) -> Self;
    fn to_degrees(self) -> Self;
}

#[differentiable]
impl Float for f64 {
    fn exp(self) -> Self {
        f64::exp(self)
    }

    // Another than that of numbers.
    fn sqrt(self) -> Self {
        2.0 * f64::sqrt(self)
    }

    fn hypot(self, other: Self) -> Self {
        f64::hypot(self, other)
    }

    fn to_degrees(self) -> Self {
        f64::to_degrees(self)
    }
}

#[differentiable]
fn of_trait<T: Float>(x: T, y: T) -> T {
    x.exp().sqrt().hypot(y).to_degrees()
}

#[differentiable]
fn of_both(x: f64, y: f64) -> f64 {
    of_trait(x, y) * f64::exp(x) + f64::sqrt(y * y + 1.0) * <f64 as Float>::sqrt(x * x + 1.0)
}

#[test]
fn each_type_has_its_own() {
    check!(of_both(x, y) at [0.7, 1.3], [-1.2, 0.4]);
}
