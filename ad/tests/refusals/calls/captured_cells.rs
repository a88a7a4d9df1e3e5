use std::cell::Cell;

use ad::differentiable;

#[differentiable]
fn newton<F: Fn(f64) -> f64>(f: F, start: f64) -> f64 {
    let mut x = start;
    for _ in 0..3 {
        x -= 0.1 * f(x);
    }
    x
}

#[differentiable]
fn counted(x: f64) -> f64 {
    let evaluations = Cell::new(0);
    let root = newton(
        |t| {
            evaluations.set(evaluations.get() + 1);
            t * t - x
        },
        x,
    );
    root / evaluations.get() as f64
}

fn main() {}
