//! Methods of options and results.

use ad::differentiable;
#[differentiable]
fn root(x: f64) -> Result<f64, String> {
    if x < 0.0 {
        return Err(format!("negative: {x}"));
    }
    Ok(x.sqrt())
}
#[differentiable]
fn opt(x: f64) -> Option<f64> {
    if x > 0.0 { Some(x * x) } else { None }
}
#[differentiable]
fn chain(x: f64, y: f64) -> Result<f64, String> {
    let a = opt(x).ok_or("none").map_err(|e| e.to_string())?;
    let b = opt(y).ok_or_else(|| "none".to_string())?;
    let c = root(a - b).unwrap_or(y * 3.0);
    let d = root(a - 2.0 * b).ok().unwrap_or_default();
    let e: Result<f64, String> = root(b);
    let f = e.map(|v| v * x).and_then(|v| root(v * y)).map_or(y, |v| v * v);
    let g = root(-x).unwrap_or_default() + root(x).unwrap_or_default();
    let h: Result<f64, String> = root(y - x);
    let i =
        h.or_else(|e| if e.is_empty() { Err(e) } else { Ok::<f64, String>(x * y) }).unwrap_or(7.0);
    Ok(a * b + c * d + f * g + i)
}
#[differentiable]
fn caught(x: f64, y: f64) -> f64 {
    chain(x, y).unwrap_or_else(|_| x + 2.0 * y)
}

#[test]
fn methods() {
    use crate::oracle::check;

    // Each point goes another way: the difference of two squares is negative, or one is missing.
    check!(caught(x, y) at [0.7, 0.4], [0.4, 0.7], [1.3, 0.2], [-1.0, 0.5], [1.0, -2.0]);
}
