//! Boxes: of whose content nothing moves or a part, and of which a method is given the content.

use std::collections::VecDeque;

use ad::{Differentiable, differentiable};

use crate::oracle::{assert_close, check};

#[derive(Clone, Differentiable)]
enum Formula {
    Variable(usize),
    Sum(Vec<Formula>),
    Negative(Box<Formula>),
    Scaled { by: Vec<f64>, inner: Box<Formula> },
}

#[differentiable]
impl Formula {
    fn at(&self, variables: &[f64]) -> f64 {
        match self {
            Self::Variable(index) => variables[*index] * variables[*index],
            Self::Sum(terms) => terms.iter().map(|term| term.at(variables)).sum(),
            Self::Negative(inner) => -inner.at(variables),
            Self::Scaled { by, inner } => by[0] * by[1] * inner.at(variables),
        }
    }

    fn scale(&mut self, factor: f64) {
        match self {
            Self::Variable(_) => {}
            Self::Sum(terms) => terms.iter_mut().for_each(|term| term.scale(factor)),
            Self::Negative(inner) => inner.scale(factor),
            Self::Scaled { by, inner } => {
                by[1] *= factor;
                by.push(factor);
                inner.scale(factor * 0.5);
            }
        }
    }
}

#[differentiable]
fn formula(x: f64, y: f64) -> f64 {
    let sum = Formula::Sum(vec![Formula::Variable(0), Formula::Variable(1)]);
    let scaled = Formula::Scaled { by: vec![2.0, -0.7], inner: Box::new(sum) };
    let mut formula = Formula::Negative(Box::new(scaled));
    let before = formula.at(&[x, y]);
    formula.scale(y);
    let beside = Formula::Scaled { by: vec![x, 1.0], inner: Box::new(formula.clone()) };
    before * formula.at(&[y, x * y]) + beside.at(&[x, y])
}

#[derive(Clone, Default, Differentiable)]
struct Layer {
    weights: Vec<f64>,
    next: Option<Box<Layer>>,
}

#[differentiable]
impl Layer {
    fn of(weight: f64) -> Layer {
        let last = Layer { weights: vec![1.0, -0.3], next: None };
        Layer { weights: vec![0.5, weight], next: Some(Box::new(last)) }
    }

    fn run(&self, x: f64) -> f64 {
        let mut y = self.weights[0] * x;
        for weight in &self.weights[1..] {
            y += weight * x * x;
        }
        match &self.next {
            Some(next) => next.run(y.tanh()),
            None => y,
        }
    }

    fn grow(&mut self, weight: f64) {
        self.weights.push(weight);
    }

    fn into_run(self, x: f64) -> f64 {
        self.weights[1] * x
    }
}

#[differentiable]
fn run(layer: &Layer, x: f64) -> f64 {
    layer.run(x) * layer.weights[0]
}

#[differentiable]
fn grow(layer: &mut Layer, weight: f64) {
    layer.grow(weight);
}

#[differentiable]
fn sum(values: &[f64], x: f64) -> f64 {
    values[0] + values[1] * x
}

#[differentiable]
fn layers(x: f64, y: f64) -> f64 {
    let mut layers = Layer::of(0.4);
    let before = layers.run(x);
    if let Some(next) = &mut layers.next {
        next.weights[1] *= y;
    }
    before * layers.run(x * y)
}

/// The box is passed as what it holds.
#[differentiable]
fn constant_boxes(x: f64, y: f64) -> f64 {
    let layer = Box::new(Layer { weights: vec![0.3, 0.8], next: None });
    let mut grown = Box::new(Layer { weights: vec![1.3, 0.2], next: None });
    grow(&mut grown, 0.7);
    let values = Box::new(vec![0.4, 1.1]);
    let some = Some(Box::new(Layer { weights: vec![0.1, 0.9], next: None }));
    let of_some = match &some {
        Some(inner) => run(inner, y) + inner.run(x),
        None => x,
    };
    run(&layer, x) * layer.run(y) + grown.run(x) * of_some + sum(&values, y) + layer.into_run(x)
}

#[differentiable]
fn boxed(weight: f64) -> Box<Layer> {
    Box::new(Layer { weights: vec![weight, 0.2], next: None })
}

/// Methods of what a box holds, of boxes that come out of calls.
#[differentiable]
fn receivers(x: f64, y: f64) -> f64 {
    let next = Some(Box::new(x * y));
    let cosine: Box<f64> = next.clone().unwrap();
    let root = next.unwrap().sin() + cosine.cos();
    let layers = Layer { weights: vec![x], next: Some(boxed(y)) };
    let mut sum = layers.next.clone().unwrap().run(x) * boxed(root).run(y);
    for i in 0..2 {
        let list = vec![boxed(y * i as f64)];
        sum += list.last().unwrap().run(x) + boxed(x).into_run(sum);
    }
    sum + layers.next.unwrap().into_run(y)
}

#[derive(Clone, Differentiable)]
struct Boxes {
    list: Vec<Box<Vec<f64>>>,
    queue: VecDeque<Box<Vec<f64>>>,
    array: [Box<Vec<f64>>; 2],
    pair: (usize, Box<Vec<f64>>),
    outcome: Result<Box<Vec<f64>>, usize>,
    deep: Box<Box<Vec<f64>>>,
    #[constant]
    name: Box<str>,
}

fn boxes_of(values: &[f64]) -> Boxes {
    let boxed = || Box::new(values.to_vec());
    Boxes {
        list: vec![boxed()],
        queue: VecDeque::from([boxed()]),
        array: [boxed(), boxed()],
        pair: (1, boxed()),
        outcome: Ok(boxed()),
        deep: Box::new(boxed()),
        name: "boxes".into(),
    }
}

#[differentiable]
impl Boxes {
    fn value(&self, x: f64) -> f64 {
        let mut value = self.list[0][1] * x + self.queue[0][1] * x * x;
        value += self.array[1][1] * self.pair.1[1] * x + self.deep[1] * x;
        if let Ok(content) = &self.outcome {
            value += content[1] * x;
        }
        value * self.name.len() as f64
    }
}

#[differentiable]
fn containers(x: f64, y: f64) -> f64 {
    let mut boxes = boxes_of(&[0.7, 1.2]);
    boxes.list[0][0] += y;
    boxes.value(x) * boxes.list[0][0]
}

#[test]
fn contents() {
    check!(formula(x, y) at [0.7, 0.4], [-0.4, 0.7], [1.3, -0.2]);
    check!(layers(x, y) at [0.7, 0.4], [-0.4, 0.7], [1.3, -0.2]);
    check!(constant_boxes(x, y) at [0.7, 0.4], [-0.4, 0.7], [1.3, -0.2]);
    check!(receivers(x, y) at [0.7, 0.4], [-0.4, 0.7], [1.3, -0.2]);
    check!(containers(x, y) at [0.7, 0.4], [-0.4, 0.7], [1.3, -0.2]);
}

#[test]
fn zeros_reach_into_boxes() {
    let layers = Layer::of(0.4);
    let (value, tangent) = layers.run_jvp(0.7, &layers.zero_tangent(), 1.0);
    let estimate = ad::check::gradient(|x| layers.run(x[0]), &[0.7], 1e-3)[0].value;
    assert_eq!(value, layers.run(0.7));
    assert_close("by the argument", tangent, estimate, 1e-7);
}
