//! What an option lends, and parts of it: `option.as_ref().unwrap().part`, `*option.as_mut().unwrap()`.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[derive(Clone, Differentiable)]
struct Layer {
    weights: Vec<f64>,
    bias: f64,
    next: Option<Box<Layer>>,
}

#[differentiable]
impl Layer {
    fn first(&self) -> f64 {
        self.weights[0] * self.bias
    }
}

#[differentiable]
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sum = 0.0;
    for i in 0..a.len() {
        sum += a[i] * b[i];
    }
    sum
}

#[differentiable]
fn through(layer: &Layer) -> f64 {
    let mut sum = layer.next.as_ref().unwrap().weights[0] * layer.weights[1];
    for i in 0..2 {
        sum =
            sum * layer.next.as_ref().unwrap().weights[i] + layer.next.as_ref().expect("one").bias;
    }
    for weight in &layer.next.as_ref().unwrap().weights {
        sum += weight * weight;
    }
    sum += layer.next.as_deref().unwrap().weights.iter().map(|w| w.sin()).sum::<f64>();
    sum * layer.next.as_ref().unwrap().first()
        + dot(&layer.weights, &layer.next.as_ref().unwrap().weights)
}

#[differentiable]
fn two(x: f64, y: f64) -> f64 {
    let last = Layer { weights: vec![x * y, y], bias: x, next: None };
    through(&Layer { weights: vec![y, x], bias: y, next: Some(Box::new(last)) })
}

#[differentiable]
fn of_a_local(x: f64, y: f64) -> f64 {
    let layer = Some(Layer { weights: vec![x, y * y], bias: x + y, next: None });
    let mut sum = 0.0;
    for i in 0..2 {
        sum += layer.as_ref().unwrap().weights[i] * layer.as_ref().unwrap().bias;
    }
    sum
}

#[differentiable]
fn changed_in_place(x: f64, y: f64) -> f64 {
    let mut option = Some(x);
    *option.as_mut().unwrap() *= 2.0 * y;
    *option.as_mut().expect("a number") = option.unwrap() * option.unwrap();
    let number = option.as_mut().unwrap();
    *number += y * *number;
    let mut options = vec![option, None];
    let mut count = Some(1_usize);
    for i in 0..2 {
        *options[0].as_mut().unwrap() *= x + i as f64;
        *count.as_mut().unwrap() += i;
    }
    options[0].unwrap_or(0.0) * count.unwrap() as f64
}

#[derive(Clone, Differentiable)]
struct Unit {
    weights: Vec<f64>,
    bias: Option<f64>,
}

#[differentiable]
fn shift(unit: &mut Unit, by: f64) {
    unit.weights[0] *= by;
    *unit.bias.as_mut().unwrap() += by;
}

#[derive(Clone, Differentiable)]
struct Network {
    unit: Option<Unit>,
    scale: f64,
}

#[differentiable]
impl Network {
    fn run(&mut self, x: f64) -> f64 {
        self.unit.as_mut().unwrap().weights[0] += x * self.scale;
        self.unit.as_mut().unwrap().weights.push(x);
        shift(self.unit.as_mut().unwrap(), x);
        *self.unit.as_mut().unwrap().bias.as_mut().unwrap() *= 3.0;
        for i in 0..2 {
            let unit = self.unit.as_mut().unwrap();
            unit.weights[i] = unit.weights[1 - i] * x;
        }
        let unit = self.unit.as_ref().unwrap();
        unit.weights.iter().sum::<f64>() * unit.bias.unwrap()
    }
}

#[differentiable]
fn run(x: f64, y: f64) -> f64 {
    let unit = Unit { weights: vec![x], bias: Some(y) };
    let mut network = Network { unit: Some(unit), scale: x * y };
    let sum = network.run(y);
    sum * network.unit.unwrap().weights[0]
}

#[test]
fn contents_are_changed_in_place() {
    check!(changed_in_place(x, y) at [0.7, 1.3], [-1.2, 0.4]);
    check!(run(x, y) at [0.7, 1.3], [-1.2, 0.4]);
}

#[test]
fn parts() {
    check!(two(x, y) at [0.7, 1.3], [-1.2, 0.4]);
    check!(of_a_local(x, y) at [0.7, 1.3], [-1.2, 0.4]);
}
