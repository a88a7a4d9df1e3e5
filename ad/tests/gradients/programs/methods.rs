//! Numerical methods: minimisers, root finders, clusters, events, options, a network.

use ad::{Differentiable, differentiable};

#[differentiable]
fn banana(p: &[f64], a: f64) -> f64 {
    (a - p[0]).powi(2) + 10.0 * (p[1] - p[0] * p[0]).powi(2)
}

/// One step of the method of Nelder and Mead.
#[differentiable]
fn simplex_step<F>(f: F, simplex: &mut Vec<Vec<f64>>)
where
    F: Fn(&[f64]) -> f64,
{
    simplex.sort_by(|p, q| f(p).partial_cmp(&f(q)).unwrap());
    let n = simplex.len() - 1;
    let mut centroid = vec![0.0; n];
    for point in simplex.iter().take(n) {
        for (c, x) in centroid.iter_mut().zip(point) {
            *c += x / n as f64;
        }
    }
    let worst = simplex[n].clone();
    let along = |t: f64| -> Vec<f64> {
        centroid.iter().zip(&worst).map(|(c, w)| c + t * (w - c)).collect()
    };
    let reflected = along(-1.0);
    let value = f(&reflected);
    if value < f(&simplex[0]) {
        let expanded = along(-2.0);
        simplex[n] = if f(&expanded) < value { expanded } else { reflected };
    } else if value < f(&simplex[n - 1]) {
        simplex[n] = reflected;
    } else {
        let contracted = along(0.5);
        if f(&contracted) < f(&worst) {
            simplex[n] = contracted;
        } else {
            for i in 1..=n {
                for j in 0..n {
                    simplex[i][j] = 0.5 * (simplex[i][j] + simplex[0][j]);
                }
            }
        }
    }
}

#[differentiable]
fn minimised(x: f64, y: f64) -> f64 {
    let mut simplex = vec![vec![x, y], vec![x + 0.5, y], vec![x, y + 0.5]];
    for _ in 0..6 {
        simplex_step(|p| banana(p, x * y), &mut simplex);
    }
    banana(&simplex[0], 1.0) + simplex[1][0] * simplex[2][1]
}

/// Newton's method kept in brackets by bisection.
#[differentiable]
fn find_root(
    f: impl Fn(f64) -> f64,
    df: impl Fn(f64) -> f64,
    mut lo: f64,
    mut hi: f64,
) -> Result<f64, String> {
    let f_lo = f(lo);
    if f_lo * f(hi) > 0.0 {
        return Err(format!("no sign change between {lo} and {hi}"));
    }
    if f_lo > 0.0 {
        std::mem::swap(&mut lo, &mut hi);
    }
    let mut x = 0.5 * (lo + hi);
    for _ in 0..100 {
        let fx = f(x);
        if fx < 0.0 {
            lo = x;
        } else {
            hi = x;
        }
        let newton = x - fx / df(x);
        let inside = (newton - lo) * (newton - hi) < 0.0;
        let next = if inside { newton } else { 0.5 * (lo + hi) };
        if (next - x).abs() < 1e-14 {
            return Ok(next);
        }
        x = next;
    }
    Err("too many iterations".to_string())
}

#[differentiable]
fn rooted(a: f64, b: f64) -> f64 {
    let root = find_root(|x| x.powi(3) + a * x - b, |x| 3.0 * x * x + a, -3.0, 4.0);
    let other = find_root(|x| x * x + 1.0, |x| 2.0 * x, a, b);
    match (root, other) {
        (Ok(root), Err(_)) => root * a,
        (Err(message), _) => panic!("{message}"),
        _ => unreachable!(),
    }
}

/// The energy of clusters: each point counts by the nearest centre.
#[differentiable]
fn kmeans_energy(points: &[[f64; 2]], centers: &[[f64; 2]]) -> f64 {
    points
        .iter()
        .map(|p| {
            centers
                .iter()
                .map(|c| (p[0] - c[0]).powi(2) + (p[1] - c[1]).powi(2))
                .fold(f64::INFINITY, f64::min)
        })
        .sum()
}

/// One step of Lloyd's method.
#[differentiable]
fn kmeans_step(points: &[[f64; 2]], centers: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut sums = vec![[0.0; 2]; centers.len()];
    let mut counts = vec![0; centers.len()];
    for p in points {
        let (nearest, _) = centers
            .iter()
            .enumerate()
            .map(|(i, c)| (i, (p[0] - c[0]).hypot(p[1] - c[1])))
            .min_by(|a, b| a.1.partial_cmp(&b.1).unwrap())
            .unwrap();
        counts[nearest] += 1;
        sums[nearest][0] += p[0];
        sums[nearest][1] += p[1];
    }
    sums.iter()
        .zip(&counts)
        .map(|(s, &n)| if n > 0 { [s[0] / n as f64, s[1] / n as f64] } else { *s })
        .collect()
}

#[differentiable]
fn clustered(x: f64, y: f64) -> f64 {
    let points = [[x, y], [1.0, x * y], [-0.5, y], [2.0, 1.0 + x], [0.1, 0.2]];
    let mut centers = vec![[x, 0.0], [1.5, y]];
    for _ in 0..2 {
        centers = kmeans_step(&points, &centers);
    }
    kmeans_energy(&points, &centers)
}

#[derive(Clone, Copy, Differentiable)]
struct Ball {
    height: f64,
    speed: f64,
}

#[derive(Clone, Copy, PartialEq, Differentiable)]
enum Event {
    Bounce { at: f64 },
    Apex(f64),
    None,
}

#[differentiable]
fn next_event(ball: &Ball, gravity: f64, dt: f64) -> Event {
    use self::Event::*;
    let to_apex = ball.speed / gravity;
    if to_apex > 0.0 && to_apex < dt {
        return Apex(to_apex);
    }
    let discriminant = ball.speed * ball.speed + 2.0 * gravity * ball.height;
    if discriminant < 0.0 {
        return None;
    }
    let at = (ball.speed + discriminant.sqrt()) / gravity;
    if at > 1e-9 && at < dt { Bounce { at } } else { None }
}

#[differentiable]
fn fly(ball: Ball, gravity: f64, t: f64) -> Ball {
    Ball {
        height: ball.height + ball.speed * t - 0.5 * gravity * t * t,
        speed: ball.speed - gravity * t,
    }
}

/// A ball that bounces, with the heights that it reached.
#[differentiable]
fn bouncing(gravity: f64, restitution: f64) -> f64 {
    let mut ball = Ball { height: 1.0, speed: 0.5 };
    let mut left = 2.0;
    let mut reached = Vec::new();
    while left > 0.0 {
        let step;
        match next_event(&ball, gravity, left) {
            Event::Bounce { at } => {
                step = at;
                ball = fly(ball, gravity, at);
                ball.height = 0.0;
                ball.speed *= -restitution;
            }
            Event::Apex(t) => {
                step = t;
                ball = fly(ball, gravity, t);
                reached.push(ball.height);
                ball.speed = 0.0;
            }
            Event::None => {
                step = left;
                ball = fly(ball, gravity, left);
            }
        }
        left -= step;
    }
    reached.iter().sum::<f64>() + ball.height * ball.speed
}

#[differentiable]
fn norm_cdf(x: f64) -> f64 {
    let k = 1.0 / (1.0 + 0.2316419 * x.abs());
    let poly = k
        * (0.319381530
            + k * (-0.356563782 + k * (1.781477937 + k * (-1.821255978 + k * 1.330274429))));
    let pdf = (-0.5 * x * x).exp() / (2.0 * std::f64::consts::PI).sqrt();
    if x >= 0.0 { 1.0 - pdf * poly } else { pdf * poly }
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Call,
    Put,
}

#[differentiable]
fn black_scholes(#[constant] kind: Kind, s: f64, k: f64, t: f64, r: f64, sigma: f64) -> f64 {
    let d1 = ((s / k).ln() + (r + 0.5 * sigma.powi(2)) * t) / (sigma * t.sqrt());
    let d2 = d1 - sigma * t.sqrt();
    let discount = (-r * t).exp();
    match kind {
        Kind::Call => s * norm_cdf(d1) - k * discount * norm_cdf(d2),
        Kind::Put => k * discount * norm_cdf(-d2) - s * norm_cdf(-d1),
    }
}

#[differentiable]
fn straddle(spot: f64, sigma: f64) -> f64 {
    black_scholes(Kind::Call, spot, 1.0, 0.5, 0.03, sigma)
        + black_scholes(Kind::Put, spot, 1.1, 0.7, 0.03, sigma)
}

#[derive(Clone, Differentiable)]
struct Layer {
    weights: Vec<Vec<f64>>,
    biases: Vec<f64>,
}

#[derive(Clone, Differentiable)]
struct Network {
    layers: Vec<Layer>,
}

#[differentiable]
impl Layer {
    fn forward(&self, input: &[f64], activation: impl Fn(f64) -> f64) -> Vec<f64> {
        let mut output = Vec::with_capacity(self.biases.len());
        for (row, bias) in self.weights.iter().zip(&self.biases) {
            let sum: f64 = row.iter().zip(input).map(|(w, x)| w * x).sum();
            output.push(activation(sum + bias));
        }
        output
    }
}

#[differentiable]
impl Network {
    fn predict(&self, input: &[f64]) -> Vec<f64> {
        let mut x = input.to_vec();
        for (i, layer) in self.layers.iter().enumerate() {
            if i + 1 < self.layers.len() {
                x = layer.forward(&x, f64::tanh);
            } else {
                x = layer.forward(&x, |v: f64| v);
            }
        }
        x
    }
}

#[differentiable]
fn softmax_loss(network: &Network, inputs: &[Vec<f64>], labels: &[usize]) -> f64 {
    let mut loss = 0.0;
    for (x, &label) in inputs.iter().zip(labels) {
        let scores = network.predict(x);
        let max = scores.iter().cloned().fold(f64::NEG_INFINITY, f64::max);
        let sum: f64 = scores.iter().map(|s| (s - max).exp()).sum();
        loss += sum.ln() + max - scores[label];
    }
    loss / inputs.len() as f64
}

#[differentiable]
fn trained(x: f64, y: f64) -> f64 {
    let network = Network {
        layers: vec![
            Layer {
                weights: vec![vec![x, 0.2], vec![y, -0.4], vec![0.3, x * y]],
                biases: vec![0.1; 3],
            },
            Layer { weights: vec![vec![0.5, y, -0.2], vec![x, 0.1, 0.7]], biases: vec![x, y] },
        ],
    };
    softmax_loss(&network, &[vec![1.0, 0.5], vec![-0.3, y]], &[1, 0])
}

#[test]
fn methods() {
    use crate::oracle::check;

    check!(minimised(x, y) at [1.3, 0.7], [0.4, -1.2]);
    check!(rooted(a, b) at [1.3, 0.7], [0.4, 1.2]);
    check!(clustered(x, y) at [1.3, 0.7], [0.4, -1.2]);
    check!(bouncing(g, e) at [9.81, 0.7], [5.0, 0.8]);
    check!(straddle(s, sigma) at [1.05, 0.3], [0.8, 0.2]);
    check!(trained(x, y) at [1.3, 0.7], [0.4, -1.2]);
}
