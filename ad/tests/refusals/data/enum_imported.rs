use Shape::{Disc, Point};
use ad::{Differentiable, differentiable};

#[derive(Clone, Copy, Differentiable)]
enum Shape {
    Disc(f64),
    Point,
}

#[differentiable]
fn f(shape: Shape) -> f64 {
    match shape {
        Disc(radius) => radius * radius,
        Point => 0.0,
    }
}

#[derive(Differentiable)]
union Bits {
    float: f64,
}

fn main() {
    f::grad(Disc(1.0));
}
