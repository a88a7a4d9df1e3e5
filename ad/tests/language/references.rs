//! References to numbers that branches, chains of conditions and patterns of slices give, and
//! constants of types that cannot be copied.

use ad::{Differentiable, differentiable};

use crate::oracle::check_list;

#[differentiable]
fn smoothed(signal: &[f64]) -> f64 {
    let weights = [0.25, 0.5, 0.25];
    let mut total = 0.0;
    for i in 0..signal.len() {
        let mut s = 0.0;
        for (k, w) in weights.iter().enumerate() {
            if let Some(v) = (i + k).checked_sub(1).and_then(|at| signal.get(at)) {
                s += w * v;
            }
        }
        total += s * s;
    }
    total
}

#[differentiable]
fn rising(x: &[f64]) -> f64 {
    if let Some(a) = x.first()
        && let Some(b) = x.get(1)
        && a < b
    {
        a * b
    } else {
        x[2] * x[0]
    }
}

/// The slice that is walked along is assigned to.
#[differentiable]
fn walked(x: &[f64]) -> f64 {
    let mut rest = x;
    let mut total = 0.0;
    while let [head, tail @ ..] = rest {
        total = total * 0.5 + head * head * x[0];
        rest = tail;
    }
    total
}

#[test]
fn references_to_numbers() {
    check_list!(smoothed, rising, walked at [0.3, 1.2, -0.7, 2.0]);
    check_list!(rising, walked at [1.3, 0.2, -0.7]);
}

#[derive(Clone, Differentiable)]
struct Monomial {
    name: String,
    power: i32,
}

#[differentiable]
impl Monomial {
    fn new(power: i32) -> Self {
        Self { name: "x".repeat(power as usize), power }
    }

    fn at(&self, x: f64) -> f64 {
        x.powi(self.power) * self.name.len() as f64
    }
}

#[differentiable]
fn of_array(x: &[f64]) -> f64 {
    let basis = [Monomial::new(1), Monomial::new(2), Monomial::new(3)];
    let first = &basis[0];
    let own: f64 = basis.iter().map(|monomial| monomial.at(x[3])).sum();
    let i = x.len() - 2;
    own * first.at(x[0]) + basis[i].at(x[1]) + basis[i - 1].at(x[2])
}

#[differentiable]
fn of_vector(x: &[f64]) -> f64 {
    let basis = (vec![Monomial::new(1), Monomial::new(3)], 2.0);
    let mut sum = 0.0;
    for monomial in &basis.0 {
        sum += monomial.at(x[1]) * basis.0[1].at(x[0]);
    }
    sum * basis.1
}

#[test]
fn constants_that_cannot_be_copied() {
    check_list!(of_array, of_vector at [0.3, 1.2, -0.7, 2.0]);
}
