//! Values of one's own that are made of slices and of what is behind references.

use ad::differentiable;

use crate::oracle::check;

#[differentiable]
fn of_slices(xs: &[f64], vector: &Vec<f64>) -> f64 {
    let mut own = xs.to_owned();
    own[0] *= own[1] * xs[1];
    let copy = vector.to_owned();
    own[0] * copy[1] + own[1..].to_owned()[0] * copy[0]
}

#[differentiable]
fn of_values(array: [f64; 2], x: &f64) -> f64 {
    let own: [f64; 2] = array.to_owned();
    own[0] * own[1] * x.to_owned() + own[1]
}

#[differentiable]
fn owned(x: f64, y: f64) -> f64 {
    let text = "text".to_owned();
    let vector = vec![y, x * y];
    of_slices(&[x, y], &vector) * of_values([x, y], &x) + text.len() as f64
}

/// The length tells whether there is such an array.
#[differentiable]
fn first_two(xs: &[f64], len: usize) -> f64 {
    let pair: Result<[f64; 2], _> = xs[..len].try_into();
    match pair {
        Ok([a, b]) => a * b * xs[0],
        Err(_) => xs[0] * 3.0,
    }
}

#[differentiable]
fn arrays(x: f64, y: f64) -> f64 {
    let xs = vec![x, y, x * y];
    let ends: [f64; 2] = xs[1..].try_into().unwrap();
    let all: [f64; 3] = xs.clone().try_into().expect("three");
    let mut sum = 0.0;
    for len in 1..=3 {
        sum += first_two(&xs, len);
    }
    ends[0] * ends[1] * all[2] + sum
}

#[differentiable]
fn halfway(x: f64, y: f64) -> f64 {
    x.midpoint(y) * f64::midpoint(x * y, 1.0)
}

#[test]
fn copies() {
    check!(owned(x, y) at [0.7, 1.3], [-1.1, 0.4]);
}

#[test]
fn arrays_of_slices() {
    check!(arrays(x, y) at [0.7, 1.3], [-1.1, 0.4]);
}

#[test]
fn midpoints() {
    check!(halfway(x, y) at [0.7, 1.3], [-1.1, 0.4]);
}
