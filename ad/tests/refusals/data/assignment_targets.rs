use ad::differentiable;

#[differentiable]
fn f(x: f64, y: f64) -> f64 {
    let (mut a, mut b) = (x, y);
    (a, b) = (b, a);
    let c;
    'outer: loop {
        loop {
            c = a * b;
            break 'outer;
        }
    }
    let part = [a, b, c];
    part[1]
}

#[differentiable]
fn in_an_index(xs: &[f64]) -> f64 {
    let mut k = 0;
    xs[{
        k = 1;
        k
    }]
}

#[differentiable]
fn of_maps(x: f64, #[constant] keys: &[u32]) -> f64 {
    let mut sums = std::collections::HashMap::new();
    for key in keys {
        *sums.entry(*key).or_insert(0.0) += x;
    }
    x
}

#[differentiable]
fn of_options(x: f64) -> f64 {
    let mut option = None;
    *option.insert(x) += x;
    option.unwrap()
}

fn main() {
    f::grad(1.0, 2.0);
}
