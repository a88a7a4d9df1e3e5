use ad::differentiable;

#[differentiable]
fn f(x: Option<f64>) -> f64 {
    match x {
        Some(X) => X * X,
        None => 0.0,
    }
}

fn main() {
    f::grad(Some(1.0));
}
