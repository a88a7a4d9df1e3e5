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
