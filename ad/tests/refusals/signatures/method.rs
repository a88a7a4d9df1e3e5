use ad::{Differentiable, differentiable};

#[derive(Clone, Copy, Differentiable)]
struct Disc {
    radius: f64,
}

impl Disc {
    #[differentiable]
    fn area(&self) -> f64 {
        self.radius * self.radius
    }
}

fn main() {}
