//! Constructs in one function that elsewhere are tested by themselves.

use ad::{Differentiable, Mask, Real, differentiable};

use crate::oracle::assert_gradient;

#[differentiable]
fn integer_sums(x: f64, n: usize) -> f64 {
    let s: usize = (0..n).map(|i| i * i).sum();
    let p = (1..=n).product::<usize>();
    let c = (0..n).fold(0, |a, i| a + i % 3);
    let m: Vec<usize> = (0..n).filter(|i| i % 2 != 1).collect();
    x * s as f64
        + x * x * p as f64
        + c as f64 * x
        + m.iter().map(|&k| x.powi(k as i32)).sum::<f64>()
}

#[derive(Clone, Differentiable)]
struct Layer {
    weights: Vec<f64>,
    bias: f64,
}

#[differentiable]
impl Layer {
    fn apply(&self, xs: &[f64]) -> f64 {
        let mut total = self.bias;
        for (w, x) in self.weights.iter().zip(xs) {
            total += w * x;
        }
        total.tanh()
    }
}

#[differentiable]
fn network(layers: &[Layer], xs: &[f64]) -> f64 {
    layers.iter().map(|layer| layer.apply(xs)).sum::<f64>()
        + layers[0].weights.iter().zip(&layers[1].weights[1..]).map(|(a, b)| a * b).sum::<f64>()
}

#[differentiable]
fn shifted(xs: &[f64]) -> f64 {
    let n = xs.len();
    let mut t: f64 = xs[1..].iter().zip(&xs[..n - 1]).map(|(b, a)| (b - a).powi(2)).sum();
    for (i, (a, b)) in xs.iter().zip(xs.iter().rev()).enumerate() {
        t += a * b * i as f64;
    }
    for ((a, b), c) in xs.iter().zip(&xs[1..]).zip(&xs[2..]) {
        t += a * b * c;
    }
    let mut stack = vec![xs[0], xs[1]];
    while let Some(top) = stack.pop() {
        t += top * top;
        if t < 20.0 && stack.len() < 5 {
            stack.push(top * 0.5 + 0.3);
            if t > 10.0 {
                continue;
            }
            stack.push(top + 1.0);
        }
    }
    'rows: for (i, x) in xs.iter().enumerate() {
        for y in xs {
            match (x * y > 1.0, i) {
                (true, 0) => continue 'rows,
                (true, _) if *y > 2.0 => break 'rows,
                _ => t += x - y * 0.5,
            }
        }
    }
    t
}

#[differentiable]
fn generic<S: Real + std::iter::Sum>(xs: [S; 3], y: S) -> S {
    let a = xs.iter().copied().fold(S::ZERO, |a, x| a * y + x);
    let b: S = xs.iter().map(|x| *x * y).sum();
    let [c, d, _] = xs.map(|x| x * a);
    let mut e = a + b + c + d;
    while e.cmplt(S::from_f64(50.0)).all() {
        e = e * S::from_f64(1.5) + y * y;
    }
    e
}

#[differentiable]
fn ranges(x: f64, n: usize, m: i64) -> f64 {
    let mut a = x;
    for i in (0..=n).step_by(2) {
        a += x * i as f64;
    }
    for i in (0..=n).rev().skip(1) {
        a *= 1.0 + 0.01 * x * i as f64;
    }
    for i in (0..m).step_by(2) {
        a += x.sin() * i as f64;
    }
    for (i, j) in (0..m).zip(2..) {
        a += x.sin() * (i * j) as f64;
    }
    for i in (0..n).cycle().take(7) {
        a += x.cos() * i as f64;
    }
    for c in 'a'..='d' {
        a = a * 0.9 + x * (c as u32 - 96) as f64;
    }
    a
}

#[test]
fn mixtures() {
    let (g, _) = integer_sums::grad(1.2, 5);
    assert_gradient("integer_sums", |x| integer_sums(x[0], 5), &[1.2], &[g]);
    let layers = |p: &[f64]| {
        vec![
            Layer { weights: p[0..3].to_vec(), bias: p[3] },
            Layer { weights: p[4..7].to_vec(), bias: p[7] },
        ]
    };
    let p = [0.1, 0.2, 0.3, 0.4, -0.5, 0.6, 0.7, -0.8, 0.3, 0.4, 0.5];
    let (l, x) = network::grad(&layers(&p), &p[8..]);
    let mut g = vec![];
    for t in l {
        g.extend(t.weights);
        g.push(t.bias);
    }
    g.extend(x);
    assert_gradient("network", |p| network(&layers(p), &p[8..]), &p, &g);
    let xs = [0.3, 1.2, -0.7, 2.1];
    assert_gradient("shifted", shifted, &xs, &shifted::grad(&xs));
    let (a, b) = generic::grad([0.3, 0.4, 0.5], 1.2);
    assert_gradient(
        "generic",
        |p| generic([p[0], p[1], p[2]], p[3]),
        &[0.3, 0.4, 0.5, 1.2],
        &[a[0], a[1], a[2], b],
    );
    let (g, ..) = ranges::grad(0.7, 5, 6);
    assert_gradient("ranges", |x| ranges(x[0], 5, 6), &[0.7], &[g]);
}
