use ad::{differentiable, no_diff};

#[differentiable]
fn f(x: f64) -> f64 {
    let y = no_diff(|| {
        let x = 2.0;
        x * x
    });
    x * y
}

#[differentiable]
fn g(x: f64) -> f64 {
    let mut y = x;
    no_diff(|| y *= 2.0);
    y
}

fn main() {}
