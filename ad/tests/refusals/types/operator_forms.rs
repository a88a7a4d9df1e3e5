//! An operator with the attribute on several of its forms.

use std::ops::{Mul, Neg};

use ad::{Differentiable, differentiable};

#[derive(Clone, Copy, Differentiable)]
struct Complex(f64, f64);

#[differentiable]
impl Mul for Complex {
    type Output = Complex;

    fn mul(self, other: Complex) -> Complex {
        Complex(self.0 * other.0 - self.1 * other.1, self.0 * other.1 + self.1 * other.0)
    }
}

#[differentiable]
impl Mul<&Complex> for &Complex {
    type Output = Complex;

    fn mul(self, other: &Complex) -> Complex {
        *self * *other
    }
}

#[differentiable]
impl Neg for &Complex {
    type Output = Complex;

    fn neg(self) -> Complex {
        let range = 0..2;
        Complex(-self.0 * range.len() as f64, -self.1)
    }
}

fn main() {}
