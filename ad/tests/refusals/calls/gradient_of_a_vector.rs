use ad::differentiable;
use glam::DVec3;

#[differentiable]
fn f(x: f64) -> DVec3 {
    DVec3::splat(x)
}

#[differentiable]
fn g(x: f64) -> Option<f64> {
    Some(x)
}

fn main() {
    f::grad(1.0);
    g::value_and_grad(1.0);
}
