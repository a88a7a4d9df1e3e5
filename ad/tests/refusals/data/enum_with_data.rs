use ad::differentiable;

enum Shape {
    Disc(f64),
    Square { side: f64 },
}

#[differentiable]
fn f(x: f64) -> f64 {
    let shape = if x > 0.0 { Shape::Disc(x) } else { Shape::Square { side: x } };
    match shape {
        Shape::Disc(radius) => radius * radius,
        Shape::Square { side } => side,
    }
}

fn main() {
    f::grad(1.0);
}
