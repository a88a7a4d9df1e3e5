use ad::differentiable;

trait Curve {
    fn at(&self, x: f64) -> f64;
}

#[differentiable]
fn f(curve: &impl Curve, x: f64) -> f64 {
    curve.at(x)
}

fn main() {}
