//! Loops and iterators that take elements by value which are not `Copy`.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[derive(Clone, Debug, Differentiable)]
struct Layer {
    weights: Vec<f64>,
    bias: f64,
}

#[differentiable]
impl Layer {
    fn total(self) -> f64 {
        self.weights.iter().sum::<f64>() + self.bias
    }
}

/// Each is read, changed, kept, or becomes another variable.
#[differentiable]
fn in_loops(x: f64, y: f64) -> f64 {
    let rows = vec![vec![x, y], vec![x * y, 2.0]];
    let mut total = 0.0;
    for row in rows {
        total = total * x + row[0] * row[1];
    }
    let columns = vec![vec![y, x], vec![x * x, y]];
    let mut kept: Vec<Vec<f64>> = Vec::new();
    let mut last = vec![0.0; 2];
    for mut column in columns {
        column[0] *= x;
        column.push(y);
        last = column.clone();
        kept.push(column);
    }
    last[1] *= last[0];
    total + kept[0][0] * kept[1][2] * last[1]
}

/// Some are left out, and the loop ends early.
#[differentiable]
fn some_of_them(x: f64, y: f64) -> f64 {
    let rows = vec![vec![x, y], vec![y], vec![x * y, x], vec![y, y]];
    let mut kept = vec![];
    for (i, row) in rows.into_iter().enumerate().filter(|(_, row)| row.len() > 1) {
        if i == 3 {
            break;
        }
        kept.push(row);
    }
    kept[0][1] * kept[1][0] + kept.len() as f64 * x
}

/// Arrays, pairs, and fields of structs.
#[differentiable]
fn of_other_types(x: f64, y: f64) -> f64 {
    let mut total = 1.0;
    for row in [vec![x, y], vec![2.0, x]] {
        total = total * row[0] + row[1];
    }
    let pairs: Vec<(usize, Vec<f64>)> =
        [x, y].iter().enumerate().map(|(i, t)| (i, vec![*t, t * t])).collect();
    for (i, powers) in pairs {
        total += powers[i] * powers[0];
    }
    let layers =
        vec![Layer { weights: vec![x, y], bias: x * y }, Layer { weights: vec![y], bias: 1.0 }];
    for Layer { weights, bias } in layers.clone() {
        total = total * weights[0] + bias;
    }
    for layer in layers {
        total = total * y + layer.total();
    }
    let sums = [vec![x, y], vec![y, y]].map(|row| row[0] * row[1]);
    total * sums[0] + sums[1]
}

#[differentiable]
fn in_iterators(x: f64, y: f64) -> f64 {
    let rows = || vec![vec![x, y], vec![x * y, 3.0]];
    let products: f64 = rows()
        .into_iter()
        .map(|mut row| {
            row[0] *= x;
            row[0] * row[1]
        })
        .sum();
    let turned: Vec<Vec<f64>> = rows().into_iter().rev().collect();
    let both = rows()
        .into_iter()
        .zip(turned.clone())
        .fold(1.0, |sum, (row, other)| sum * row[0] + other[1]);
    let all: Vec<Vec<f64>> = turned.into_iter().chain(rows()).collect();
    let flat: Vec<f64> = rows().into_iter().flatten().collect();
    products * both + all[0][0] * all[3][0] * flat[2]
}

#[differentiable]
fn drained(x: f64, y: f64) -> f64 {
    let mut rows = vec![vec![x, y], vec![x * y, 2.0], vec![y, y]];
    let mut kept = Vec::new();
    for mut row in rows.drain(1..) {
        row[0] *= 3.0;
        kept.push(row);
    }
    let firsts: Vec<f64> = kept.drain(..).map(|row| row[0]).collect();
    firsts[0] * rows[0][1] + firsts[1] * x
}

/// What is known to be a number is copied.
#[differentiable]
fn of_numbers(xs: Vec<f64>, ys: [f64; 2]) -> f64 {
    let mut total = 1.0;
    for x in xs {
        total = total * x + x;
    }
    ys.map(|y| y * total).into_iter().product()
}

#[differentiable]
fn numbers(x: f64, y: f64) -> f64 {
    of_numbers(vec![x, y, x * y], [y, x])
}

#[derive(Clone, Differentiable)]
struct Input {
    weights: Vec<f64>,
}

#[differentiable]
fn of_clones(inputs: &[Input], rows: &[Vec<f64>], #[constant] factors: &[Vec<f64>]) -> f64 {
    let mut sum = 0.0;
    for input in inputs.iter().cloned() {
        sum += input.weights[0] * input.weights[1];
    }
    for (mut row, input) in rows.iter().cloned().zip(inputs) {
        row[0] *= input.weights[1];
        sum += row[0] * row[0];
    }
    for factor in factors.iter().cloned() {
        sum *= factor[0];
    }
    let doubled = |mut row: Vec<f64>| {
        row[0] *= 2.0;
        row[1] * row[0]
    };
    sum + rows.iter().skip(1).cloned().map(doubled).sum::<f64>()
}

#[differentiable]
fn cloned(x: f64, y: f64) -> f64 {
    let inputs = [Input { weights: vec![x, y] }, Input { weights: vec![x * y, 2.0] }];
    let rows = vec![vec![y, x], vec![x * x, y]];
    of_clones(&inputs, &rows, &[vec![1.5], vec![0.5]])
        + inputs.iter().cloned().fold(y, |product, input| product * input.weights[0])
}

#[test]
fn elements_by_value() {
    check!(cloned(x, y) at [0.7, 1.3], [-0.4, 0.9]);
    check!(in_loops(x, y) at [0.7, 1.3], [-0.4, 0.9]);
    check!(some_of_them(x, y) at [0.7, 1.3], [-0.4, 0.9]);
    check!(of_other_types(x, y) at [0.7, 1.3], [-0.4, 0.9]);
    check!(in_iterators(x, y) at [0.7, 1.3], [-0.4, 0.9]);
    check!(drained(x, y) at [0.7, 1.3], [-0.4, 0.9]);
    check!(numbers(x, y) at [0.7, 1.3], [-0.4, 0.9]);
}
