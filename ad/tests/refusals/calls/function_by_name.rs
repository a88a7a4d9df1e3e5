use ad::differentiable;

#[differentiable]
fn twice<F: Fn(f64) -> f64>(f: F, x: f64) -> f64 {
    f(f(x))
}

fn square(x: f64) -> f64 {
    x * x
}

#[differentiable]
fn fourth(x: f64) -> f64 {
    twice(square, x)
}

fn main() {
    twice::grad(|x: f64| x * x, 1.0);
}
