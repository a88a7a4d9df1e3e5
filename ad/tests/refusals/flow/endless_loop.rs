use ad::differentiable;

#[differentiable]
fn f(x: f64) -> f64 {
    let a = loop {
        if x > 1.0 {
            continue;
        }
    };
    a
}

fn main() {
    f::grad(1.0);
}
