//! ADBench's loss of a small recurrent network: two layers of 14 cells over 1024 characters.

use ad::{Real, differentiable, stop_gradient};

use crate::problem::Problem;
use crate::random::Random;

/// The bits of a character, and the cells of a layer.
pub const B: usize = 14;
pub const LAYERS: usize = 2;
/// Characters.
pub const T: usize = 1024;

/// For each layer a row of weights and one of biases, each for the gates forget, in, out and the
/// change.
pub type Main<S> = [[S; 4 * B]; 2 * LAYERS];
/// Weights of the input, weights and biases of the output.
pub type Extra<S> = [[S; B]; 3];
/// For each layer what is hidden, and the cells.
pub type Start = [[f64; B]; 2 * LAYERS];
pub type Sequence = [[f64; B]; T];

#[differentiable]
fn sigmoid<S: Real>(x: S) -> S {
    (S::ONE + (-x).exp()).recip()
}

#[differentiable]
pub fn loss<S: Real>(
    main: &[[S; 4 * B]; 2 * LAYERS],
    extra: &[[S; B]; 3],
    start: &[[f64; B]; 2 * LAYERS],
    sequence: &[[f64; B]; T],
) -> S {
    let mut hidden = [[S::ZERO; B]; LAYERS];
    let mut cells = [[S::ZERO; B]; LAYERS];
    for layer in 0..LAYERS {
        for i in 0..B {
            hidden[layer][i] = S::from_f64(stop_gradient(start[2 * layer][i]));
            cells[layer][i] = S::from_f64(stop_gradient(start[2 * layer + 1][i]));
        }
    }
    let mut total = S::ZERO;
    for t in 0..T - 1 {
        let mut signal = [S::ZERO; B];
        for i in 0..B {
            signal[i] = S::from_f64(stop_gradient(sequence[t][i])) * extra[0][i];
        }
        for layer in 0..LAYERS {
            for i in 0..B {
                let (w, b) = (2 * layer, 2 * layer + 1);
                let forget = sigmoid(signal[i] * main[w][i] + main[b][i]);
                let gate_in = sigmoid(hidden[layer][i] * main[w][B + i] + main[b][B + i]);
                let gate_out = sigmoid(signal[i] * main[w][2 * B + i] + main[b][2 * B + i]);
                let change = (hidden[layer][i] * main[w][3 * B + i] + main[b][3 * B + i]).tanh();
                let cell = cells[layer][i] * forget + gate_in * change;
                let output = gate_out * cell.tanh();
                cells[layer][i] = cell;
                hidden[layer][i] = output;
                signal[i] = output;
            }
        }
        let mut sum = S::TWO;
        let mut predictions = [S::ZERO; B];
        for i in 0..B {
            let prediction = signal[i] * extra[1][i] + extra[2][i];
            sum += prediction.exp();
            predictions[i] = prediction;
        }
        let norm = sum.ln();
        for i in 0..B {
            let bit = S::from_f64(stop_gradient(sequence[t + 1][i]));
            total += bit * (predictions[i] - norm);
        }
    }
    -total / S::from_f64(((T - 1) * B) as f64)
}

/// What a cell of a layer leaves for the way back.
#[derive(Clone, Copy, Default)]
struct Step {
    signal: f64,
    hidden: f64,
    cell: f64,
    forget: f64,
    gate_in: f64,
    gate_out: f64,
    change: f64,
    squashed: f64,
}

/// The gradient, written by hand.
pub fn adjoint(
    main: &Main<f64>,
    extra: &Extra<f64>,
    start: &Start,
    sequence: &Sequence,
) -> (Main<f64>, Extra<f64>) {
    let logistic = |x: f64| 1.0 / (1.0 + (-x).exp());
    let mut hidden = [start[0], start[2]];
    let mut cells = [start[1], start[3]];
    let mut steps = vec![[[Step::default(); B]; LAYERS]; T - 1];
    // The outputs, their exponentials and one over the sum of these.
    let mut ends = vec![([0.0; B], [0.0; B], 0.0); T - 1];
    for (t, (step, end)) in steps.iter_mut().zip(&mut ends).enumerate() {
        let mut signal: [f64; B] = std::array::from_fn(|i| sequence[t][i] * extra[0][i]);
        for layer in 0..LAYERS {
            let (w, b) = (&main[2 * layer], &main[2 * layer + 1]);
            for i in 0..B {
                let s = &mut step[layer][i];
                s.signal = signal[i];
                s.hidden = hidden[layer][i];
                s.cell = cells[layer][i];
                s.forget = logistic(s.signal * w[i] + b[i]);
                s.gate_in = logistic(s.hidden * w[B + i] + b[B + i]);
                s.gate_out = logistic(s.signal * w[2 * B + i] + b[2 * B + i]);
                s.change = (s.hidden * w[3 * B + i] + b[3 * B + i]).tanh();
                cells[layer][i] = s.cell * s.forget + s.gate_in * s.change;
                s.squashed = cells[layer][i].tanh();
                hidden[layer][i] = s.gate_out * s.squashed;
                signal[i] = hidden[layer][i];
            }
        }
        let exponentials: [f64; B] =
            std::array::from_fn(|i| (signal[i] * extra[1][i] + extra[2][i]).exp());
        *end = (signal, exponentials, 1.0 / (2.0 + exponentials.iter().sum::<f64>()));
    }

    let mut main_bar = [[0.0; 4 * B]; 2 * LAYERS];
    let mut extra_bar = [[0.0; B]; 3];
    let mut hidden_bar = [[0.0; B]; LAYERS];
    let mut cells_bar = [[0.0; B]; LAYERS];
    let seed = -1.0 / ((T - 1) * B) as f64;
    for (t, (step, end)) in steps.iter().zip(&ends).enumerate().rev() {
        let (signal, exponentials, recip) = end;
        let bits: f64 = sequence[t + 1].iter().sum();
        let mut signal_bar = [0.0; B];
        for i in 0..B {
            let bar = seed * (sequence[t + 1][i] - bits * exponentials[i] * recip);
            extra_bar[1][i] += bar * signal[i];
            extra_bar[2][i] += bar;
            signal_bar[i] = bar * extra[1][i];
        }
        for layer in (0..LAYERS).rev() {
            let w = &main[2 * layer];
            for i in 0..B {
                let s = &step[layer][i];
                let output_bar = signal_bar[i] + hidden_bar[layer][i];
                let cell_bar =
                    cells_bar[layer][i] + output_bar * s.gate_out * (1.0 - s.squashed * s.squashed);
                let forget_bar = cell_bar * s.cell * s.forget * (1.0 - s.forget);
                let in_bar = cell_bar * s.change * s.gate_in * (1.0 - s.gate_in);
                let out_bar = output_bar * s.squashed * s.gate_out * (1.0 - s.gate_out);
                let change_bar = cell_bar * s.gate_in * (1.0 - s.change * s.change);
                cells_bar[layer][i] = cell_bar * s.forget;
                signal_bar[i] = forget_bar * w[i] + out_bar * w[2 * B + i];
                hidden_bar[layer][i] = in_bar * w[B + i] + change_bar * w[3 * B + i];
                let bars = [
                    (forget_bar, s.signal),
                    (in_bar, s.hidden),
                    (out_bar, s.signal),
                    (change_bar, s.hidden),
                ];
                for (gate, (bar, factor)) in bars.into_iter().enumerate() {
                    main_bar[2 * layer][gate * B + i] += bar * factor;
                    main_bar[2 * layer + 1][gate * B + i] += bar;
                }
            }
        }
        for i in 0..B {
            extra_bar[0][i] += signal_bar[i] * sequence[t][i];
        }
    }
    (main_bar, extra_bar)
}

pub struct Lstm {
    start: Start,
    sequence: Box<Sequence>,
}

impl Lstm {
    pub fn new() -> Self {
        let mut random = Random::new(6);
        let start = std::array::from_fn(|_| random.numbers());
        let bits = |x: f64| if x > 0.0 { 1.0 } else { 0.0 };
        let sequence = Box::new(std::array::from_fn(|_| random.numbers().map(bits)));
        Self { start, sequence }
    }
}

/// From a flat list.
fn read<S: Real>(x: &[S]) -> (Main<S>, Extra<S>) {
    let (main, extra) = x.split_at(2 * LAYERS * 4 * B);
    (
        std::array::from_fn(|i| *main[i * 4 * B..].first_chunk().expect("a row")),
        std::array::from_fn(|i| *extra[i * B..].first_chunk().expect("a row")),
    )
}

/// To a flat list.
fn write(main: &Main<f64>, extra: &Extra<f64>, x: &mut [f64]) {
    let (to_main, to_extra) = x.split_at_mut(2 * LAYERS * 4 * B);
    to_main.copy_from_slice(main.as_flattened());
    to_extra.copy_from_slice(extra.as_flattened());
}

impl Problem for Lstm {
    const NAME: &'static str = "LSTM, 2 layers, 1024";
    const OUTPUTS: usize = 1;

    fn point(&self) -> Vec<f64> {
        let mut random = Random::new(7);
        (0..(2 * LAYERS * 4 + 3) * B).map(|_| random.number()).collect()
    }

    fn value<S: Real<Mask = bool>>(&self, x: &[S], outputs: &mut [S]) {
        let (main, extra) = read(x);
        outputs[0] = loss(&main, &extra, &self.start, &self.sequence);
    }

    fn generated(&self, x: &[f64], jacobian: &mut [f64]) {
        let (main, extra) = read(x);
        let (main, extra, ..) = loss::grad(&main, &extra, &self.start, &self.sequence);
        write(&main, &extra, jacobian);
    }

    fn forward(&self, x: &[f64], direction: &[f64], tangents: &mut [f64]) {
        let ((main, extra), (main_dot, extra_dot)) = (read(x), read(direction));
        let still = ([[0.0; B]; 2 * LAYERS], [[0.0; B]; T]);
        let (start, sequence) = (&self.start, &self.sequence);
        (_, tangents[0]) =
            loss::jvp(&main, &extra, start, sequence, &main_dot, &extra_dot, &still.0, &still.1);
    }

    fn by_hand(&self, x: &[f64], jacobian: &mut [f64]) {
        let (main, extra) = read(x);
        let (main, extra) = adjoint(&main, &extra, &self.start, &self.sequence);
        write(&main, &extra, jacobian);
    }
}
