use ad::{Differentiable, differentiable};

#[derive(Clone, Copy, Differentiable)]
struct Series(f64);

#[differentiable]
impl Series {
    fn power(self, n: usize) -> f64 {
        if n == 0 { 1.0 } else { self.0 * self.power(n - 1) }
    }

    fn sum(self, n: usize) -> f64 {
        if n == 0 { 0.0 } else { self.0 + Self::sum(self, n - 1) }
    }
}

fn main() {
    Series(1.0).power_grad(3);
}
