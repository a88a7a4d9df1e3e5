//! A network of layers, trained by one step.

use ad::{Differentiable, differentiable};

#[derive(Clone, Copy, Debug, PartialEq, Eq, Differentiable)]
#[constant]
enum Activation {
    Relu,
    Tanh,
    Linear,
}

#[derive(Clone, Debug, Differentiable)]
struct Layer {
    weights: Vec<Vec<f64>>,
    bias: Vec<f64>,
    activation: Activation,
}

#[differentiable]
impl Activation {
    fn apply(self, x: f64) -> f64 {
        match self {
            Activation::Relu => {
                if x > 0.0 {
                    x
                } else {
                    0.0
                }
            }
            Activation::Tanh => x.tanh(),
            Activation::Linear => x,
        }
    }
}

#[differentiable]
impl Layer {
    fn new(n_in: usize, n_out: usize, seed: f64, activation: Activation) -> Self {
        let weights = (0..n_out)
            .map(|i| (0..n_in).map(|j| (seed * (i * n_in + j + 1) as f64).sin()).collect())
            .collect();
        Self { weights, bias: vec![0.1; n_out], activation }
    }

    fn forward(&self, input: &[f64]) -> Vec<f64> {
        self.weights
            .iter()
            .zip(&self.bias)
            .map(|(row, b)| {
                let z: f64 = row.iter().zip(input).map(|(w, x)| w * x).sum::<f64>() + b;
                self.activation.apply(z)
            })
            .collect()
    }
}

#[derive(Clone, Debug, Differentiable)]
struct Network {
    layers: Vec<Layer>,
}

#[differentiable]
impl Network {
    fn forward(&self, input: &[f64]) -> Vec<f64> {
        let mut x = input.to_vec();
        for layer in &self.layers {
            x = layer.forward(&x);
        }
        x
    }
    fn forward2(&self, input: &[f64]) -> Vec<f64> {
        self.layers.iter().fold(input.to_vec(), |x, layer| layer.forward(&x))
    }
    fn loss(&self, data: &[(Vec<f64>, f64)]) -> f64 {
        let mut total = 0.0;
        for (x, y) in data {
            let out = self.forward(x)[0];
            total += (out - y).powi(2);
        }
        total / data.len() as f64
    }
    fn sgd_step(&mut self, grads: &Network, lr: f64) {
        for (layer, grad) in self.layers.iter_mut().zip(&grads.layers) {
            for (row, grow) in layer.weights.iter_mut().zip(grad.weights.iter()) {
                for (w, g) in row.iter_mut().zip(grow) {
                    *w -= lr * g;
                }
            }
            for (b, g) in layer.bias.iter_mut().zip(&grad.bias) {
                *b -= lr * *g;
            }
        }
    }
}

#[differentiable]
fn total(seed: f64, lr: f64) -> f64 {
    let mut net = Network {
        layers: vec![
            Layer::new(2, 3, seed, Activation::Tanh),
            Layer::new(3, 3, seed * 0.5, Activation::Relu),
            Layer::new(3, 1, seed * 0.25, Activation::Linear),
        ],
    };
    let data = vec![(vec![0.1, 0.4], 1.0), (vec![-0.6, 0.9], -1.0)];
    let grads = net.clone();
    net.sgd_step(&grads, lr);
    net.loss(&data) + net.forward2(&data[0].0)[0]
}

#[test]
fn layers() {
    use crate::oracle::check;

    check!(total(seed, lr) at [0.7, 0.05], [-0.3, 0.2]);
}
