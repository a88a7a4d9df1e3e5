//! The loss of a long short-term memory that predicts characters.

use std::path::Path;

use ad::{Differentiable, differentiable};

use crate::Comparison;
use crate::read::{Numbers, reference};

#[derive(Clone, Differentiable)]
struct Layer {
    weights: Vec<f64>,
    biases: Vec<f64>,
}

#[derive(Clone, Differentiable)]
struct State {
    hidden: Vec<f64>,
    cell: Vec<f64>,
}

#[differentiable]
fn sigmoid(x: f64) -> f64 {
    1.0 / (1.0 + (-x).exp())
}

#[differentiable]
impl Layer {
    fn step(&self, state: &mut State, input: &[f64]) {
        let h = input.len();
        let (w, b) = (&self.weights, &self.biases);
        for i in 0..h {
            let forget = sigmoid(input[i] * w[i] + b[i]);
            let ingate = sigmoid(state.hidden[i] * w[h + i] + b[h + i]);
            let outgate = sigmoid(input[i] * w[2 * h + i] + b[2 * h + i]);
            let change = (state.hidden[i] * w[3 * h + i] + b[3 * h + i]).tanh();
            state.cell[i] = state.cell[i] * forget + ingate * change;
            state.hidden[i] = outgate * state.cell[i].tanh();
        }
    }
}

/// The scores of the next character.
#[differentiable]
fn predict(layers: &[Layer], ends: &[Vec<f64>], states: &mut [State], input: &[f64]) -> Vec<f64> {
    let mut x: Vec<f64> = input.iter().zip(&ends[0]).map(|(x, w)| x * w).collect();
    for (i, layer) in layers.iter().enumerate() {
        layer.step(&mut states[i], &x);
        x = states[i].hidden.clone();
    }
    (0..x.len()).map(|i| x[i] * ends[1][i] + ends[2][i]).collect()
}

#[differentiable]
fn objective(layers: &[Layer], ends: &[Vec<f64>], start: &[State], text: &[Vec<f64>]) -> f64 {
    let mut states = start.to_vec();
    let (mut total, mut count) = (0.0, 0);
    for pair in text.windows(2) {
        let scores = predict(layers, ends, &mut states, &pair[0]);
        let norm = (2.0 + scores.iter().map(|s| s.exp()).sum::<f64>()).ln();
        total += pair[1].iter().zip(&scores).map(|(gold, s)| gold * (s - norm)).sum::<f64>();
        count += scores.len();
    }
    -total / count as f64
}

pub fn compare(input: &Path) -> Comparison {
    let mut numbers = Numbers::of_file(input);
    let [l, c, b] = numbers.sizes();
    let mut layers = Vec::new();
    for _ in 0..l {
        layers.push(Layer { weights: numbers.take(4 * b), biases: numbers.take(4 * b) });
    }
    let ends = numbers.rows(3, b);
    let mut states = Vec::new();
    for _ in 0..l {
        states.push(State { hidden: numbers.take(b), cell: numbers.take(b) });
    }
    let text = numbers.rows(c, b);
    let (value, (by_layers, by_ends, _, _)) =
        objective::value_and_grad(&layers, &ends, &states, &text);
    let mut derivatives = Vec::new();
    for layer in by_layers {
        derivatives.extend(layer.weights);
        derivatives.extend(layer.biases);
    }
    derivatives.extend(by_ends.concat());
    Comparison {
        value,
        derivatives,
        expected_value: reference(input, "objective")[0],
        expected: reference(input, "gradient"),
    }
}
