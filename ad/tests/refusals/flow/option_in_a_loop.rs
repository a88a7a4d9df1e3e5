use ad::differentiable;

#[differentiable]
fn made(x: f64) -> f64 {
    Some(x).iter().map(|y| y * y).sum()
}

#[differentiable]
fn given(option: &Option<f64>) -> f64 {
    let mut sum = 0.0;
    for value in option {
        sum += value;
    }
    sum
}

fn main() {
    made::grad(1.0);
    given::grad(&None);
}
