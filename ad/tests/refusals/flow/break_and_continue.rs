use ad::differentiable;

#[differentiable]
fn f(x: f64) -> f64 {
    let mut a = x;
    for i in 0..10 {
        if i == 3 {
            continue;
        }
        if a > 10.0 {
            break;
        }
        a *= 2.0;
    }
    a
}

fn main() {
    f::grad(1.0);
}
