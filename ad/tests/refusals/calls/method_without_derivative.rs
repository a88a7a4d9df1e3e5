use ad::differentiable;

#[differentiable]
fn f(x: f64) -> f64 {
    x.cbrt() + x
}

fn main() {
    f::grad(1.0);
}
