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
