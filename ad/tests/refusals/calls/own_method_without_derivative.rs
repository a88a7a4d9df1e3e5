use ad::{Differentiable, differentiable};

#[derive(Clone, Copy, Differentiable)]
struct Disc {
    radius: f64,
}

impl Disc {
    fn area(&self) -> f64 {
        self.radius * self.radius * 3.0
    }
}

#[differentiable]
fn f(disc: Disc) -> f64 {
    disc.area()
}

fn main() {
    f::grad(Disc { radius: 1.0 });
}
