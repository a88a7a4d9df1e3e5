//! `mem::swap` and its kin on parts that patterns and halves of slices name.

use std::mem;

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[differentiable]
fn of_an_array(x: f64, y: f64) -> f64 {
    let mut v = [x, y, x * y];
    let [a, b, c] = &mut v;
    mem::swap(a, c);
    mem::swap(b, c);
    *b = *c * *a;
    v[0] * v[0] * v[1] + v[2]
}

#[differentiable]
fn exchange(v: &mut [f64], k: usize) -> f64 {
    let (a, b) = v.split_at_mut(k);
    let (c, d) = b.split_at_mut(1);
    mem::swap(&mut a[0], &mut d[0]);
    mem::swap(&mut c[0], &mut a[0]);
    mem::swap(&mut c[0], &mut d[1]);
    a[0] * a[0] + c[0] * d[1]
}

#[differentiable]
fn of_halves(x: f64, y: f64) -> f64 {
    let mut v = [x, y, x * y, x + y];
    let mixed = exchange(&mut v, 1);
    mixed * v[2] + v[3] * v[3] * v[0]
}

#[derive(Clone, Differentiable)]
struct Pair {
    a: Vec<f64>,
    b: f64,
}

#[differentiable]
fn of_structs(x: f64, y: f64) -> f64 {
    let mut pairs = vec![Pair { a: vec![x], b: y }, Pair { a: vec![y, x], b: x * y }];
    let (left, right) = pairs.split_at_mut(1);
    mem::swap(&mut left[0], &mut right[0]);
    let Pair { a, b } = &mut pairs[0];
    let list = mem::take(a);
    let old = mem::replace(b, list[0] * list[1]);
    a.push(old * *b);
    pairs[0].a[0] * pairs[1].a[0] + pairs[0].b
}

/// Two buffers: each step reads one and writes the other.
#[differentiable]
fn step(now: &mut Vec<f64>, next: &mut Vec<f64>, k: f64) {
    for i in 0..now.len() {
        next[i] = now[i] * k + now[(i + 1) % now.len()];
    }
    mem::swap(now, next);
}

#[differentiable]
fn exchanged(
    a: &mut [f64; 2],
    b: &mut Box<[f64; 2]>,
    c: &mut Vec<Vec<f64>>,
    d: &mut Vec<Vec<f64>>,
) {
    mem::swap(a, &mut **b);
    mem::swap(c, d);
    let mut own = [a[0] * b[1], 2.0];
    mem::swap(a, &mut own);
    b[1] += own[0];
}

#[differentiable]
fn of_names(x: f64, y: f64) -> f64 {
    let (mut now, mut next) = (vec![x, y, x * y], vec![0.0; 3]);
    for _ in 0..3 {
        step(&mut now, &mut next, y);
    }
    let (mut a, mut b) = ([now[0], now[1]], Box::new([next[0], next[1]]));
    let (mut c, mut d) = (vec![vec![x]], vec![vec![y, x]]);
    exchanged(&mut a, &mut b, &mut c, &mut d);
    a[0] * b[1] + b[0] * a[1] + c[0][1] * d[0][0] * now[2]
}

#[test]
fn parts_change_places() {
    check!(of_names(x, y) at [0.7, 1.3], [-1.1, 0.4]);
    check!(of_an_array(x, y) at [0.7, 1.3], [-1.1, 0.4]);
    check!(of_halves(x, y) at [0.7, 1.3], [-1.1, 0.4]);
    check!(of_structs(x, y) at [0.7, 1.3], [-1.1, 0.4]);
}

#[differentiable]
fn beyond_its_half(x: f64, y: f64) -> f64 {
    let mut v = vec![x, y];
    let (a, b) = v.split_at_mut(1);
    mem::swap(&mut a[1], &mut b[0]);
    v[0]
}

#[test]
#[should_panic(expected = "out of bounds")]
fn an_index_stays_in_its_half() {
    beyond_its_half::grad(1.0, 2.0);
}
