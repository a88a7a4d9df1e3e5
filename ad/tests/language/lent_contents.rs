//! Parts of what an option lends: `option.as_ref().unwrap().part`.

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

#[test]
fn parts() {
    check!(two(x, y) at [0.7, 1.3], [-1.2, 0.4]);
    check!(of_a_local(x, y) at [0.7, 1.3], [-1.2, 0.4]);
}
