use ad::differentiable;

#[differentiable]
fn f(x: f64, y: f64) -> f64 {
    let a = x & y;
    a * x
}

fn main() {
    f::grad(1.0, 2.0);
}
