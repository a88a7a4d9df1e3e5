use ad::differentiable;

#[differentiable]
fn f(x: Option<f64>, y: f64) -> f64 {
    if let Some(x) = x && y > 0.0 {
        return x;
    }
    y
}

fn main() {
    f::grad(None, 1.0);
}
