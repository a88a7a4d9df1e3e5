use ad::differentiable;

#[differentiable]
fn f(x: f64) -> Result<f64, String> {
    let a = g(x)?;
    Ok(a)
}

fn g(x: f64) -> Result<f64, String> {
    Ok(x)
}

fn main() {
    f(1.0).unwrap();
}
