//! Operators of a type that is not `Copy`, where nothing says so.

use std::ops::{Add, MulAssign};

use ad::{Differentiable, differentiable};

#[derive(Clone, Differentiable)]
struct Polynomial(Vec<f64>);

#[differentiable]
impl MulAssign<f64> for Polynomial {
    fn mul_assign(&mut self, by: f64) {
        for c in &mut self.0 {
            *c *= by;
        }
    }
}

impl Add<&Polynomial> for &Polynomial {
    type Output = Polynomial;

    fn add(self, other: &Polynomial) -> Polynomial {
        Polynomial(self.0.iter().zip(&other.0).map(|(a, b)| a + b).collect())
    }
}

#[differentiable]
fn line(slope: f64) -> Polynomial {
    Polynomial(vec![0.0, slope])
}

#[differentiable]
fn scaled(x: f64) -> f64 {
    let mut p = line(x);
    p *= x;
    p.0[1]
}

#[differentiable]
fn without_rule(p: &Polynomial) -> f64 {
    (p + p).0[1]
}

fn main() {
    scaled::grad(1.0);
}
