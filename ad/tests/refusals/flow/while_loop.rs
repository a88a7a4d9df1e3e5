use ad::differentiable;

#[differentiable]
fn f(x: f64) -> f64 {
    let mut a = x;
    while a < 10.0 {
        a *= 2.0;
    }
    a
}

fn main() {
    f::grad(1.0);
}
