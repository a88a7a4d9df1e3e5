//! The log-likelihood of a Gaussian mixture model with a Wishart prior.

use std::f64::consts::PI;
use std::path::Path;

use ad::differentiable;

use crate::Comparison;
use crate::read::{Numbers, reference};

#[differentiable]
fn log_sum_exp(xs: &[f64]) -> f64 {
    let max = xs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let sum: f64 = xs.iter().map(|x| (x - max).exp()).sum();
    max + sum.ln()
}

/// The logarithm of the multivariate gamma function at half integers.
fn log_gamma(a: f64, p: usize) -> f64 {
    // From x = 1/2 or 1 upwards.
    let scalar = |x: f64| {
        let start = if x.fract() == 0.5 { 0.5 } else { 1.0 };
        let first = if start == 0.5 { 0.5 * PI.ln() } else { 0.0 };
        first + (0..(x - start) as usize).map(|i| (start + i as f64).ln()).sum::<f64>()
    };
    let p = p as f64;
    0.25 * p * (p - 1.0) * PI.ln()
        + (0..p as usize).map(|j| scalar(a - 0.5 * j as f64)).sum::<f64>()
}

/// A triangular factor of an inverse covariance, whose diagonal comes as logarithms, times a vector.
#[differentiable]
fn factor_times(factor: &[f64], x: &[f64]) -> Vec<f64> {
    let d = x.len();
    let mut out: Vec<f64> = x.iter().zip(factor).map(|(x, q)| x * q.exp()).collect();
    let mut index = d;
    for i in 0..d {
        for j in i + 1..d {
            out[j] += factor[index] * x[i];
            index += 1;
        }
    }
    out
}

#[differentiable]
fn objective(
    weights: &[f64],
    means: &[Vec<f64>],
    factors: &[Vec<f64>],
    points: &[Vec<f64>],
    gamma: f64,
    m: usize,
) -> f64 {
    let (n, k, d) = (points.len(), weights.len(), points[0].len());
    let log_dets: Vec<f64> = factors.iter().map(|factor| factor[..d].iter().sum::<f64>()).collect();
    let mut total = -(n as f64) * d as f64 * 0.5 * (2.0 * PI).ln();
    for point in points {
        let mut terms = Vec::with_capacity(k);
        for (i, mean) in means.iter().enumerate() {
            let centered: Vec<f64> = point.iter().zip(mean).map(|(x, m)| x - m).collect();
            let scaled = factor_times(&factors[i], &centered);
            let square: f64 = scaled.iter().map(|x| x * x).sum();
            terms.push(weights[i] + log_dets[i] - 0.5 * square);
        }
        total += log_sum_exp(&terms);
    }
    total -= n as f64 * log_sum_exp(weights);

    let degrees = (d + m + 1) as f64;
    let constant = ad::no_diff(|| {
        degrees * d as f64 * (gamma.ln() - 0.5 * 2.0_f64.ln()) - log_gamma(0.5 * degrees, d)
    });
    for (factor, log_det) in factors.iter().zip(&log_dets) {
        let diagonal: f64 = factor[..d].iter().map(|q| q.exp() * q.exp()).sum();
        let below: f64 = factor[d..].iter().map(|l| l * l).sum();
        total += 0.5 * gamma * gamma * (diagonal + below) - m as f64 * log_det - constant;
    }
    total
}

pub fn compare(input: &Path) -> Comparison {
    let mut numbers = Numbers::of_file(input);
    let [d, k, n] = numbers.sizes();
    let weights = numbers.take(k);
    let means = numbers.rows(k, d);
    let factors = numbers.rows(k, d * (d + 1) / 2);
    let points = numbers.rows(n, d);
    let gamma = numbers.take(1)[0];
    let [m] = numbers.sizes();
    let (value, (by_weights, by_means, by_factors, ..)) =
        objective::value_and_grad(&weights, &means, &factors, &points, gamma, m);
    Comparison {
        value,
        derivatives: [by_weights, by_means.concat(), by_factors.concat()].concat(),
        expected_value: reference(input, "objective")[0],
        expected: reference(input, "gradient"),
    }
}
