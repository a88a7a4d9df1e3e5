//! Lists that move from variable to variable: their tangents move with them in forward mode.

use ad::{Differentiable, differentiable};

#[differentiable]
fn bump(mut list: Vec<f64>, i: usize, x: f64) -> Vec<f64> {
    list[i] += x * list[0];
    list
}

#[differentiable]
fn with_element(mut list: Vec<f64>, i: usize) -> (Vec<f64>, f64) {
    list[i] *= 0.5;
    let element = list[i];
    (list, element)
}

#[derive(Clone, Differentiable)]
struct State {
    list: Vec<f64>,
    sum: f64,
    at: usize,
}

#[differentiable]
impl State {
    fn step(mut self, x: f64) -> Self {
        let at = self.at;
        self.list[at] += x;
        self.sum += self.list[at] * x;
        self.at += 1;
        self
    }
}

// The point are variables that move, and not what they come to.
#[allow(clippy::manual_swap)]
#[differentiable]
fn moves(xs: &[f64]) -> f64 {
    let (mut a, mut b) = (xs.to_vec(), xs.to_vec());
    let mut sum = 0.0;
    for i in 0..xs.len() {
        let t = a;
        a = b;
        b = t;
        a[i] += 0.5 * b[i];
        if xs[i] > 0.1 {
            let mut c = a;
            c[i] *= 0.5;
            a = c;
        }
        a = bump(a, i, 0.001 * xs[i]);
        let (list, element) = with_element(b, i);
        b = list;
        sum += element;
    }
    a[0] * b[1] * sum
}

#[differentiable]
fn holders(xs: &[f64]) -> f64 {
    let mut state = State { list: xs.to_vec(), sum: 0.0, at: 0 };
    let mut held = Some(xs.to_vec());
    let mut pair = (xs.to_vec(), 0.0);
    for i in 0..xs.len() {
        state = state.step(xs[i]);
        state = State { sum: 0.5 * state.sum, ..state };
        held = match held {
            Some(mut list) => {
                list[i] *= xs[0];
                Some(list)
            }
            None => None,
        };
        let (mut list, sum) = pair;
        list[i] += 0.1 * sum;
        let next = 0.5 * sum + list[i];
        pair = (list, next);
    }
    state.sum + pair.1 + held.map_or(0.0, |list| list[0] * list[1])
}

/// Parts that move by themselves, and are given other values.
#[differentiable]
fn parts(xs: &[f64]) -> f64 {
    let mut state = State { list: xs.to_vec(), sum: 0.0, at: 0 };
    let (mut a, mut b) = (xs.to_vec(), xs.to_vec());
    let mut both = [xs.to_vec(), xs.to_vec()];
    let mut pair = (xs.to_vec(), (xs.to_vec(), 1.0));
    for i in 0..xs.len() {
        let swapped = (b, a);
        a = swapped.0;
        b = swapped.1;
        a[i] += 0.1 * b[i];
        state.list = bump(state.list, i, 0.01 * xs[i]);
        state.sum += state.list[i];
        let [mut first, second] = both;
        first[i] += 0.1 * second[0];
        both = [second, first];
        if i % 2 == 0 {
            pair.0 = bump(pair.0, i, xs[i]);
        } else {
            pair.1.0 = bump(pair.1.0, i, pair.1.1);
        }
    }
    let State { list, sum, .. } = state;
    a[0] * b[1] + list[0] * sum + both[0][0] * both[1][1] + pair.0[2] * pair.1.0[1]
}

/// The directional derivative of a function of a slice.
type Derivative = fn(&[f64], &[f64]) -> (f64, f64);

/// Each function by its name, with the product of its gradient and a direction.
pub const ALL: [(&str, Derivative, Derivative); 3] = [
    ("moves", moves::jvp, |xs, along| product(moves::value_and_grad(xs), along)),
    ("parts that move", parts::jvp, |xs, along| product(parts::value_and_grad(xs), along)),
    ("moves within others", holders::jvp, |xs, along| product(holders::value_and_grad(xs), along)),
];

fn product((value, gradient): (f64, Vec<f64>), along: &[f64]) -> (f64, f64) {
    (value, gradient.iter().zip(along).map(|(g, d)| g * d).sum())
}
