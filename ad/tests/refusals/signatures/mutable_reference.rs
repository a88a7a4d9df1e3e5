use ad::differentiable;

#[differentiable]
fn f(x: &mut f64) -> f64 {
    *x * *x
}

#[differentiable]
fn g(x: f64) -> f64 {
    let mut y = x;
    f(&mut y)
}

fn main() {
    g(1.0);
}
