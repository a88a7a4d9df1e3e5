//! Lists under `#[constant]` that are fields: elements of tables, lent and looked at.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[derive(Clone, Differentiable)]
struct Table {
    #[constant]
    knots: Vec<f64>,
    #[constant]
    count: usize,
    weights: Vec<f64>,
}

#[differentiable]
impl Table {
    fn new(x: f64, y: f64) -> Self {
        Self { knots: vec![-0.5, 0.5, 2.0], count: 3, weights: vec![x, x * y, y] }
    }

    fn since_first(&self, x: f64) -> f64 {
        let Some(&first) = self.knots.first() else { return 0.0 };
        let last = self.knots.last().unwrap();
        (x - first) / (last - first) * self.weights[0]
    }

    fn between_ends(&self, x: f64) -> f64 {
        let (Some(a), Some(b)) = (self.knots.first(), self.knots.last()) else {
            return x;
        };
        let inner = match (self.knots.get(1), self.weights.get(1)) {
            (Some(k), Some(w)) => k * w,
            _ => 0.0,
        };
        (x - a) / (b - a) + inner
    }

    fn looked_up(&self, x: f64) -> f64 {
        let knots = &self.knots;
        let i = knots.partition_point(|k| *k <= x);
        match knots.get(i) {
            Some(k) if *k > 1.0 => k * x * self.weights[i],
            Some(k) => *k * x,
            None => knots.last().map_or(x, |k| k * x),
        }
    }

    fn doubled(&self, x: f64) -> f64 {
        let n = self.count;
        let mut list = Vec::with_capacity(n);
        for i in 0..n {
            list.push(self.weights[i] * x);
        }
        list.iter().map(|y| y * y).sum()
    }

    fn next(&self, i: usize, x: f64) -> f64 {
        let next = self.knots.get(i + 1).copied().unwrap_or(0.5);
        if let Some(&k) = self.knots.get(i) { (x - k) * next } else { x * next }
    }
}

#[differentiable]
fn interpolated(x: f64, y: f64) -> f64 {
    let table = Table::new(x, y);
    let mut sum = table.since_first(x) * table.between_ends(y) + table.looked_up(x * y);
    sum += table.doubled(y);
    for i in 0..4 {
        sum += table.next(i, y) * table.looked_up(x + i as f64 * 0.6);
    }
    sum
}

#[test]
fn elements_of_tables() {
    check!(interpolated(x, y) at [0.7, 0.4], [-0.45, 1.3], [1.3, -0.2]);
}
