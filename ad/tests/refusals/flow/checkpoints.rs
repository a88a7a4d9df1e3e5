use ad::differentiable;

#[differentiable]
fn f(x: f64, n: usize) -> f64 {
    let mut a = x;
    #[differentiable(checkpoint)]
    while a > 1.0 {
        a *= 0.5;
    }
    #[differentiable(fast)]
    for _ in 0..n {
        a *= x;
    }
    a
}

fn main() {
    f::grad(1.0, 2);
}
