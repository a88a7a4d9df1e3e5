//! Iterators that have a name before they are used up.

use ad::differentiable;

use crate::oracle::check;

const WEIGHTS: [f64; 3] = [0.5, 2.0, 1.5];

/// With what is computed in between, which closures of both may name alike.
#[differentiable]
fn paired(x: f64, y: f64) -> f64 {
    let xs = [x, y, x * y];
    let pairs = xs.iter().zip(&WEIGHTS).enumerate();
    let scale = xs.iter().map(|x| x * 2.0).sum::<f64>();
    pairs.map(|t| t.1.0 * t.1.1 * scale + t.0 as f64 * x).sum()
}

/// In one of two ways, and over numbers from the last.
#[differentiable]
fn chosen(x: f64, y: f64) -> f64 {
    let xs = [x, y, x * y];
    let positive = xs.iter().map(|x| x * y).filter(|x| *x > 0.0);
    let indices = (0..xs.len()).rev();
    let mut sum = if x > 1.0 {
        positive.fold(0.0, |sum, x| sum + x * x)
    } else {
        positive.map(|x| x + 1.0).product()
    };
    for i in indices {
        sum = sum * 0.5 + xs[i] * x;
    }
    sum
}

/// One name for each stage, and a list that changes when the iterator is used up.
#[differentiable]
fn staged(x: f64, y: f64) -> f64 {
    let mut xs = vec![x, y, x * y];
    let some = xs.iter().copied().take(2);
    let some = some.map(|x| x.sin() * y);
    let some = some.rev();
    let sum = some.fold(0.5, |sum, x| sum * x + 1.0);
    let doubled: Vec<f64> = {
        let doubled = xs.iter().map(|x| x * 2.0);
        doubled.collect()
    };
    xs[0] = 5.0;
    sum * doubled[0] * doubled[1] + xs[0] * xs[2]
}

#[test]
fn iterators_with_names() {
    check!(paired(x, y) at [1.3, 0.4], [0.7, -1.1], [2.6, 1.9]);
    check!(chosen(x, y) at [1.3, 0.4], [0.7, -1.1], [-0.6, 1.9]);
    check!(staged(x, y) at [1.3, 0.4], [0.7, -1.1], [-0.6, 1.9]);
}
