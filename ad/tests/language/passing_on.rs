//! Functions that are passed on: by value, by reference, from within closures.

use ad::differentiable;

#[differentiable]
fn twice<F: Fn(f64) -> f64>(f: F, x: f64) -> f64 {
    f(f(x))
}
#[differentiable]
fn once(f: &impl Fn(f64) -> f64, x: f64) -> f64 {
    f(x)
}
#[differentiable]
fn outer<F: Fn(f64) -> f64>(f: F, x: f64) -> f64 {
    let g = |t: f64| f(t) * x;
    twice(&f, x)
        + twice(&g, x)
        + once(&f, x)
        + once(&g, 0.5)
        + twice(|t| twice(&f, t) * 0.5, x)
        + g(2.0)
}
#[differentiable]
fn by_reference<F: Fn(f64) -> f64>(f: &F, x: f64) -> f64 {
    twice(f, x) + once(f, x) + twice(|t| once(f, t), x)
}
#[differentiable]
fn passed(x: f64, y: f64) -> f64 {
    let s = |t: f64| (t * y).sin();
    outer(s, x)
        + outer(&s, y)
        + by_reference(&s, x)
        + twice(&f64::tanh, x)
        + twice(&|t: f64| t * x, y)
}
#[test]
fn references_to_functions() {
    use crate::oracle::check;

    check!(passed(x, y) at [0.7, 0.4], [-0.4, 0.7], [1.3, -0.2]);
}
