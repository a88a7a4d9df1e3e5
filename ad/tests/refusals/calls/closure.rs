use ad::{Differentiable, differentiable};

#[derive(Differentiable)]
struct Scaled(f64);

#[differentiable]
impl Scaled {
    fn applied(x: f64, g: impl Fn(f64) -> f64) -> f64 {
        x * g(x)
    }
}

#[differentiable]
fn f(x: f64) -> f64 {
    let square = |t: f64| t * t;
    Scaled::applied(x, square) + Scaled::applied(x, |t| t + x)
}

fn main() {
    f::grad(1.0);
}
