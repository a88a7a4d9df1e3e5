use ad::differentiable;

#[differentiable]
fn twice<F: Fn(f64) -> f64>(f: F, x: f64) -> f64 {
    f(f(x))
}

#[differentiable]
fn behind_a_reference(x: f64, f: &mut impl FnMut(f64) -> f64) -> f64 {
    f(x)
}

#[differentiable]
fn changing(x: f64, mut f: impl FnMut(f64) -> f64) -> f64 {
    f(x)
}

#[differentiable]
fn passed_behind_a_reference(x: f64, mut f: impl FnMut(f64) -> f64) -> f64 {
    changing(x, &mut f) + changing(x, f)
}

#[differentiable]
fn without_types(x: f64) -> f64 {
    twice(|t| t * x, x)
}

#[differentiable]
fn counting(x: f64) -> f64 {
    let mut count = 0.0;
    let y = twice(
        |t: f64| {
            count += 1.0;
            t * x
        },
        x,
    );
    y * count
}

#[differentiable(checkpoint)]
fn recomputed(f: impl Fn(f64) -> f64, x: f64) -> f64 {
    f(x)
}

#[differentiable]
fn pointer(f: fn(f64) -> f64, x: f64) -> f64 {
    f(x)
}

fn main() {}
