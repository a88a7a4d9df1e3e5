use Shape::Disc;
use ad::{Differentiable, differentiable};

#[derive(Clone, Copy, Differentiable)]
enum Shape {
    Disc(f64),
    Point,
}

#[differentiable]
fn f(shape: Shape) -> f64 {
    match shape {
        Disc(1.0) => 2.0,
        Disc(radius) => radius * radius,
        Shape::Point => 0.0,
    }
}

#[differentiable]
fn one_name_alone(shapes: [Shape; 2]) -> f64 {
    match shapes {
        [Disc(radius), _] => radius * radius,
        _ => 0.0,
    }
}

#[derive(Differentiable)]
union Bits {
    float: f64,
}

fn main() {}
