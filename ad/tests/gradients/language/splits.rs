//! Slices in two parts.

use ad::differentiable;
#[differentiable]
fn total(xs: &[f64]) -> f64 {
    match xs.split_first() {
        Some((first, rest)) => first * first + 0.5 * total(rest).sin(),
        None => 1.0,
    }
}
#[differentiable]
fn split(x: f64, y: f64) -> f64 {
    let mut v = vec![x, y, x * y, 1.0 + x, 2.0];
    let n = v.len();
    {
        let (left, right) = v.split_at_mut(n / 2);
        for i in 0..left.len() {
            left[i] += right[i] * right[2];
            right[i] *= left[i];
        }
        right[2] = left[0];
    }
    let (head, tail) = v.split_first_mut().unwrap();
    for t in tail.iter_mut() {
        *t += *head * 0.5;
        *head += *t;
    }
    let (last, init) = v.split_last_mut().expect("is not empty");
    *last += init[0].sin();
    init[1] = *last;
    let mut sum = total(&v);
    if let Some((last, init)) = v.split_last() {
        sum += last * init[0];
    }
    let (a, b) = v.split_at(2);
    sum + a[1] * b[0]
}
#[test]
fn parts() {
    use crate::oracle::check;

    check!(split(x, y) at [0.7, 0.4], [-0.4, 0.7], [1.3, -0.2]);
}
