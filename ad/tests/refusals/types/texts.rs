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

#[differentiable]
fn chosen(x: f64) -> f64 {
    let text = if x > 0.0 { format!("{x}") } else { String::new() };
    let y: f64 = text.parse().unwrap();
    y * x
}

#[differentiable]
fn of_a_loop(x: f64) -> f64 {
    let text = loop {
        break x.to_string();
    };
    text.parse::<f64>().unwrap() * x
}

#[differentiable]
fn matched(x: f64) -> f64 {
    let Some(text) = Some(x.to_string()) else { return x };
    text.parse::<f64>().unwrap() * x
}

#[differentiable]
fn collected(x: f64) -> f64 {
    let texts: Vec<String> = [x, 2.0 * x].iter().map(|t| t.to_string()).collect();
    texts[0].parse::<f64>().unwrap() * x
}

#[differentiable]
fn items(x: f64) -> f64 {
    let mut sum = x;
    for text in vec![x.to_string()] {
        sum += text.parse::<f64>().unwrap();
    }
    sum
}

fn main() {}
