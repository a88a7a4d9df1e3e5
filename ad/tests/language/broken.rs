//! Loops that are left with what cannot be copied.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[derive(Clone, Differentiable)]
struct State {
    values: Vec<f64>,
    at: f64,
}

#[differentiable]
fn given_back(x: f64, y: f64) -> f64 {
    let mut v = vec![x, y, x * y];
    let mut i = 0;
    v = loop {
        if i == 3 {
            break v;
        }
        v[i] = v[i] * y + x;
        i += 1;
    };
    v[0] * v[2] + v[1]
}

#[differentiable]
fn one_of_two(x: f64, y: f64) -> f64 {
    let (mut low, mut high) = (vec![x, 1.0], vec![y, 2.0]);
    let mut steps = 0;
    let (chosen, count) = 'outer: loop {
        for k in 0..2 {
            low[k] = low[k] * x + y;
            if low[k] > 4.0 {
                break 'outer (low, steps);
            }
            high[k] *= 1.25;
        }
        if steps == 2 {
            break (high, 7);
        }
        steps += 1;
    };
    chosen[0] * chosen[1] * count as f64
}

#[differentiable]
fn last_of_all(start: State) -> State {
    let mut state = start;
    loop {
        let at = state.at;
        if at > 3.0 {
            break state;
        }
        state.values[0] *= at;
        state.at = at * at + 1.0;
    }
}

#[differentiable]
fn returned(x: f64, y: f64) -> f64 {
    let state = last_of_all(State { values: vec![x * y], at: x });
    state.values[0] * state.at
}

#[test]
fn left_with_what_cannot_be_copied() {
    check!(given_back(x, y) at [0.7, 1.3], [-1.2, 0.4]);
    check!(one_of_two(x, y) at [0.7, 0.4], [1.9, 1.3], [-1.2, 0.4]);
    check!(returned(x, y) at [0.7, 1.3], [1.2, 0.4]);
}
