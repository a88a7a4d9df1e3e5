//! Enums without a derivative whose variants hold data.

use ad::{Differentiable, differentiable};

use crate::oracle::{check, check_list};

#[derive(Clone, Copy, Differentiable)]
#[constant]
enum Token {
    Variable(usize),
    Scaled { index: usize, by: f64 },
    Add,
    Multiply,
}

#[differentiable]
fn evaluated(variables: &[f64], tokens: &[Token]) -> f64 {
    let mut stack: Vec<f64> = Vec::new();
    for token in tokens {
        let value = match token {
            Token::Variable(index) => variables[*index],
            Token::Scaled { index, by } => variables[*index] * by,
            Token::Add => stack.pop().unwrap() + stack.pop().unwrap(),
            Token::Multiply => {
                let right = stack.pop().unwrap();
                stack.pop().unwrap() * right
            }
        };
        stack.push(value);
    }
    stack[0]
}

#[differentiable]
fn by_value(variables: &[f64], token: Token) -> f64 {
    match token {
        Token::Variable(index) => variables[index] * variables[index],
        Token::Scaled { by, .. } if by > 1.0 => by * variables[0],
        _ => variables[1],
    }
}

#[differentiable]
fn formula(x: &[f64]) -> f64 {
    let tokens = [
        Token::Variable(0),
        Token::Scaled { index: 1, by: 2.5 },
        Token::Multiply,
        Token::Variable(0),
        Token::Add,
    ];
    evaluated(x, &tokens) + by_value(x, tokens[1]) * by_value(x, Token::Variable(1))
}

#[derive(Clone, Differentiable)]
#[constant]
enum Table<T> {
    Rows { rows: Vec<f64>, pair: [f64; 2] },
    One(T),
    Empty,
}

#[derive(Clone, Differentiable)]
struct Scale {
    #[constant]
    rows: Vec<f64>,
    by: f64,
}

#[differentiable]
fn looked_up(table: &Table<f32>, scale: &Scale, x: f64) -> f64 {
    let Scale { rows: factors, by } = scale;
    let looked_up = match table {
        Table::Rows { rows, pair } => x * rows[1] * x * pair[0],
        Table::One(value) => x * *value as f64,
        Table::Empty => 1.0,
    };
    looked_up * factors[0] * by
}

#[differentiable]
fn tables(x: f64, y: f64) -> f64 {
    let scale = Scale { rows: vec![1.5], by: y };
    let rows = Table::Rows { rows: vec![0.5, 3.0], pair: [2.0, 4.0] };
    looked_up(&rows, &scale, x) + looked_up(&Table::One(0.5), &scale, x)
        - looked_up(&Table::Empty, &scale, x)
}

#[test]
fn data_of_variants() {
    check_list!(formula at [0.7, 1.3]);
    check!(tables(x, y) at [0.7, 1.3], [-1.2, 0.4]);
}

#[derive(Clone, Copy, Differentiable)]
enum Activation<T, const N: usize> {
    Linear(T),
    Polynomial([T; N]),
    Shifted { slope: T, by: f64 },
    Sine,
}

/// A field of a type that has a derivative elsewhere.
#[derive(Clone, Copy, Differentiable)]
struct Layer {
    weight: f64,
    #[constant]
    activation: Activation<f64, 2>,
}

#[differentiable]
impl Layer {
    fn run(&self, x: f64) -> f64 {
        let input = self.weight * x;
        match self.activation {
            Activation::Linear(slope) => slope * input,
            Activation::Polynomial([linear, square]) => linear * input + square * input * input,
            Activation::Shifted { slope, by } => slope * input + by,
            Activation::Sine => input.sin(),
        }
    }
}

#[differentiable]
fn slope_of(layer: &Layer, x: f64) -> f64 {
    if let Activation::Shifted { slope, .. } = &layer.activation { *slope * x } else { x * x }
}

#[differentiable]
fn layers(x: f64, y: f64) -> f64 {
    let kinds = [
        Layer { weight: y, activation: Activation::Linear(0.5) },
        Layer { weight: x, activation: Activation::Polynomial([1.5, 2.0]) },
        Layer { weight: y * y, activation: Activation::Shifted { slope: 3.0, by: 0.1 } },
        Layer { weight: x * y, activation: Activation::Sine },
    ];
    let mut value = x;
    for layer in &kinds {
        value = layer.run(value) + slope_of(layer, y);
    }
    value
}

#[test]
fn constant_fields_of_enums() {
    check!(layers(x, y) at [0.7, 1.3], [-1.2, 0.4]);
}
