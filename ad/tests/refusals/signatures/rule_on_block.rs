use ad::{Differentiable, differentiable};

#[derive(Clone, Differentiable)]
struct Scale(f64);

#[differentiable(vjp = by_hand)]
impl Scale {
    fn apply(&self, x: f64) -> f64 {
        self.0 * x
    }
}

#[differentiable]
fn sum(xs: &[f64]) -> f64 {
    let mut sum = 0.0;
    #[differentiable(vjp = by_hand)]
    for x in xs {
        sum += x;
    }
    sum
}

fn main() {}
