//! Layers, convolutions, Fourier transforms.

use ad::{Differentiable, differentiable};

use crate::oracle::{assert_gradient, check};

#[derive(Clone, Debug, Differentiable)]
struct Layer {
    weights: Vec<Vec<f64>>,
    biases: Vec<f64>,
    #[constant]
    activation: Activation,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Activation {
    Tanh,
    Relu,
    Identity,
}

#[differentiable]
impl Layer {
    fn forward(&self, input: &[f64]) -> Vec<f64> {
        let mut output = Vec::with_capacity(self.biases.len());
        for (row, bias) in self.weights.iter().zip(&self.biases) {
            let z = row.iter().zip(input).map(|(w, x)| w * x).sum::<f64>() + bias;
            output.push(match self.activation {
                Activation::Tanh => z.tanh(),
                Activation::Relu => z.max(0.0),
                Activation::Identity => z,
            });
        }
        output
    }
}

#[derive(Clone, Debug, Differentiable)]
struct Network {
    layers: Vec<Layer>,
}

#[differentiable]
impl Network {
    fn predict(&self, input: &[f64]) -> f64 {
        let mut x = input.to_vec();
        for layer in &self.layers {
            x = layer.forward(&x);
        }
        x[0]
    }

    fn loss(&self, inputs: &[Vec<f64>], targets: &[f64]) -> f64 {
        inputs
            .iter()
            .zip(targets)
            .map(|(x, t)| {
                let error = self.predict(x) - t;
                error * error
            })
            .sum::<f64>()
            / inputs.len() as f64
    }
}

/// Complex numbers as pairs: a radix-2 transform, in place.
#[differentiable]
fn fft(data: &mut [(f64, f64)]) {
    let n = data.len();
    let mut j = 0;
    for i in 1..n {
        let mut bit = n >> 1;
        while j & bit != 0 {
            j ^= bit;
            bit >>= 1;
        }
        j |= bit;
        if i < j {
            data.swap(i, j);
        }
    }
    let mut len = 2;
    while len <= n {
        let angle = -2.0 * std::f64::consts::PI / len as f64;
        for start in (0..n).step_by(len) {
            for k in 0..len / 2 {
                let (s, c) = (angle * k as f64).sin_cos();
                let (re, im) = data[start + k + len / 2];
                let (tr, ti) = (re * c - im * s, re * s + im * c);
                let (ur, ui) = data[start + k];
                data[start + k] = (ur + tr, ui + ti);
                data[start + k + len / 2] = (ur - tr, ui - ti);
            }
        }
        len *= 2;
    }
}

#[differentiable]
fn spectrum(frequency: f64, phase: f64) -> f64 {
    let mut data: Vec<(f64, f64)> =
        (0..8).map(|i| ((frequency * i as f64 + phase).sin(), 0.0)).collect();
    fft(&mut data);
    data.iter().enumerate().map(|(k, (re, im))| (re * re + im * im) * k as f64).sum()
}

/// Recursive transform, out of place.
#[differentiable]
fn fft_recursive(x: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let n = x.len();
    if n == 1 {
        return x.to_vec();
    }
    let even: Vec<(f64, f64)> = x.iter().step_by(2).copied().collect();
    let odd: Vec<(f64, f64)> = x.iter().skip(1).step_by(2).copied().collect();
    let (e, o) = (fft_recursive(&even), fft_recursive(&odd));
    let mut out = vec![(0.0, 0.0); n];
    for k in 0..n / 2 {
        let a = -2.0 * std::f64::consts::PI * k as f64 / n as f64;
        let t = (a.cos() * o[k].0 - a.sin() * o[k].1, a.cos() * o[k].1 + a.sin() * o[k].0);
        out[k] = (e[k].0 + t.0, e[k].1 + t.1);
        out[k + n / 2] = (e[k].0 - t.0, e[k].1 - t.1);
    }
    out
}

#[differentiable]
fn power(frequency: f64, phase: f64) -> f64 {
    let signal: Vec<_> = (0..8).map(|i| ((frequency * i as f64).cos(), phase)).collect();
    let transformed = fft_recursive(&signal);
    let (re, im) = transformed[3];
    re.hypot(im)
}

#[differentiable]
fn convolve(signal: &[f64], kernel: &[f64]) -> Vec<f64> {
    let mut out = vec![0.0; signal.len() + kernel.len() - 1];
    for (i, s) in signal.iter().enumerate() {
        for (j, k) in kernel.iter().enumerate() {
            out[i + j] += s * k;
        }
    }
    out
}

#[differentiable]
fn matched_filter(x: f64, y: f64) -> f64 {
    let signal = [x, y, x * y, 0.3, -y];
    let response = convolve(&signal, &[0.5, x, -0.25]);
    response.iter().copied().fold(f64::MIN, f64::max)
        + response.iter().map(|r| r * r).sum::<f64>().sqrt()
}

/// A gated recurrent unit over a sequence.
#[differentiable]
fn gru(w: &[[f64; 3]; 3], sequence: &[f64], h0: f64) -> f64 {
    let sigmoid = |x: f64| 1.0 / (1.0 + (-x).exp());
    let mut h = h0;
    for &x in sequence {
        let z = sigmoid(w[0][0] * x + w[0][1] * h + w[0][2]);
        let r = sigmoid(w[1][0] * x + w[1][1] * h + w[1][2]);
        let candidate = (w[2][0] * x + w[2][1] * (r * h) + w[2][2]).tanh();
        h = (1.0 - z) * h + z * candidate;
    }
    h
}

/// One head of attention.
#[differentiable]
fn attention(q: &[Vec<f64>], k: &[Vec<f64>], v: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let scale = 1.0 / (q[0].len() as f64).sqrt();
    let mut out = Vec::new();
    for qi in q {
        let scores: Vec<f64> =
            k.iter().map(|kj| qi.iter().zip(kj).map(|(a, b)| a * b).sum::<f64>() * scale).collect();
        let max = scores.iter().cloned().fold(f64::NEG_INFINITY, f64::max);
        let exps: Vec<f64> = scores.iter().map(|s| (s - max).exp()).collect();
        let total: f64 = exps.iter().sum();
        let mut row = vec![0.0; v[0].len()];
        for (weight, vj) in exps.iter().zip(v) {
            for (r, x) in row.iter_mut().zip(vj) {
                *r += weight / total * x;
            }
        }
        out.push(row);
    }
    out
}

#[differentiable]
fn attended(x: f64, y: f64) -> f64 {
    let a = vec![vec![x, y], vec![y * y, 0.3], vec![0.1, x - y]];
    let b = vec![vec![0.2, x], vec![y, -0.4], vec![x * y, 1.0]];
    let out = attention(&a, &b, &a);
    out.iter().flatten().map(|o| o * o).sum()
}

#[test]
fn networks() {
    check!(spectrum(f, p) at [0.7, 0.3], [1.9, -0.4]);
    check!(power(f, p) at [0.7, 0.3], [1.9, -0.4]);
    check!(matched_filter(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(attended(x, y) at [1.3, 0.7], [-0.4, 2.1]);

    let network = |p: &[f64]| Network {
        layers: vec![
            Layer {
                weights: vec![p[0..2].to_vec(), p[2..4].to_vec(), p[4..6].to_vec()],
                biases: p[6..9].to_vec(),
                activation: Activation::Tanh,
            },
            Layer {
                weights: vec![p[9..12].to_vec(), p[12..15].to_vec()],
                biases: p[15..17].to_vec(),
                activation: Activation::Relu,
            },
            Layer {
                weights: vec![p[17..19].to_vec()],
                biases: p[19..20].to_vec(),
                activation: Activation::Identity,
            },
        ],
    };
    let inputs = [vec![0.3, -0.7], vec![1.1, 0.2]];
    let targets = [0.5, -0.2];
    let point: Vec<f64> = (0..20).map(|i| ((i * 7) % 11) as f64 * 0.13 - 0.4).collect();
    let (gradient, _, _) = network(&point).loss_grad(&inputs, &targets);
    let mut flat = Vec::new();
    for layer in gradient.layers {
        flat.extend(layer.weights.into_iter().flatten());
        flat.extend(layer.biases);
    }
    let primal = |p: &[f64]| network(p).loss(&inputs, &targets);
    assert_gradient("loss", primal, &point, &flat);

    let w = [[0.3, -0.2, 0.1], [0.7, 0.4, -0.3], [1.1, 0.5, 0.2]];
    let sequence = [0.2, -0.5, 0.9];
    let (by_w, by_sequence, by_h) = gru::grad(&w, &sequence, 0.1);
    let point = [w.as_flattened(), &sequence, &[0.1]].concat();
    let primal = |p: &[f64]| {
        let w = [[p[0], p[1], p[2]], [p[3], p[4], p[5]], [p[6], p[7], p[8]]];
        gru(&w, &p[9..12], p[12])
    };
    let gradient = [by_w.as_flattened(), &by_sequence, &[by_h]].concat();
    assert_gradient("gru", primal, &point, &gradient);
}
