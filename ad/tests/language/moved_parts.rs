//! Parts that move out of structs, tuples, arrays and boxes by themselves, and are given other values.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[derive(Clone, Copy, Differentiable)]
struct Small {
    a: f64,
    b: Option<f64>,
    c: [f64; 2],
}

#[derive(Clone, Differentiable)]
struct Table {
    rows: Vec<Vec<f64>>,
    scale: f64,
    weights: Vec<f64>,
}

#[derive(Clone, Differentiable)]
struct Holder {
    table: Box<Table>,
    sum: f64,
    list: Option<Vec<f64>>,
}

type Link = Box<Table>;

#[differentiable]
fn scaled(mut list: Vec<f64>, by: f64) -> Vec<f64> {
    list[0] *= by;
    list
}

/// A part moves, another is read meanwhile, and one way alone gives it back.
#[differentiable]
fn of_tuples(x: f64, y: f64) -> f64 {
    let mut pair = (vec![x, y], vec![y, x]);
    let mut sum = 0.0;
    for _ in 0..4 {
        let list = pair.0;
        if sum > 0.3 {
            pair.0 = scaled(list, y);
        } else {
            sum += list[0];
            pair.0 = list;
        }
        sum += pair.1[0] * pair.0[1];
        pair.1 = scaled(pair.1, x);
    }
    let (first, second) = (pair.0, pair.1);
    sum + first[0] * second[0]
}

/// What is `Copy` is read again after it moved.
#[differentiable]
fn of_copies(x: f64, y: f64) -> f64 {
    let mut small = Small { a: x, b: Some(y), c: [x, y] };
    let mut sum = 0.0;
    for _ in 0..3 {
        let c = small.c;
        small.c[0] = sum + y;
        let next = small.c;
        let b = small.b;
        small.b = Some(c[0] * y);
        sum += c[0] * next[0] + b.unwrap() * small.b.unwrap();
        let whole = small;
        small.a = sum;
        sum += whole.a * small.a;
    }
    sum + small.c[1]
}

#[differentiable]
fn of_a_parameter(table: Table, x: f64) -> Table {
    let mut rows = table.rows;
    rows[0][0] *= x;
    let weights = table.weights;
    Table { rows, scale: table.scale * weights[0], weights }
}

#[differentiable]
fn of_a_box(table: Link) -> f64 {
    let rows = table.rows;
    rows[0][0] * table.scale
}

#[differentiable]
impl Table {
    fn stepped(self, x: f64) -> Self {
        let rows = self.rows;
        let weights = self.weights;
        Table { rows, scale: self.scale * weights[0] * x, weights }
    }

    fn changed(mut self, x: f64) -> Self {
        let mut rows = self.rows;
        rows[0][0] += x;
        self.rows = rows;
        let weights = self.weights;
        Table { rows: self.rows, scale: self.scale * weights[0] * x, weights }
    }
}

#[differentiable]
fn of_structs(x: f64, y: f64) -> f64 {
    let start = Table { rows: vec![vec![x]], scale: y, weights: vec![y] };
    let table = of_a_parameter(start, x).stepped(y).changed(x);
    let boxed = of_a_box(Box::new(table.clone()));
    let (rows, weights) = (table.rows, table.weights);
    boxed * rows[0][0] * weights[0] * table.scale
}

#[differentiable]
fn of_boxes(x: f64, y: f64) -> f64 {
    let table = Box::new(Table { rows: vec![vec![x, y]], scale: y, weights: vec![x] });
    let mut holder = Holder { table, sum: x, list: Some(vec![x]) };
    for _ in 0..3 {
        holder.table.weights = scaled(holder.table.weights, y);
        holder.sum += holder.table.weights[0];
        let before = holder.list;
        holder.list = match before {
            Some(list) => Some(scaled(list, holder.sum)),
            None => None,
        };
    }
    let rows = holder.table.rows;
    holder.sum * holder.list.unwrap()[0] * rows[0][1]
}

#[differentiable]
fn of_arrays(x: f64, y: f64) -> f64 {
    let mut lists = [vec![x, y], vec![y, x], vec![x]];
    let mut sum = 0.0;
    for _ in 0..3 {
        let [a, mut b, c] = lists;
        b[0] *= y;
        sum += a[0] * c[0];
        lists = if sum > 0.5 { [b, c, a] } else { [c, a, b] };
    }
    let [first, .., last] = lists;
    sum * first[0] + last[0]
}

#[differentiable]
fn tables(x: f64, y: f64) -> Vec<Table> {
    let rows = vec![vec![x, y], vec![x * y, y]];
    vec![
        Table { rows, scale: x, weights: vec![y] },
        Table { rows: vec![], scale: x * y, weights: vec![x, y] },
    ]
}

/// Parts of parts of what a call gives, of which none has a name.
#[differentiable]
fn of_what_calls_give(x: f64, y: f64) -> f64 {
    let mut i = 1;
    let first = tables(x, y)[0].rows[i][0] * tables(x, y)[1].scale;
    i -= 1;
    let second = (tables(y, x)[1].weights)[i] + [[x, y], [y, 2.0]][1][i];
    first * second + vec![(x, vec![y])][0].1[0]
}

#[test]
fn parts_move_with_their_tangents() {
    let points = [[0.5, 1.3], [1.2, 0.8], [1.7, 1.6], [0.3, 0.4]];
    for [x, y] in points {
        check!(of_tuples(x, y) at [x, y]);
        check!(of_copies(x, y) at [x, y]);
        check!(of_structs(x, y) at [x, y]);
        check!(of_boxes(x, y) at [x, y]);
        check!(of_arrays(x, y) at [x, y]);
        check!(of_what_calls_give(x, y) at [x, y]);
    }
}
