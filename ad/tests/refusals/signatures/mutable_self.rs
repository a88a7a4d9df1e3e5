use ad::{Differentiable, differentiable};

#[derive(Clone, Copy, Differentiable)]
struct Counter {
    total: f64,
}

#[differentiable]
impl Counter {
    fn add(&mut self, x: f64) -> f64 {
        self.total += x;
        self.total
    }

    fn new() -> Self {
        Self { total: 0.0 }
    }
}

fn main() {}
