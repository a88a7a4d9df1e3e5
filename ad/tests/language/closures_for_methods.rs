//! Closures without types that are passed to methods: inherent ones, and those of traits.

use ad::{Differentiable, Real, differentiable};

use crate::oracle::{check, check_generic};

#[derive(Clone, Differentiable)]
struct Rule {
    weights: Vec<f64>,
    nodes: Vec<f64>,
}

#[differentiable]
impl Rule {
    fn integrate<F: Fn(f64) -> f64>(&self, f: F) -> f64 {
        let mut sum = 0.0;
        for i in 0..self.weights.len() {
            sum += self.weights[i] * f(self.nodes[i]);
        }
        sum
    }

    fn fold(&self, start: (f64, f64), step: impl Fn((f64, f64), &[f64]) -> (f64, f64)) -> f64 {
        let mut state = start;
        for i in 1..self.nodes.len() {
            state = step(state, &self.nodes[i - 1..=i]);
        }
        state.0 * state.1
    }

    fn change(&mut self, f: impl Fn(f64) -> f64) {
        for weight in &mut self.weights {
            *weight = f(*weight);
        }
    }
}

#[differentiable]
trait Field {
    fn at(&self, x: f64) -> f64;

    fn mapped<F: Fn(f64) -> f64>(&self, x: f64, f: F) -> f64 {
        f(self.at(x))
    }
}

#[differentiable]
impl Field for Rule {
    fn at(&self, x: f64) -> f64 {
        self.weights[0] * x * x
    }
}

#[differentiable]
fn through_field<T: Field + Differentiable>(field: &T, x: f64) -> f64 {
    let scale = x * x;
    field.mapped(x, |v| v.cos() * scale)
}

#[differentiable]
fn methods(x: f64, y: f64) -> f64 {
    let mut rule = Rule { weights: vec![x, 0.5, y], nodes: vec![0.1, x * y, 0.9] };
    let whole = rule.integrate(|t| t * t * y + x);
    let shifted = |t| rule.integrate(|s| s * t) - t * y;
    let again = shifted(x);
    rule.change(|w| w.sin() + y);
    let folded = rule.fold((x, 1.0), |(a, b), pair| (a * pair[0] + y, b - pair[1] * a));
    let mapped = rule.mapped(x, |v| if v > 0.0 { v.sin() * y } else { v * v });
    whole + again + folded + mapped + through_field(&rule, y)
}

#[test]
fn closures_for_methods() {
    check!(methods(x, y) at [0.3, 0.7], [-0.4, 1.2], [1.1, -0.3]);
}

#[derive(Clone, Copy, Differentiable)]
struct Line<S> {
    slope: S,
    start: S,
}

#[differentiable]
impl<S: Real> Line<S> {
    fn bent(self, by: impl Fn(S, S) -> S) -> S {
        by(self.slope, self.start) + by(self.start, self.slope) * self.slope
    }
}

#[differentiable]
fn lines<S: Real>(x: S, y: S) -> S {
    let line = Line { slope: x, start: y * y };
    line.bent(|a, b| a * b.sin() + x) - line.bent(|a, _| a)
}

#[test]
fn closures_for_methods_of_generic_types() {
    check_generic!(lines(x, y) at [0.3, 0.7], [-0.4, 1.2]);
}
