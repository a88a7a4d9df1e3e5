use ad::differentiable;

#[allow(non_snake_case)]
fn Split(x: f64) -> (f64, f64) {
    (x * x, x + x)
}

#[differentiable]
fn f(x: f64) -> f64 {
    let (a, b) = Split(x);
    a + b
}

fn main() {
    f::grad(1.0);
}
