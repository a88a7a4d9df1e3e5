use ad::differentiable;

#[differentiable]
fn f(x: f64) {
    let _ = x;
}

#[differentiable]
fn g() -> f64 {
    1.0
}

fn main() {}
