use ad::differentiable;

#[differentiable]
fn f(x: f64) {
    let _ = x;
}

#[differentiable]
fn g(x: &mut f64) {
    *x *= 2.0;
}

fn main() {
    g::grad(&mut 1.0);
}
