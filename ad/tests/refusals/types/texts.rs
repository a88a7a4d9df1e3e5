use ad::differentiable;

#[differentiable]
fn by_bits(x: f64) -> f64 {
    let bits: u64 = x.to_bits();
    x + bits as f64
}

#[differentiable]
fn by_text(x: f64) -> f64 {
    let text = (x * x).to_string();
    let y: f64 = text.parse().unwrap();
    y * x
}

fn show(x: f64) -> String {
    format!("{x}")
}

#[differentiable]
fn by_a_function(x: f64) -> f64 {
    let text: String = show(x);
    text.parse::<f64>().unwrap() * x
}

#[differentiable]
fn formatted(x: f64) -> f64 {
    let y: f64 = format!("{x:?}").parse().unwrap();
    y * x
}

fn main() {}
