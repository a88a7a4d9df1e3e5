//! Integers that a pattern took out of a tuple: nothing tells that they are none of the numbers.

use ad::differentiable;

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
    use crate::oracle::check;

    check!(of_pairs(x, y) at [0.7, 0.4], [-0.4, 1.7]);
}
