use ad::differentiable;

#[differentiable]
fn cut(x: f64) -> Result<f64, f64> {
    let a = either(x)?;
    Ok(a * x)
}

#[differentiable]
fn either(x: f64) -> Result<f64, f64> {
    Err(x)
}

fn main() {
    let _ = cut::vjp(1.0);
}
