use ad::{Differentiable, differentiable};

#[derive(Clone, Copy, Differentiable)]
struct Angle(f64);

impl From<Angle> for f64 {
    fn from(angle: Angle) -> f64 {
        angle.0.sin()
    }
}

#[differentiable]
fn named(angle: Angle) -> f64 {
    f64::from(angle)
}

#[differentiable]
fn converted(angle: Angle) -> f64 {
    let sine: f64 = angle.into();
    sine * sine
}

fn main() {}
