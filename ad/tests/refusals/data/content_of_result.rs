use ad::differentiable;

#[differentiable]
fn scaled(mut r: Result<f64, String>, x: f64) -> f64 {
    *r.as_mut().unwrap() *= x;
    r.unwrap()
}

fn main() {}
