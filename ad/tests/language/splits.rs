//! Slices in two parts.

use ad::{Differentiable, differentiable};
#[differentiable]
fn total(xs: &[f64]) -> f64 {
    match xs.split_first() {
        Some((first, rest)) => first * first + 0.5 * total(rest).sin(),
        None => 1.0,
    }
}
#[differentiable]
fn split(x: f64, y: f64) -> f64 {
    let mut v = vec![x, y, x * y, 1.0 + x, 2.0];
    let n = v.len();
    {
        let (left, right) = v.split_at_mut(n / 2);
        for i in 0..left.len() {
            left[i] += right[i] * right[2];
            right[i] *= left[i];
        }
        right[2] = left[0];
    }
    let (head, tail) = v.split_first_mut().unwrap();
    for t in tail.iter_mut() {
        *t += *head * 0.5;
        *head += *t;
    }
    let (last, init) = v.split_last_mut().expect("is not empty");
    *last += init[0].sin();
    init[1] = *last;
    let mut sum = total(&v);
    if let Some((last, init)) = v.split_last() {
        sum += last * init[0];
    }
    let (a, b) = v.split_at(2);
    sum + a[1] * b[0]
}
#[test]
fn parts() {
    use crate::oracle::check;

    check!(split(x, y) at [0.7, 0.4], [-0.4, 0.7], [1.3, -0.2]);
}

#[derive(Clone, Copy, Differentiable)]
struct Pair {
    a: f64,
    b: (f64, f64),
}

#[derive(Clone, Copy, Differentiable)]
struct Newtype([f64; 3]);

#[differentiable]
fn shuffle(pair: &mut Pair, by: f64) {
    let Pair { a, b: (c, _) } = pair;
    *a *= by;
    *c += *a * by;
}

/// Names for parts of a place, which are changed behind them.
#[differentiable]
fn taken_apart(x: f64, y: f64) -> f64 {
    let mut pair = Pair { a: x, b: (y, x * y) };
    {
        let Pair { a, b: (c, _) } = &mut pair;
        *a *= 2.0;
        *c += *a;
    }
    let Pair { ref mut a, .. } = pair;
    *a += y * *a;
    let mut rows = [[x, y], [y, x]];
    for i in 0..2 {
        let [first, [_, last]] = &mut rows;
        first[i] *= *last;
        *last += first[0];
    }
    let mut list = vec![Newtype([x, y, 1.0]); 2];
    let Newtype([one, _, three]) = list[1];
    let Newtype([ref mut s, ..]) = list[0];
    *s *= one * three;
    let (ref mut p, _) = pair.b;
    *p = p.sin();
    shuffle(&mut pair, y);
    pair.a * pair.b.0 + pair.b.1 + rows[0][0] * rows[1][1] + list[0].0[0] * list[1].0[0]
}

#[test]
fn places_are_taken_apart() {
    crate::oracle::check!(taken_apart(x, y) at [0.3, 0.7], [-0.4, 1.2]);
}

/// Ranges that are there and that are not.
#[differentiable]
fn ranges(x: f64, y: f64) -> f64 {
    let v = [x, y, x * y, 1.5];
    let mut sum = 0.0;
    for k in 0..6 {
        if let Some(part) = v.get(k..k + 2) {
            sum += part[0] * part[1] * part[1];
        }
        if let Some(part) = v.get(..=k) {
            sum += part.iter().map(|e| e.sin()).sum::<f64>() * part[k];
        }
        sum += v.get(k + 1..).map_or(x, |part| part.len() as f64 * y);
    }
    let Some(all) = v.get(..) else { return 0.0 };
    sum * v.get(1..3).unwrap()[1] + all[0]
}

#[test]
fn parts_are_lent_by_ranges() {
    crate::oracle::check!(ranges(x, y) at [0.3, 0.7], [-0.4, 1.2]);
}
