use ad::differentiable;

#[differentiable]
fn f(x: f64) -> f64 {
    let k = x as i32;
    k as f64 * x
}

#[differentiable]
fn g(x: f64) -> f64 {
    let values = [x, 2.0 * x];
    values[x as usize]
}

#[differentiable]
fn h(x: f64) -> f64 {
    let k: usize = (x * 2.0) as usize;
    k as f64 * x
}

#[differentiable]
fn rounded(x: f64) -> f64 {
    let k = (x * 2.0).round() as i64 + 1;
    k as f64 * x
}

fn fixed(x: f64) -> i64 {
    (x * 65536.0) as i64
}

#[differentiable]
fn by_a_function(x: f64) -> f64 {
    let k: i64 = fixed(x);
    k as f64 / 65536.0
}

fn main() {
    f::grad(1.0);
    g::grad(1.0);
    h::grad(1.0);
    rounded::grad(1.0);
}
