use ad::{Differentiable, differentiable};

#[derive(Differentiable)]
struct Disc {
    radius: f64,
}

trait Area {
    fn area(&self) -> f64;
}

#[differentiable]
impl Area for Disc {
    fn area(&self) -> f64 {
        self.radius * self.radius
    }
}

fn main() {}
