use ad::differentiable;

#[differentiable]
fn f(x: f64, y: f64) -> f64 {
    let (a, b) = (&x, y);
    a * b
}

fn main() {
    f::grad(1.0, 2.0);
}
