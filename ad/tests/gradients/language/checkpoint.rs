//! `#[differentiable(checkpoint)]`: recomputing instead of storing.

use ad::{Differentiable, Real, differentiable};

use crate::oracle::{assert_gradient, check, check_generic};

#[differentiable(checkpoint)]
fn iterated<S: Real>(x: S, y: S) -> S {
    let mut a = x;
    for i in 0..6 {
        a = (a * y + x * S::from_f64(0.1 * i as f64)).sin();
    }
    a * y
}

#[differentiable]
fn many_times<S: Real>(x: S, y: S) -> S {
    let mut a = x;
    for _ in 0..4 {
        a = a + iterated(a, y) * iterated(y, x);
    }
    a
}

#[differentiable(checkpoint)]
fn weighted<const N: usize>(values: &[f64; N], (scale, n): (f64, usize)) -> f64 {
    let mut total = 0.0;
    for (i, value) in values.iter().enumerate() {
        total += (value * scale).exp() * (i + n) as f64;
    }
    total
}

#[derive(Clone, Copy, Differentiable)]
struct Oscillator {
    position: f64,
    velocity: f64,
}

#[differentiable]
impl Oscillator {
    #[differentiable(checkpoint)]
    fn step(&self, stiffness: f64) -> Oscillator {
        let velocity = self.velocity - 0.1 * stiffness * self.position.sin();
        Oscillator { position: self.position + 0.1 * velocity, velocity }
    }

    #[differentiable(checkpoint)]
    fn energy(self, stiffness: f64) -> f64 {
        let half = self.velocity * self.velocity * 0.5;
        half + stiffness * (1.0 - self.position.cos())
    }
}

#[differentiable]
fn swing(x: f64, stiffness: f64) -> f64 {
    let mut state = Oscillator { position: x, velocity: 0.0 };
    for _ in 0..30 {
        state = state.step(stiffness);
    }
    state.energy(stiffness) + state.position
}

#[differentiable]
fn checkpointed_loop<S: Real>(x: S, y: S) -> S {
    let mut a = x;
    let mut b = y;
    let mut count = 0;
    #[differentiable(checkpoint)]
    for i in 0..10 {
        let t = a * y;
        if i % 4 == 3 {
            continue;
        }
        if i % 3 == 1 {
            b = b + t * x;
            count += 1;
        } else {
            a = (a + b * S::from_f64(0.1 * count as f64)).sin();
        }
        for j in 0..i {
            a = a + b * t * S::from_f64(0.01 * j as f64);
        }
    }
    a = a * b;
    b = a + x;
    a * b * S::from_f64(count as f64)
}

/// Variables that the loop reads and something later changes.
#[differentiable]
fn state_changed_later(x: f64, y: f64, n: usize) -> f64 {
    let mut rate = x * y;
    let mut table = [x, y, x + y];
    let mut total = 0.0;
    for k in 0..2 {
        #[differentiable(checkpoint)]
        for i in (0..n).rev() {
            total += rate * table[i % 3] * (i + k) as f64;
            table[(i + 1) % 3] *= y;
        }
        rate = total * 0.1;
        table = [rate, x, y];
    }
    total * rate + table[0]
}

#[differentiable]
fn over_elements(values: &[f64; 7], y: f64) -> f64 {
    let mut state = [y, 1.0];
    #[differentiable(checkpoint)]
    for (i, pair) in values.windows(2).enumerate() {
        state[0] = state[0] * pair[0] + values[i] * pair[1];
        state[1] += state[0];
    }
    state[0] * state[1]
}

#[test]
fn loops() {
    check_generic!(checkpointed_loop(x, y) at [1.3, 0.7], [-0.4, 1.1]);
    for n in [0, 1, 2, 3, 4, 5, 9, 11] {
        let (value, (to_x, to_y, ())) = state_changed_later::value_and_grad(1.3, 0.7, n);
        assert_eq!(value, state_changed_later(1.3, 0.7, n));
        let primal = |p: &[f64]| state_changed_later(p[0], p[1], n);
        assert_gradient("state_changed_later", primal, &[1.3, 0.7], &[to_x, to_y]);
    }
    let values = [0.3, -1.2, 1.5, 2.0, 0.4, 0.7, -1.1];
    let primal = |p: &[f64]| over_elements(p[..7].try_into().unwrap(), p[7]);
    let (by_values, by_y) = over_elements::grad(&values, 0.8);
    let point = [&values[..], &[0.8]].concat();
    let gradient = [&by_values[..], &[by_y]].concat();
    assert_gradient("over_elements", primal, &point, &gradient);
}

#[test]
fn functions() {
    check_generic!(iterated(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check_generic!(many_times(x, y) at [1.3, 0.7], [-0.4, 1.1]);
    check!(swing(x, y) at [1.3, 0.7], [-0.4, 2.1]);

    let point = [0.3, -0.2, 0.5, 0.7];
    let primal = |p: &[f64]| weighted(&[p[0], p[1], p[2]], (p[3], 2));
    let (value, (values, (scale, ()))) = weighted::value_and_grad(&[0.3, -0.2, 0.5], (0.7, 2));
    assert_eq!(value, primal(&point));
    assert_gradient("weighted", primal, &point, &[values[0], values[1], values[2], scale]);
}

/// The pullback holds the arguments and nothing else.
#[test]
fn memory() {
    let (_, pullback) = iterated::vjp(1.3_f64, 0.7);
    assert_eq!(size_of_val(&pullback), 2 * size_of::<f64>());
    let (_, pullback) = weighted::vjp(&[0.0; 100], (0.7, 2));
    assert_eq!(size_of_val(&pullback), 102 * size_of::<f64>());
}
