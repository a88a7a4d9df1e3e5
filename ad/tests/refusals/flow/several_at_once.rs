use ad::differentiable;

#[differentiable]
fn f(x: f64, y: &mut f64) -> f64 {
    while x > 0.0 {}
    let g = |t: f64| t * t;
    std::mem::swap(&mut x, y);
    g(x)
}

fn main() {
    let mut y = 2.0;
    f(1.0, &mut y);
}
