//! Calls that see a few elements of lists of lists, by `&mut`, by value or by a name for a part: each counts
//! for the elements that it sees, and not for the whole.

use ad::{Differentiable, differentiable};

#[differentiable]
fn add(rows: &mut [Vec<f64>], i: usize, x: f64) {
    rows[i / 10][i % 10] += x * rows[0][0];
}

// A `Vec` is lent too, not slices alone.
#[allow(clippy::ptr_arg)]
#[differentiable]
fn add_all(rows: &mut Vec<Vec<f64>>, xs: &[f64]) {
    for (i, x) in xs.iter().enumerate() {
        add(rows, i, *x);
    }
}

#[differentiable]
fn remember(known: &mut [Option<f64>], i: usize, x: f64) {
    known[i] = match known[i / 2] {
        Some(value) => Some(x * value),
        None => Some(x),
    };
}

#[derive(Clone, Differentiable)]
struct Table {
    rows: Vec<Vec<f64>>,
    scale: f64,
}

#[differentiable]
impl Table {
    fn put(&mut self, i: usize, x: f64) {
        self.rows[i / 10][i % 10] += x * self.scale;
    }

    fn with(mut self, i: usize, x: f64) -> Self {
        self.rows[i / 10][i % 10] *= x;
        self
    }

    fn taken_apart(&self, i: usize) -> f64 {
        let Self { rows, scale } = self;
        rows[i / 10][i % 10] * scale
    }

    fn by_reference(&self, i: usize) -> f64 {
        let rows = &self.rows;
        rows[i / 10][i % 10]
    }
}

#[derive(Clone, Differentiable)]
enum Source {
    Even(f64),
    Listed(Vec<f64>),
}

#[differentiable]
impl Source {
    fn at(&self, i: usize) -> f64 {
        match self {
            Self::Even(value) => *value,
            Self::Listed(values) => values[i] * values[0],
        }
    }
}

#[differentiable]
fn lists(xs: &[f64]) -> f64 {
    let mut rows = vec![vec![1.0; 10]; xs.len().div_ceil(10)];
    add_all(&mut rows, xs);
    let mut known = vec![None; xs.len()];
    let mut sum = 0.0;
    for i in 0..xs.len() {
        add(&mut rows, i, xs[i]);
        remember(&mut known, i, xs[i]);
        sum += known[i].unwrap_or(0.0);
    }
    sum + rows[0][1] * rows[xs.len() / 20][0]
}

#[differentiable]
fn methods(xs: &[f64]) -> f64 {
    let mut table = Table { rows: vec![vec![1.0; 10]; xs.len().div_ceil(10)], scale: xs[0] };
    for (i, x) in xs.iter().enumerate() {
        table.put(i, *x);
    }
    let source = if xs.len() > 3 { Source::Listed(xs.to_vec()) } else { Source::Even(xs[0]) };
    let mut sum = 0.0;
    for i in 0..xs.len() {
        sum += table.taken_apart(i) * table.by_reference(i) + source.at(i);
    }
    sum
}

#[differentiable]
fn second(xs: &[f64]) -> f64 {
    xs[0] * xs[1]
}

#[differentiable]
fn of_row(rows: &[Vec<f64>], i: usize) -> f64 {
    rows[i / 10][i % 10]
}

#[differentiable]
fn of_a_field(table: &Table, i: usize) -> f64 {
    let Table { rows, scale } = table;
    of_row(rows, i) * scale
}

/// Names for parts of what stands outside of the loop.
#[differentiable]
fn parts(xs: &[f64]) -> f64 {
    let table = Table { rows: xs.chunks(10).map(<[f64]>::to_vec).collect(), scale: xs[0] };
    let listed = Some(xs.to_vec());
    let mut sum = 0.0;
    for i in 0..xs.len() {
        let Table { rows, scale } = &table;
        let row = &rows[i / 10];
        sum += row[i % 10] * scale;
        if let Some(values) = &listed {
            sum += values[i] * values[0] + second(values);
        }
        sum += of_a_field(&table, i);
    }
    sum
}

#[differentiable]
fn ranges(xs: &[f64]) -> f64 {
    let mut sum = 0.0;
    for i in 1..xs.len() {
        sum += second(&xs[i - 1..]);
    }
    sum
}

#[differentiable]
fn with(mut rows: Vec<Vec<f64>>, i: usize, x: f64) -> Vec<Vec<f64>> {
    rows[i / 10][i % 10] += x * rows[0][0];
    rows
}

#[differentiable]
fn scaled(mut table: Table, i: usize) -> Table {
    table.rows[i / 10][i % 10] *= table.scale;
    table
}

#[differentiable]
fn with_sum(state: (Vec<Option<f64>>, f64), i: usize, x: f64) -> (Vec<Option<f64>>, f64) {
    let (mut known, sum) = state;
    known[i] = Some(x * sum);
    (known, sum + x)
}

/// What moves into a call and out of it.
#[differentiable]
fn values(xs: &[f64]) -> f64 {
    let mut rows = vec![vec![1.0; 10]; xs.len().div_ceil(10)];
    let mut table = Table { rows: xs.chunks(10).map(<[f64]>::to_vec).collect(), scale: xs[0] };
    let mut state = (vec![None; xs.len()], xs[0]);
    for (i, &x) in xs.iter().enumerate() {
        rows = with(rows, i, x);
        table = scaled(table, i);
        table = table.with(i, x);
        state = with_sum(state, i, x);
    }
    rows[0][0] * table.rows[0][1] + state.0[1].unwrap_or(state.1)
}

#[differentiable]
fn element(row: &[f64], i: usize) -> f64 {
    row[i] * row[0]
}

/// Rows that methods of slices and options lend.
#[differentiable]
fn lent(xs: &[f64]) -> f64 {
    let rows = [xs.to_vec(), xs.to_vec()];
    let option = Some(xs.to_vec());
    let mut sum = 0.0;
    for i in 0..xs.len() {
        let row = rows.get(i % 2).unwrap();
        sum += row[i] * rows.last().unwrap()[i];
        if let Some(row) = rows.get(i % 3) {
            sum += row[i] * element(rows.first().unwrap(), i);
        }
        match option.as_ref() {
            Some(row) => sum += row[i],
            None => sum = 0.0,
        }
    }
    sum
}

#[differentiable]
impl Table {
    fn dot(&self, xs: &[f64], i: usize) -> f64 {
        self.rows[i / 10][i % 10] * xs[i]
    }

    fn push(&mut self, i: usize, x: f64) {
        self.rows[i / 10][i % 10] += x * self.scale;
    }
}

/// Methods with the names of those that vectors and lists have.
#[differentiable]
fn named_as_others(xs: &[f64]) -> f64 {
    let mut table = Table { rows: xs.chunks(10).map(<[f64]>::to_vec).collect(), scale: xs[0] };
    let mut sum = 0.0;
    for i in 0..xs.len() {
        table.push(i, xs[i]);
        sum += table.dot(xs, i);
    }
    sum
}

/// The gradient of a function of a slice.
type Gradient = fn(&[f64]) -> Vec<f64>;

/// Each function by its name.
pub const ALL: [(&str, Gradient); 7] = [
    ("lists in lists", lists::grad),
    ("methods of lists in lists", methods::grad),
    ("names for parts", parts::grad),
    ("ranges", ranges::grad),
    ("values", values::grad),
    ("lent rows", lent::grad),
    ("methods named as others", named_as_others::grad),
];
