use ad::differentiable;

#[differentiable]
fn f(x: f64) -> Option<f64> {
    let mut a = x;
    let b = {
        a += 1.0;
        a
    } * g(a)?;
    Some(b)
}

#[differentiable]
fn g(x: f64) -> Option<f64> {
    Some(x)
}

fn main() {
    f(1.0);
}
