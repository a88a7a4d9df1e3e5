//! Methods of one's own types that have the names of methods of slices, options and iterators.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[derive(Clone, Copy, Differentiable)]
struct Pair {
    a: f64,
    b: f64,
}

#[differentiable]
impl Pair {
    fn new(a: f64, b: f64) -> Self {
        Self { a, b }
    }

    fn get(&self, i: usize) -> f64 {
        if i == 0 { self.a * self.b } else { self.b * self.b }
    }

    fn first(&self) -> f64 {
        self.a * self.a
    }

    fn last(self) -> f64 {
        self.b.sin()
    }

    fn split_at(&self, at: f64) -> (f64, f64) {
        (self.a * at, self.b / at)
    }

    fn split_first(&self) -> (f64, f64) {
        (self.a, self.get(1))
    }

    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Self { a: f(self.a), b: f(self.b) }
    }

    fn and_then(&self, f: impl Fn(f64) -> f64) -> f64 {
        f(self.a * self.b)
    }

    fn filter(&self, f: impl Fn(f64) -> f64) -> f64 {
        f(self.a) + f(self.b)
    }

    fn ok(&self) -> f64 {
        self.a - self.b * self.b
    }

    fn ok_or(&self, otherwise: f64) -> f64 {
        self.a * otherwise
    }

    fn then_some(&self, other: f64) -> f64 {
        self.b * other * other
    }

    fn unwrap_or_else(&self, f: impl Fn() -> f64) -> f64 {
        self.a * f()
    }

    fn sort_by(&self, f: impl Fn(f64, f64) -> f64) -> f64 {
        f(self.a, self.b) * self.a
    }

    fn retain(&self, f: impl Fn(f64) -> f64) -> f64 {
        f(self.b) * self.a
    }

    fn iter(&self) -> f64 {
        self.a * 3.0 * self.b
    }

    fn decided_by_self(&self, x: f64) -> f64 {
        self.sort_by(|a, b| a * b * x) + self.retain(|v| v * v)
    }

    fn of_self(&self, t: f64) -> f64 {
        let scaled = self.map(|v| v * t);
        let by_name: Self = scaled;
        self.get(0) * self.first() + by_name.last() + self.filter(|v| v * v)
    }
}

#[differentiable]
fn parts(x: f64, y: f64) -> f64 {
    let pair = Pair { a: x, b: y };
    let (low, high) = pair.split_at(x);
    let (first, rest) = pair.split_first();
    pair.get(0) * pair.get(1) + pair.first() * pair.last() + low * high + first * rest
}

#[differentiable]
fn given(pair: &Pair, t: f64) -> f64 {
    let mapped: Pair = pair.map(|v| v * t + v.cos());
    let mut sum = 0.0;
    for i in 0..3 {
        sum += mapped.get(i) * pair.and_then(|v| v * t);
    }
    sum + pair.filter(|v| v * v * t) + pair.ok() * pair.ok_or(t) + pair.then_some(t) + pair.iter()
}

#[differentiable]
fn decided(x: f64, y: f64) -> f64 {
    let pair = Pair::new(x, y);
    let boxed: Box<Pair> = Box::new(pair);
    pair.decided_by_self(x) * pair.unwrap_or_else(|| y * y)
        + boxed.get(1) * boxed.last()
        + Pair::new(y, x).retain(|v| v * v)
}

#[differentiable]
fn made(x: f64, y: f64) -> f64 {
    Pair { a: y, b: x }.get(0) * Pair::new(x, y).first() + Pair::new(x, x * y).of_self(y)
}

#[differentiable]
fn passed(x: f64, y: f64) -> f64 {
    given(&Pair { a: x, b: y }, x * y)
}

#[test]
fn the_type_tells_whose_method_it_is() {
    check!(parts(x, y) at [0.7, 1.3], [-1.2, 0.4]);
    check!(passed(x, y) at [0.7, 1.3], [-1.2, 0.4]);
    check!(decided(x, y) at [0.7, 1.3], [-1.2, 0.4]);
    check!(made(x, y) at [0.7, 1.3], [-1.2, 0.4]);
}

type Row = Vec<f64>;
type Corner = [f64; 2];

#[differentiable]
fn of_row(row: &Row, at: usize) -> f64 {
    let mut sum = *row.get(at).unwrap() * row.first().unwrap();
    if let Some(&last) = row.last() {
        sum += last * last;
    }
    if let Some(beyond) = row.get(at + 7) {
        sum += beyond;
    }
    sum + row.get(9).copied().unwrap_or(row[0])
}

#[differentiable]
fn of_corner(x: f64, y: f64) -> f64 {
    let corner: Corner = [x * y, y];
    let row: Row = vec![x, y, x * y];
    corner.first().unwrap() * corner.last().unwrap() + of_row(&row, 1) + *row.get(2).unwrap()
}

#[differentiable]
fn changed(x: f64, y: f64) -> f64 {
    let mut row: Row = vec![x, y, x * y, -0.3];
    let more: Row = vec![y, x];
    row.extend(more.iter());
    row.sort_by(|a, b| a.total_cmp(b));
    row.retain(|v| *v < 100.0);
    let taken: Row = row.drain(1..3).collect();
    row[0] * taken[0] + row[1] * taken[1] * row.last().unwrap()
}

#[differentiable]
fn split(x: f64, y: f64) -> f64 {
    let row: Row = vec![x, y, x * y, y * y];
    let (left, right) = row.split_at(1);
    let mut sum = left[0] * right[1];
    if let Some((first, rest)) = row.split_first() {
        sum += first * rest[2];
    }
    if let Some((last, rest)) = row.split_last() {
        sum += last * rest[1] * rest[1];
    }
    let (_, empty) = row.split_at(4);
    let rest: Row = empty.to_vec();
    match rest.split_first() {
        Some((first, _)) => sum * first,
        None => sum,
    }
}

#[test]
fn other_names_of_sequences() {
    check!(of_corner(x, y) at [0.7, 1.3], [-1.2, 0.4]);
    check!(changed(x, y) at [0.7, 1.3], [-1.2, 0.4]);
    check!(split(x, y) at [0.7, 1.3], [-1.2, 0.4]);
}

#[differentiable]
trait Rated {
    fn rated(&self, t: f64) -> f64;
}

#[differentiable]
impl Rated for Vec<f64> {
    fn rated(&self, t: f64) -> f64 {
        self.first().unwrap() * self.get(1).unwrap() * t
    }
}

#[differentiable]
impl Rated for Pair {
    fn rated(&self, t: f64) -> f64 {
        self.first() * self.get(1) * t
    }
}

#[differentiable]
fn rated(x: f64, y: f64) -> f64 {
    vec![x, y].rated(y) + Pair { a: x, b: y }.rated(x)
}

#[test]
fn methods_of_what_a_trait_is_for() {
    check!(rated(x, y) at [0.7, 1.3], [-1.2, 0.4]);
}
