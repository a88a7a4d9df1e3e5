use ad::differentiable;

#[differentiable]
fn f(x: f64) -> f64 {
    let square = |t: f64| t * t;
    applied(square, x) + applied(|t| t + x, x)
}

fn applied(g: impl Fn(f64) -> f64, x: f64) -> f64 {
    g(x)
}

fn main() {
    f::grad(1.0);
}
