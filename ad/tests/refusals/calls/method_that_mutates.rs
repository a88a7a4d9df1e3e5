use ad::{Differentiable, differentiable};

#[derive(Clone, Copy, Differentiable)]
struct Counter {
    total: f64,
}

impl Counter {
    fn add(&mut self, x: f64) {
        self.total += x;
    }
}

#[differentiable]
fn f(x: f64) -> f64 {
    let mut counter = Counter { total: x };
    counter.add(x);
    counter.total
}

fn main() {
    f::grad(1.0);
}
