//! A mistake in a function is no mistake in its callers.

use ad::{Differentiable, differentiable};

#[derive(Differentiable)]
struct Weights {
    values: Vec<f64>,
}

#[differentiable]
impl Weights {
    fn first(&self, xs: &[f64]) -> f64 {
        unsafe { self.values[0] * *xs.get_unchecked(0) }
    }
}

#[differentiable]
fn sum(xs: &[f64]) -> f64 {
    unsafe { *xs.get_unchecked(0) }
}

#[differentiable]
fn caller(weights: &Weights, xs: &[f64]) -> f64 {
    let mut total = 0.0;
    for i in 0..xs.len() {
        total += sum(&xs[i..]) * weights.first(xs);
    }
    total
}

fn main() {}
