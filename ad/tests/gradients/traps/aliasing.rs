//! Copies that could be taken for the original, and the other way round.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[derive(Clone, Copy, Differentiable)]
struct State {
    position: f64,
    velocity: f64,
}

#[differentiable]
impl State {
    fn step(self, dt: f64) -> State {
        let mut next = self;
        next.position += next.velocity * dt;
        next.velocity -= next.position * dt;
        next
    }
}

#[differentiable]
fn integrate(x: f64, dt: f64) -> f64 {
    let mut state = State { position: x, velocity: 1.0 };
    let start = state;
    for _ in 0..4 {
        let before = state;
        state = state.step(dt);
        state.velocity += before.position * start.position;
    }
    state.position * start.position + state.velocity
}

#[differentiable]
fn copies_of_arrays(x: f64, y: f64) -> f64 {
    let mut a = [x, y];
    let mut b = a;
    b[0] *= y;
    a[1] += b[0];
    let c = [a, b, a];
    a[0] = c[1][0] * c[2][1];
    let mut d = c;
    d[0][0] = a[0];
    c[0][0] * d[0][0] + d[2][1] * b[1]
}

#[differentiable]
fn same_argument_twice(x: f64, y: f64) -> f64 {
    let mut a = x * y;
    a = product(a, a);
    product(a, product(a, x))
}

#[differentiable]
fn product(x: f64, y: f64) -> f64 {
    x * y * y
}

#[differentiable]
fn swap(x: f64, y: f64) -> f64 {
    let (mut a, mut b) = (x, y);
    for _ in 0..3 {
        let t = a;
        a = b * x;
        b = t + a;
    }
    a - b * y
}

#[test]
fn values_are_copies() {
    check!(integrate(x, y) at [1.3, 0.1], [-0.4, 0.3]);
    check!(copies_of_arrays(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(same_argument_twice(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(swap(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}
