use ad::differentiable;

fn read(text: &str) -> f64 {
    text.parse().unwrap()
}

fn try_read(text: &str) -> Option<f64> {
    text.parse().ok()
}

fn length(text: &str) -> usize {
    text.len()
}

#[differentiable]
fn directly(x: f64) -> f64 {
    read(&x.to_string()) * x
}

#[differentiable]
fn by_a_variable(x: f64) -> f64 {
    let text = format!("{x}");
    try_read(&text).unwrap() * x
}

#[differentiable]
fn without_a_number(x: f64) -> f64 {
    let digits = length(&format!("{x}"));
    assert!(digits > 0, "{}", x.to_string());
    println!("{} {digits}", x.to_string());
    read(&ad::stop_gradient(x).to_string()) * x
}

fn main() {
    without_a_number::grad(1.0);
}
