use ad::differentiable;

mod special {
    pub fn cube(x: f64) -> f64 {
        x * x * x
    }
}

#[differentiable(vjp = cube_vjp)]
use special::cube;

fn cube_vjp(x: f64) -> (f64, impl FnOnce(f64) -> f64) {
    (special::cube(x), move |bar| 3.0 * x * x * bar)
}

#[differentiable]
fn forward_too(x: f64) -> f64 {
    cube(x) + 1.0
}

#[differentiable(reverse)]
fn reverse_alone(x: f64) -> f64 {
    cube(x) + 1.0
}

fn main() {}
