use ad::differentiable;

#[differentiable]
fn elsewhere(x: f64) -> f64 {
    let y = g(x)?;
    y * x
}

#[differentiable]
fn g(x: f64) -> Option<f64> {
    Some(x)
}

fn main() {}
