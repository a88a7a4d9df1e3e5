//! Integers that a pattern took out of a tuple: nothing tells that they are none of the numbers.

use std::collections::HashMap;

use ad::{NoTangent, differentiable};

use crate::oracle::{assert_forward, assert_gradient, check};

#[differentiable]
fn weighted(pairs: &[(usize, f64)], x: f64) -> f64 {
    let mut sum = 0.0;
    for (n, weight) in pairs {
        sum += n.pow(2) as f64 * weight;
    }
    for &(n, weight) in pairs {
        let power = n.min(3) + n.max(2) - 1;
        let centred = (n as i32 - 3).abs().clamp(0, 2);
        sum += weight * x.powi(power as i32) + n.saturating_sub(2) as f64 * x * centred as f64;
    }
    let (n, weight) = pairs[0];
    sum + weight * n.max(2) as f64 + pairs[n.min(1)].1 * (n.rem_euclid(2) as f64)
}

#[differentiable]
fn of_pairs(x: f64, y: f64) -> f64 {
    weighted(&[(1, x), (4, y), (0, x * y)], y)
}

#[test]
fn methods_of_integers() {
    check!(of_pairs(x, y) at [0.7, 0.4], [-0.4, 1.7]);
}

/// A map from pairs of integers, as those of a sparse matrix.
#[differentiable]
fn sparse(
    x: &[f64],
    #[constant] places: &HashMap<(usize, usize), usize>,
    #[constant] factors: &HashMap<[usize; 2], f64>,
) -> f64 {
    let mut sum = 0.0;
    for i in 0..2 {
        for j in 0..2 {
            let place = places[&(i, j)];
            let position = (i, place);
            sum = sum * x[position.0] + x[places[&(j, i)]] * factors[&[i, j]];
        }
    }
    sum * x[places[&(1, 0)]]
}

#[test]
fn pairs_of_integers() {
    let pairs = [(0, 0), (0, 1), (1, 0), (1, 1)];
    let places = pairs.into_iter().zip([2, 0, 1, 1]).collect();
    let factors = pairs.map(|(i, j)| [i, j]).into_iter().zip([0.5, 2.0, 1.5, 3.0]).collect();
    let at = [0.7, 1.3, -0.4];
    let (by_x, ..) = sparse::grad(&at, &places, &factors);
    assert_gradient("sparse", |x| sparse(x, &places, &factors), &at, &by_x);
    let value = sparse(&at, &places, &factors);
    let forward = |x: &[f64], d: &[f64]| {
        sparse::jvp(x, &places, &factors, d, NoTangent::new(), NoTangent::new())
    };
    assert_forward("sparse", forward, &at, value, &by_x);
}
