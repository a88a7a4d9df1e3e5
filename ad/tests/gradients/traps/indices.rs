//! Indices that are computed by functions which give another number each time: each is evaluated once, in
//! its turn.

use std::cell::Cell;

use ad::{Differentiable, differentiable};

use crate::oracle::check;

thread_local! {
    static NEXT: Cell<usize> = const { Cell::new(0) };
}

fn start() {
    NEXT.set(0);
}

fn next() -> usize {
    let next = NEXT.get();
    NEXT.set(next + 1);
    next % 3
}

#[derive(Clone, Copy, Differentiable)]
struct Point {
    x: f64,
}

#[differentiable]
impl Point {
    fn moved(&mut self, by: f64) -> f64 {
        self.x += by;
        self.x
    }
}

#[differentiable]
impl std::ops::AddAssign for Point {
    fn add_assign(&mut self, other: Self) {
        self.x += other.x;
    }
}

#[differentiable]
fn scaled(x: &f64, y: f64) -> f64 {
    x * y
}

#[differentiable]
fn read(x: f64, y: f64) -> f64 {
    start();
    let v = [x, y, x * y];
    let (a, b) = (&v[next()], v[next()]);
    let f = |t: f64| t * v[next()];
    let mut s = a * b * scaled(&v[next()], v[next()]) * f(x) * f(y);
    for _ in 0..4 {
        s += v[next()] * v[next()];
    }
    s
}

#[differentiable]
fn changed(x: f64, y: f64) -> f64 {
    start();
    let mut v = [x, y, x * y];
    let a = v[next()].max(0.3) * v[next()].sin();
    v[next()] *= a;
    v[next()] = x * v[next()];
    let t = &mut v[next()];
    *t += y;
    let mut points = [Point { x }, Point { x: y }];
    points[next() % 2] += Point { x: v[next()] };
    points[next() % 2].moved(a) * points[next() % 2].x * v[0] * v[1] * v[2]
}

#[differentiable]
fn run_over(x: f64, y: f64) -> f64 {
    start();
    let mut v = [[x, y, 1.0], [y, x, 2.0], [x, 3.0, y]];
    let mut s = 1.0;
    for w in &v[next()..] {
        s += w[0] * w[2];
    }
    for w in v[next()] {
        s *= w;
    }
    for w in v[next()].iter_mut() {
        *w *= y;
    }
    s * v[next()].iter().sum::<f64>() * v[2][next()]
}

#[differentiable]
fn parts(x: f64, y: f64) -> f64 {
    start();
    let mut v = [vec![x, y], vec![y, 2.0, x], vec![x * y, 3.0]];
    let a = v[next()].first().unwrap() * v[next()].last().unwrap();
    *v[next()].last_mut().unwrap() *= y;
    if let Some(b) = v[next()].get_mut(1) {
        *b += x;
    }
    let (left, right) = v[next()].split_at_mut(1);
    left[0] *= right[0];
    v[next()].swap(0, 1);
    a * v[0][1] * v[1][0] * v[2][0] * v[2][1]
}

#[test]
fn indices_are_evaluated_once() {
    check!(read(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(changed(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(run_over(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(parts(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}
