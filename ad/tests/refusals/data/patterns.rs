use ad::differentiable;

#[differentiable]
fn f(x: (f64, f64, f64), y: Option<f64>) -> f64 {
    let (.., c) = x;
    let (ref a, _, _) = x;
    match y {
        Some(b @ 0.0..) => b * c * *a,
        _ => 0.0,
    }
}

fn main() {
    f::grad((1.0, 2.0, 3.0), None);
}
