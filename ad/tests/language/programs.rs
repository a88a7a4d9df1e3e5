//! Programs as people write them, with what they use of the standard library.

use ad::differentiable;

use crate::oracle::assert_gradient;

#[differentiable]
fn logsumexp(xs: &[f64]) -> f64 {
    let m = xs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    m + xs.iter().map(|x| (x - m).exp()).sum::<f64>().ln()
}

#[differentiable]
fn rosenbrock(x: &[f64]) -> f64 {
    x.windows(2).map(|w| 100.0 * (w[1] - w[0].powi(2)).powi(2) + (1.0 - w[0]).powi(2)).sum()
}

#[differentiable]
fn mlp(x: &[f64], w1: &[Vec<f64>], b1: &[f64], w2: &[f64]) -> f64 {
    let hidden: Vec<f64> = w1
        .iter()
        .zip(b1)
        .map(|(row, b)| {
            let z = row.iter().zip(x).map(|(w, x)| w * x).sum::<f64>() + b;
            z.tanh()
        })
        .collect();
    hidden.iter().zip(w2.iter()).map(|(h, w)| h * w).sum::<f64>()
}

#[differentiable]
fn bisection(target: f64, mut lo: f64, mut hi: f64) -> f64 {
    let f = |x: f64| x * x * x - target;
    let mut iterations = 0;
    let root = loop {
        let mid = 0.5 * (lo + hi);
        if (hi - lo).abs() < 1e-3 || iterations >= 100 {
            break mid;
        }
        if f(mid) > 0.0 {
            hi = mid;
        } else {
            lo = mid;
        }
        iterations += 1;
    };
    root - f(root) / (3.0 * root * root)
}

#[differentiable]
fn variance(xs: &[f64]) -> f64 {
    let n = xs.len() as f64;
    let mean = xs.iter().sum::<f64>() / n;
    xs.iter().map(|&x| (x - mean).powi(2)).sum::<f64>() / (n - 1.0)
}

#[differentiable]
fn softmax_cross_entropy(logits: &[f64], label: usize) -> f64 {
    assert!(label < logits.len(), "label {label} out of range");
    let max = logits.iter().cloned().fold(f64::MIN, f64::max);
    let exps: Vec<f64> = logits.iter().map(|l| (l - max).exp()).collect();
    let sum: f64 = exps.iter().sum();
    -(exps[label] / sum).ln()
}

#[differentiable]
fn conv(signal: &[f64], kernel: &[f64]) -> f64 {
    let mut out = vec![0.0; signal.len() - kernel.len() + 1];
    for (i, o) in out.iter_mut().enumerate() {
        for (k, w) in kernel.iter().enumerate() {
            *o += signal[i + k] * w;
        }
    }
    out.iter().map(|o| o.max(0.0)).sum()
}

#[differentiable]
fn collatz_like(x: f64) -> f64 {
    let mut v = x;
    let mut steps = 0u32;
    while v > 1.0 && steps < 50 {
        v = if steps.is_multiple_of(3) { v * 0.5 } else { v * 0.9 + 0.01 };
        steps += 1;
    }
    v * f64::from(steps)
}

#[differentiable]
fn nearest(points: &[[f64; 2]], q: [f64; 2]) -> f64 {
    let mut best = f64::INFINITY;
    for p in points {
        let d2: f64 = p.iter().zip(q).map(|(a, b)| (a - b).powi(2)).sum();
        if d2 < best {
            best = d2;
        }
    }
    best.sqrt()
}

#[differentiable]
fn nearest_by(points: &[[f64; 2]], q: [f64; 2]) -> f64 {
    points
        .iter()
        .map(|p| ((p[0] - q[0]).powi(2) + (p[1] - q[1]).powi(2)).sqrt())
        .min_by(|a, b| a.total_cmp(b))
        .unwrap()
}

#[differentiable]
fn matvec(a: [[f64; 3]; 3], x: [f64; 3]) -> f64 {
    let y = a.map(|row| row.iter().zip(&x).map(|(a, b)| a * b).sum::<f64>());
    y.iter().map(|v| v * v).sum::<f64>().sqrt()
}

#[differentiable]
fn polynomial(c: &[f64], x: f64) -> f64 {
    c.iter().rev().fold(0.0, |acc, &c| acc * x + c)
}

#[differentiable]
fn trapezoid(ys: &[f64], h: f64) -> f64 {
    ys.iter().zip(ys.iter().skip(1)).map(|(a, b)| 0.5 * h * (a + b)).sum()
}

#[test]
fn programs() {
    let xs = [0.3, 1.2, -0.7, 2.1];
    assert_gradient("logsumexp", logsumexp, &xs, &logsumexp::grad(&xs));
    assert_gradient("rosenbrock", rosenbrock, &xs, &rosenbrock::grad(&xs));
    let w = [vec![0.1, 0.2, 0.3, 0.4], vec![-0.3, 0.2, 0.5, 0.9]];
    let (gx, ..) = mlp::grad(&xs, &w, &[0.1, 0.2], &[0.5, -0.6]);
    assert_gradient("mlp", |x| mlp(x, &w, &[0.1, 0.2], &[0.5, -0.6]), &xs, &gx);
    let (a, ..) = bisection::grad(2.0, 0.0, 3.0);
    assert_gradient("bisection", |x| bisection(x[0], 0.0, 3.0), &[2.0], &[a]);
    assert_gradient("variance", variance, &xs, &variance::grad(&xs));
    let (g, _) = softmax_cross_entropy::grad(&xs, 2);
    assert_gradient("softmax", |x| softmax_cross_entropy(x, 2), &xs, &g);
    let (g, _) = conv::grad(&xs, &[0.2, 0.7]);
    assert_gradient("conv", |x| conv(x, &[0.2, 0.7]), &xs, &g);
    assert_gradient("collatz", |x| collatz_like(x[0]), &[7.3], &[collatz_like::grad(7.3)]);
    let pts = [[0.1, 0.2], [1.0, 1.5], [-0.4, 0.9]];
    let (_, q) = nearest::grad(&pts, [0.5, 0.6]);
    assert_gradient("nearest", |q| nearest(&pts, [q[0], q[1]]), &[0.5, 0.6], &q);
    let (_, q) = nearest_by::grad(&pts, [0.5, 0.6]);
    assert_gradient("nearest_by", |q| nearest_by(&pts, [q[0], q[1]]), &[0.5, 0.6], &q);
    let m = [[1.0, 2.0, 0.3], [0.4, 0.5, 0.6], [0.7, -0.8, 0.9]];
    let (_, g) = matvec::grad(m, [0.2, 0.3, 0.4]);
    assert_gradient("matvec", |x| matvec(m, [x[0], x[1], x[2]]), &[0.2, 0.3, 0.4], &g);
    let (g, _) = polynomial::grad(&xs, 0.7);
    assert_gradient("polynomial", |c| polynomial(c, 0.7), &xs, &g);
    let (g, _) = trapezoid::grad(&xs, 0.7);
    assert_gradient("trapezoid", |c| trapezoid(c, 0.7), &xs, &g);
}
