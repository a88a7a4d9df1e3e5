//! What a `&mut` refers to, passed to a function by the name of the reference alone: as `&mut`, or as `&`.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[derive(Clone, Copy, Differentiable)]
struct Body {
    at: f64,
    speed: f64,
}

#[differentiable]
fn energy(body: &Body) -> f64 {
    0.5 * body.speed * body.speed + body.at.sin()
}

#[differentiable]
fn kick(body: &mut Body, by: f64) -> f64 {
    body.speed *= by;
    body.speed - body.at
}

#[differentiable]
fn pair(a: &[f64], b: &[f64], i: usize) -> f64 {
    a[i] * b[(i + 1) % b.len()] * 0.5
}

#[differentiable]
fn shift(a: &mut [f64], by: &[f64], i: usize) -> f64 {
    a[i] += by[i] * a[0];
    a[i] * by[0]
}

/// Names of elements that loops and patterns give.
#[differentiable]
fn elements(x: f64, y: f64) -> f64 {
    let mut bodies = vec![Body { at: x, speed: y }, Body { at: y, speed: x * y }];
    let mut sum = 0.0;
    for body in bodies.iter_mut() {
        body.at *= 1.1;
        sum += energy(body) * x;
        sum += kick(body, y) - energy(body);
    }
    let mut last = Some(bodies[1]);
    if let Some(body) = &mut last {
        body.speed += x;
        sum *= energy(body);
    }
    let mut rows = vec![vec![x, y], vec![y, sum]];
    for row in &mut rows {
        row[0] *= 1.5;
        sum += pair(row, &[x, sum], 0);
    }
    sum + rows[1][0]
}

/// Other names of variables, twice in one call, halves, and parameters.
#[differentiable]
fn names(x: f64, y: f64) -> f64 {
    let mut values = vec![x, y, x * y];
    let others = [y, x, 0.5];
    let name = &mut values;
    name[0] *= 1.1;
    let mut sum = pair(name, &others, 0) + pair(name, name, 1);
    sum += shift(name, &others, 2) + pair(&others, name, 1);
    let (left, right) = values.split_at_mut(1);
    right[0] *= sum;
    sum += pair(left, &others, 0) * pair(right, &others, 1);
    sum + through(&mut values, &others)
}

#[differentiable]
fn through(values: &mut Vec<f64>, others: &[f64]) -> f64 {
    let mut sum = 0.0;
    for i in 0..values.len() {
        sum += pair(values, others, i) + shift(values, others, i) * pair(values, values, i);
    }
    sum
}

/// The type of what begins as a literal is told by what is assigned to it later.
#[differentiable]
fn newton(x: f64, y: f64) -> f64 {
    let mut root = 1.0;
    let mut last = 0.0;
    for _ in 0..8 {
        let value = root * root - x * y;
        let slope = 2.0 * root;
        let step = value / slope;
        last = step * root;
        root -= step;
        if step.abs() < 1e-3 {
            break;
        }
    }
    root + last * 100.0
}

/// The type of what begins as a literal is that of the result, which it is in the end.
#[differentiable]
fn recurrence(x: f64, y: f64) -> f64 {
    let values = vec![x, y, x * y];
    let mut state = 1.0;
    for i in 0..3 {
        state = (1.3 * state + pair(&values, &values, i)).sin();
    }
    state
}

/// What is passed beside itself, or a part of it, is taken as `&`.
#[differentiable]
fn grown(values: &mut Vec<f64>) -> f64 {
    values.push(2.0);
    let product = pair(&values[1..], values, 0);
    values[0] = product;
    product * pair(values, values, 1)
}

#[derive(Clone, Debug, Differentiable)]
struct Whole {
    scale: f64,
    parts: Vec<f64>,
}

#[differentiable]
impl Whole {
    fn dot(&self, other: &Whole) -> f64 {
        self.scale * other.scale + self.parts[0] * other.parts[1]
    }

    fn at(&self, parts: &[f64]) -> f64 {
        self.scale * parts[0]
    }

    fn rescale(&mut self, parts: &[f64]) {
        self.scale *= parts[0];
    }

    fn square(&mut self) -> f64 {
        self.scale *= 2.0;
        let square = self.dot(self);
        self.parts[0] += square;
        self.at(&self.parts) + square
    }

    fn with(&mut self, other: &mut Whole) -> f64 {
        let both = self.dot(other) + other.dot(self) + other.at(&other.parts);
        other.rescale(&self.parts);
        self.scale += other.scale;
        both
    }
}

#[differentiable]
fn beside_itself(x: f64, y: f64) -> f64 {
    let mut values = vec![x, y, x * y];
    let mut whole = Whole { scale: x, parts: vec![y, x] };
    let mut other = Whole { scale: y, parts: vec![x, x * y] };
    let sum = whole.square() * whole.parts[0] + whole.with(&mut other) * other.scale;
    grown(&mut values) * values[0] + sum * whole.scale
}

#[test]
fn gradients_are_those_of_the_function() {
    check!(beside_itself(x, y) at [0.7, 1.3], [-0.4, 0.8]);
    check!(recurrence(x, y) at [0.7, 1.3], [-0.4, 0.8]);
    check!(elements(x, y) at [0.7, 1.3], [-0.4, 0.8]);
    check!(names(x, y) at [0.7, 1.3], [-0.4, 0.8]);
    check!(newton(x, y) at [0.7, 1.3], [2.4, 0.8]);
}
