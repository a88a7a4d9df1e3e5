use ad::differentiable;

#[differentiable]
fn f(x: &&mut f64) -> f64 {
    **x
}

#[differentiable]
fn g(mut x: &mut f64, (a, _): &mut (f64, f64)) -> f64 {
    *x * *a
}

#[differentiable]
fn h(x: &mut f64) -> f64 {
    let (y, _) = (x, 1.0);
    *y *= 2.0;
    *y
}

#[differentiable]
fn k(x: f64) -> f64 {
    let mut y = x;
    let (z, _) = (&mut y, 1.0);
    *z *= 2.0;
    y
}

#[differentiable]
fn optional(x: f64, state: Option<&mut f64>) -> f64 {
    match state {
        Some(state) => *state * x,
        None => x,
    }
}

fn main() {}
