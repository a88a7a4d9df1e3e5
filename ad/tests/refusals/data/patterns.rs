use ad::{Differentiable, differentiable};

#[derive(Clone, Copy, Differentiable)]
struct Triple(f64, f64, f64);

#[differentiable]
fn f(x: Triple, mut y: Option<f64>) -> f64 {
    let Triple(.., c) = x;
    let ([a, _] | [_, a]) = [c, c];
    let (d, [[e, .., g], _]) = (c, [[c; 3]; 2]);
    match y {
        Some(ref mut b) => *b * c * a * d * e * g,
        _ => 0.0,
    }
}

#[differentiable]
fn changed(pairs: &mut [(f64, f64)]) {
    for (.., b) in pairs.iter_mut() {
        *b *= 2.0;
    }
}

fn main() {
    f::grad(Triple(1.0, 2.0, 3.0), None);
}
