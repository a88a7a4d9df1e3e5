//! `..` amid the patterns of tuples and slices.

use crate::oracle::check;
use ad::differentiable;

#[differentiable]
fn triple(x: f64, y: f64) -> (f64, usize, f64, f64) {
    (x * y, 3, y.sin(), x * x)
}

/// The elements behind `..` are counted from the end.
#[differentiable]
fn behind_the_rest(x: f64, y: f64) -> f64 {
    let (first, .., last) = triple(x, y);
    let (.., before, _) = triple(y, x);
    let nested = ((x, y, 1.0), Some((y, x * y, x)));
    let ((.., ref b, _), chosen) = nested;
    let picked = match chosen {
        Some((.., middle, end)) if end > 0.0 => middle * end,
        Some((start, ..)) => start,
        None => x,
    };
    let bodies = [(x, y, x * y), (y, 2.0, x)];
    let mut sum = 0.0;
    for &(mass, .., position) in &bodies {
        sum += mass * position;
    }
    for (mass, .., position) in bodies.iter() {
        sum += mass * position * x;
    }
    for (i, .., (a, .., c)) in (0..2).zip([1, 2]).zip(bodies).map(|((i, j), body)| (i, j, body)) {
        sum += a * c * i as f64;
    }
    for (.., (a, ..)) in (0..2).zip(&bodies) {
        sum += a * a;
    }
    let weighted = |(w, .., v): (f64, f64, f64)| w * v;
    first * last + before * b + picked * sum + weighted((x, 1.0, y))
}

#[differentiable]
fn with_vectors((head, .., tail): (f64, usize, Vec<f64>), x: f64) -> f64 {
    head * tail[0] * x + tail.iter().sum::<f64>()
}

#[differentiable]
fn a_vector_behind_the_rest(x: f64, y: f64) -> f64 {
    with_vectors((x * y, 1, vec![x, y]), y)
}

#[differentiable]
fn of_a_slice(x: f64, y: f64) -> f64 {
    let (one, several) = (vec![x * y], vec![x, 2.0, y]);
    let first = match one.as_slice() {
        [] => 0.0,
        [only] => only * only,
        [head, ..] => head * y,
    };
    match several.as_slice() {
        [head, rest @ ..] => first * head + rest[1] * rest.iter().sum::<f64>(),
        [] => first,
    }
}

#[test]
fn behind() {
    check!(behind_the_rest(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(a_vector_behind_the_rest(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(of_a_slice(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}
