use ad::differentiable;

#[differentiable]
struct Disc {
    radius: f64,
}

#[differentiable]
mod shapes {}

#[differentiable(fast)]
fn f(x: f64) -> f64 {
    x
}

#[differentiable]
use std::f64::consts::PI;

#[differentiable(vjp = f)]
use std::mem::{replace, swap};

fn main() {}
