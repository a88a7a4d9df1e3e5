//! A perceptron of rows of weights, with activations that an enum names.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[derive(Clone, Copy, Debug, PartialEq, Differentiable)]
enum Activation {
    Relu,
    Tanh,
    Sigmoid,
    Linear,
}

#[differentiable]
impl Activation {
    fn apply(self, x: f64) -> f64 {
        match self {
            Activation::Relu => x.max(0.0),
            Activation::Tanh => x.tanh(),
            Activation::Sigmoid => 1.0 / (1.0 + (-x).exp()),
            Activation::Linear => x,
        }
    }
}

#[derive(Clone, Debug, Differentiable)]
struct Layer {
    weights: Vec<Vec<f64>>,
    bias: Vec<f64>,
    activation: Activation,
}

#[differentiable]
impl Layer {
    fn forward(&self, input: &[f64]) -> Vec<f64> {
        let mut out = Vec::with_capacity(self.bias.len());
        for (row, b) in self.weights.iter().zip(&self.bias) {
            let z: f64 = row.iter().zip(input).map(|(w, x)| w * x).sum::<f64>() + b;
            out.push(self.activation.apply(z));
        }
        out
    }
}

#[derive(Clone, Debug, Differentiable)]
struct Mlp {
    layers: Vec<Layer>,
}

#[differentiable]
fn predict(net: &Mlp, input: &[f64]) -> Vec<f64> {
    let mut x = input.to_vec();
    for layer in &net.layers {
        x = layer.forward(&x);
    }
    x
}

#[differentiable]
fn loss(net: &Mlp, #[constant] samples: &[(Vec<f64>, f64)], decay: f64) -> f64 {
    let mut total = 0.0;
    for (input, target) in samples {
        let out = predict(net, input);
        let error = out[0] - target;
        total += error * error;
    }
    let mut norm = 0.0;
    for layer in &net.layers {
        for row in &layer.weights {
            norm += row.iter().map(|w| w * w).sum::<f64>();
        }
    }
    total / samples.len() as f64 + decay * norm
}

#[differentiable]
fn trained(a: f64, b: f64) -> f64 {
    let net = Mlp {
        layers: vec![
            Layer {
                weights: vec![vec![a, 0.3], vec![-0.2, b], vec![a * b, 0.1]],
                bias: vec![0.1, a, -0.3],
                activation: Activation::Tanh,
            },
            Layer {
                weights: vec![vec![0.4, b, -0.6], vec![a, 0.2, 0.7]],
                bias: vec![0.05, 0.3],
                activation: Activation::Sigmoid,
            },
            Layer { weights: vec![vec![1.0, a]], bias: vec![b], activation: Activation::Relu },
        ],
    };
    loss(&net, &[(vec![0.5, -1.0], 1.0), (vec![0.2, 0.8], 0.3)], 0.01)
}

#[test]
fn a_perceptron() {
    check!(trained(a, b) at [0.6, 0.4], [-0.3, 0.9]);
    let net = Mlp { layers: vec![] };
    let (_, (by_net, (), _)) = loss::value_and_grad(&net, &[(vec![0.5], 1.0)], 0.1);
    assert!(by_net.layers.is_empty() && Activation::Linear.apply(2.0) == 2.0);
}
