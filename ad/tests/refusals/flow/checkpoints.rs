use ad::differentiable;

#[differentiable]
fn once(f: impl Fn(f64) -> f64) -> f64 {
    f(1.0)
}

#[differentiable]
fn f(x: f64, n: usize) -> f64 {
    let mut a = x;
    a += once(|t: f64| {
        let mut b = t;
        #[differentiable(checkpoint)]
        while b > 1.0 {
            b *= 0.5;
        }
        b
    });
    #[differentiable(fast)]
    for _ in 0..n {
        a *= x;
    }
    a
}

fn main() {
    f::grad(1.0, 2);
}
