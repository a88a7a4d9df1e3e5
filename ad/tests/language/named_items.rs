//! Items of iterators that are tuples and have one name, `|t| t.0 * t.1`: parts of them may be references.

use ad::differentiable;

use crate::oracle::check;

const WEIGHTS: [f64; 3] = [0.5, 2.0, 1.5];

#[differentiable]
fn folded(x: f64, y: f64) -> f64 {
    let xs = [x, y, x * y];
    let series =
        WEIGHTS.iter().enumerate().skip(1).fold(WEIGHTS[0], |sum, t| sum + t.1 / (x + t.0 as f64));
    xs.iter().enumerate().fold(series, |sum, t| sum + t.1 * y + t.1 * t.1 / (1.0 + t.0 as f64))
}

#[differentiable]
fn paired(x: f64, y: f64) -> f64 {
    let xs = [x, y, x * y];
    let products: f64 = xs.iter().zip(&xs[1..]).map(|pair| pair.0 * pair.1 - x).sum();
    let mut sum = products;
    for pair in xs.iter().zip(WEIGHTS.iter()) {
        sum += pair.1 * pair.0 * *pair.0;
    }
    sum
}

/// Tuples in tuples, shown to a predicate as well, and copies.
#[differentiable]
fn chosen(x: f64, y: f64) -> f64 {
    let xs = [x, y, x * y];
    let some: f64 = WEIGHTS
        .iter()
        .zip(&xs)
        .enumerate()
        .filter(|t| *t.1.0 > 1.0 && t.0 > 0)
        .map(|t| t.1.0 * t.1.1.sin() - x * (t.0 as f64))
        .sum();
    xs.iter()
        .copied()
        .zip(WEIGHTS)
        .filter(|t| t.0 > 0.0 && t.1 < 1.8)
        .map(|t| t.0 * t.0 * t.1)
        .fold(some, |sum, t| sum + t * y)
}

/// Elements that are changed, and a name that means something else within.
#[differentiable]
fn changed(x: f64, y: f64) -> f64 {
    let mut xs = [x, y, x * y];
    for t in xs.iter_mut().zip(WEIGHTS.iter()) {
        *t.0 *= t.1 * x;
    }
    for t in xs.iter_mut().enumerate() {
        let scale = |t: (f64, f64)| t.0 * t.1;
        if t.0 > 0 {
            *t.1 += scale((x, y));
        }
    }
    let shadowed = xs.iter().enumerate().fold(0.0, |sum, t| {
        let t = (t.1 * x, t.0 as f64);
        sum + t.0 + t.1 * y
    });
    xs[1] * xs[2] + shadowed
}

#[test]
fn items_with_one_name() {
    check!(folded(x, y) at [1.3, 0.4], [0.7, -1.1], [2.6, 1.9]);
    check!(paired(x, y) at [1.3, 0.4], [0.7, -1.1], [-0.6, 1.9]);
    check!(chosen(x, y) at [1.3, 0.4], [0.7, -1.1], [-0.6, 1.9]);
    check!(changed(x, y) at [1.3, 0.4], [0.7, -1.1], [-0.6, 1.9]);
}
