use ad::differentiable;

#[differentiable]
fn std(x: &[f64]) -> f64 {
    x.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn main() {}
