use ad::{Differentiable, differentiable};

#[derive(Differentiable)]
struct Scaled(f64);

#[differentiable]
impl Scaled {
    fn applied(&self, g: impl Fn(f64) -> f64) -> f64 {
        self.0 * g(self.0)
    }
}

#[differentiable]
fn f(x: f64) -> f64 {
    let square = |t: f64| t * t;
    Scaled(x).applied(square) + Scaled(x).applied(|t| t + x)
}

fn main() {
    f::grad(1.0);
}
