use ad::differentiable;

#[differentiable]
fn f(x: f64) -> f64 {
    let mut a = x;
    loop {
        a *= 2.0;
        if a > 10.0 {
            return a;
        }
    }
}

fn main() {
    f::grad(1.0);
}
