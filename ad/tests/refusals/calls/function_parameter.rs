use ad::differentiable;

#[differentiable]
fn f<F: Fn(f64) -> f64>(x: f64, g: F) -> f64 {
    g(x)
}

fn main() {
    f(1.0, f64::sin);
}
