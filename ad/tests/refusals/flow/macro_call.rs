use ad::differentiable;

#[differentiable]
fn f(x: f64) -> f64 {
    assert!(x > 0.0);
    let y = dbg!(x * x);
    if matches!(y as i32, 3) { x } else { y }
}

fn main() {
    f::grad(1.0);
}
