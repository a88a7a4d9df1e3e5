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
impl Counter {
    fn bump(&mut self) -> f64 {
        self.total *= 2.0;
        self.total
    }

    fn drained(&mut self) -> Option<f64> {
        self.total *= 0.5;
        Some(self.total)
    }

    fn scaled(self, by: f64) -> f64 {
        self.total * by
    }
}

#[differentiable]
fn f(x: f64) -> f64 {
    let mut counter = Counter { total: x };
    counter.add(x);
    counter.total
}

#[differentiable]
fn changed_by_an_argument(x: f64) -> f64 {
    let mut counter = Counter { total: x };
    counter.scaled(counter.bump())
}

#[differentiable]
fn changed_by_an_argument_that_exits(x: f64) -> Option<f64> {
    let mut counter = Counter { total: x };
    Some(counter.scaled(counter.drained()?))
}

#[differentiable]
fn changed_in_a_checkpointed_loop(x: f64) -> Option<f64> {
    let mut counter = Counter { total: x };
    let mut sum = 0.0;
    #[differentiable(checkpoint)]
    for _ in 0..3 {
        sum += counter.scaled(counter.drained()?);
    }
    Some(sum)
}

fn main() {
    f::grad(1.0);
    changed_by_an_argument::grad(1.0);
}
