use ad::differentiable;

#[differentiable]
struct Disc {
    radius: f64,
}

#[differentiable]
trait Area {
    fn area(&self) -> f64;
}

#[differentiable]
mod shapes {}

#[differentiable(fast)]
fn f(x: f64) -> f64 {
    x
}

fn main() {}
