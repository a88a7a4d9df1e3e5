//! Filters, regressions, prices.

use ad::{Differentiable, differentiable};

use crate::oracle::{assert_gradient, check};

/// The distribution function of the normal distribution (Abramowitz & Stegun 26.2.17).
#[differentiable]
fn normal_cdf(x: f64) -> f64 {
    const B: [f64; 5] = [0.319381530, -0.356563782, 1.781477937, -1.821255978, 1.330274429];
    if x < 0.0 {
        return 1.0 - normal_cdf(-x);
    }
    let t = 1.0 / (1.0 + 0.2316419 * x);
    let poly = B.iter().rev().fold(0.0, |acc, b| (acc + b) * t);
    1.0 - (-0.5 * x * x).exp() / (2.0 * std::f64::consts::PI).sqrt() * poly
}

#[derive(Clone, Copy, PartialEq, Differentiable)]
enum OptionKind {
    Call,
    Put,
}

#[differentiable]
fn black_scholes(kind: OptionKind, spot: f64, strike: f64, vol: f64, rate: f64, t: f64) -> f64 {
    let std = vol * t.sqrt();
    let d1 = ((spot / strike).ln() + (rate + vol * vol / 2.0) * t) / std;
    let d2 = d1 - std;
    let discount = (-rate * t).exp();
    match kind {
        OptionKind::Call => spot * normal_cdf(d1) - strike * discount * normal_cdf(d2),
        OptionKind::Put => strike * discount * normal_cdf(-d2) - spot * normal_cdf(-d1),
    }
}

#[differentiable]
fn straddle(spot: f64, vol: f64) -> f64 {
    let mut value = 0.0;
    for kind in [OptionKind::Call, OptionKind::Put] {
        value += black_scholes(kind, spot, 1.1, vol, 0.02, 1.5);
    }
    value
}

fn sigmoid_plain(x: f64) -> f64 {
    1.0 / (1.0 + (-x).exp())
}

#[differentiable(vjp = sigmoid_vjp)]
fn sigmoid(x: f64) -> f64 {
    sigmoid_plain(x)
}

fn sigmoid_vjp(x: f64) -> (f64, impl FnOnce(f64) -> f64) {
    let s = sigmoid_plain(x);
    (s, move |g| g * s * (1.0 - s))
}

struct Dataset {
    features: Vec<Vec<f64>>,
    labels: Vec<bool>,
}

#[differentiable]
fn logistic_loss(
    weights: &[f64],
    bias: f64,
    features: &[Vec<f64>],
    labels: &[bool],
    lambda: f64,
) -> f64 {
    let mut loss = 0.0;
    for (x, &label) in features.iter().zip(labels) {
        let z: f64 = x.iter().zip(weights).map(|(a, b)| a * b).sum::<f64>() + bias;
        let p = sigmoid(z);
        loss -= if label { p.ln() } else { (1.0 - p).ln() };
    }
    loss / labels.len() as f64 + lambda * weights.iter().map(|w| w.powi(2)).sum::<f64>()
}

type Matrix = [[f64; 2]; 2];

#[differentiable]
fn mat_mul(a: &Matrix, b: &Matrix) -> Matrix {
    let mut c = [[0.0; 2]; 2];
    for i in 0..2 {
        for j in 0..2 {
            for k in 0..2 {
                c[i][j] += a[i][k] * b[k][j];
            }
        }
    }
    c
}

#[differentiable]
fn transpose(a: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| a[j][i]))
}

/// The negative log-likelihood of a constant-velocity Kalman filter.
#[differentiable]
fn kalman(process_noise: f64, measurement_noise: f64) -> f64 {
    let measurements = [0.1, 0.32, 0.44, 0.71, 0.87, 1.2, 1.13];
    let dt = 0.5;
    let f: Matrix = [[1.0, dt], [0.0, 1.0]];
    let q: Matrix = [
        [process_noise * dt.powi(3) / 3.0, process_noise * dt.powi(2) / 2.0],
        [process_noise * dt.powi(2) / 2.0, process_noise * dt],
    ];
    let mut x = [0.0, 0.0];
    let mut p: Matrix = [[1.0, 0.0], [0.0, 1.0]];
    let mut nll = 0.0;
    for &z in measurements.iter() {
        // Predict.
        x = [x[0] + dt * x[1], x[1]];
        p = mat_mul(&mat_mul(&f, &p), &transpose(&f));
        for (row, noise) in p.iter_mut().zip(&q) {
            for (entry, n) in row.iter_mut().zip(noise) {
                *entry += n;
            }
        }
        // Update.
        let innovation = z - x[0];
        let s = p[0][0] + measurement_noise;
        let gain = [p[0][0] / s, p[1][0] / s];
        for i in 0..2 {
            x[i] += gain[i] * innovation;
        }
        let ikh: Matrix = [[1.0 - gain[0], 0.0], [-gain[1], 1.0]];
        p = mat_mul(&ikh, &p);
        nll += 0.5 * (innovation * innovation / s + s.ln());
    }
    nll
}

#[differentiable]
fn cholesky_log_det(a: &[Vec<f64>]) -> Option<f64> {
    let n = a.len();
    let mut l = vec![vec![0.0; n]; n];
    for i in 0..n {
        for j in 0..=i {
            let mut sum = a[i][j];
            for k in 0..j {
                sum -= l[i][k] * l[j][k];
            }
            if i == j {
                if sum <= 0.0 {
                    return None;
                }
                l[i][j] = sum.sqrt();
            } else {
                l[i][j] = sum / l[j][j];
            }
        }
    }
    Some((0..n).map(|i| 2.0 * l[i][i].ln()).sum())
}

#[differentiable]
fn gaussian_process(x: f64, y: f64) -> f64 {
    let points = [0.0, 0.4, 1.1, 1.9];
    let mut k = vec![vec![0.0; 4]; 4];
    for (i, a) in points.iter().enumerate() {
        for (j, b) in points.iter().enumerate() {
            let d = (a - b) / x;
            k[i][j] = y * y * (-0.5 * d * d).exp() + if i == j { 0.1 } else { 0.0 };
        }
    }
    cholesky_log_det(&k).unwrap_or(f64::INFINITY)
}

/// Variance by Welford's method, and a t-like statistic.
#[differentiable]
fn statistic(samples: &[f64], expected: f64) -> f64 {
    let (mut mean, mut m2, mut n) = (0.0, 0.0, 0);
    for x in samples {
        n += 1;
        let delta = x - mean;
        mean += delta / n as f64;
        m2 += delta * (x - mean);
    }
    let variance = m2 / (n - 1) as f64;
    (mean - expected) / (variance / n as f64).sqrt()
}

#[differentiable]
fn log_sum_exp(xs: &[f64]) -> f64 {
    let max = xs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let sum: f64 = xs.iter().map(|x| (x - max).exp()).sum();
    max + sum.ln()
}

#[differentiable]
fn softmax(xs: &[f64]) -> Vec<f64> {
    let lse = log_sum_exp(xs);
    xs.iter().map(|x| (x - lse).exp()).collect()
}

#[differentiable]
fn cross_entropy(logits: &[f64], target: usize) -> f64 {
    -softmax(logits)[target].ln()
}

#[test]
fn statistics() {
    check!(straddle(spot, vol) at [1.0, 0.2], [1.4, 0.35], [0.8, 0.6]);
    check!(kalman(q, r) at [0.1, 0.05], [1.0, 0.4]);
    check!(gaussian_process(x, y) at [0.8, 1.2], [0.3, 0.6]);

    let data = Dataset {
        features: vec![vec![0.5, 1.2], vec![-0.3, 0.8], vec![1.5, -0.7]],
        labels: vec![true, false, true],
    };
    let primal = |p: &[f64]| logistic_loss(&p[..2], p[2], &data.features, &data.labels, p[3]);
    let point = [0.3, -0.4, 0.1, 0.01];
    let (w, b, features, _, l) =
        logistic_loss::grad(&point[..2], point[2], &data.features, &data.labels, point[3]);
    assert_gradient("logistic_loss", primal, &point, &[w[0], w[1], b, l]);
    assert_eq!(features.len(), 3);

    let samples = [0.3, 1.2, 0.7, 0.5, 1.9];
    let (to_samples, to_expected) = statistic::grad(&samples, 0.4);
    let primal = |p: &[f64]| statistic(&p[..5], p[5]);
    let point = [&samples[..], &[0.4]].concat();
    assert_gradient("statistic", primal, &point, &[&to_samples[..], &[to_expected]].concat());
    let (gradient, ()) = cross_entropy::grad(&samples, 2);
    assert_gradient("cross_entropy", |p| cross_entropy(p, 2), &samples, &gradient);
}
