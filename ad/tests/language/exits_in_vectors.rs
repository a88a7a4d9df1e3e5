//! Exits from within `vec!`: what stands before is evaluated before, and what follows is not.

use std::cell::Cell;

use ad::differentiable;

use crate::oracle::check;

#[differentiable]
fn root(x: f64) -> Option<f64> {
    if x < 0.0 {
        return None;
    }
    Some(x.sqrt())
}

#[differentiable]
fn listed(x: f64, y: f64) -> Option<f64> {
    let t = x * y;
    let all = vec![t, root(x)?, t * t, root(y + 1.0)?, x];
    Some(all.iter().sum::<f64>() * all[1] * all[4])
}

#[differentiable]
fn repeated(x: f64, y: f64) -> Option<Vec<Vec<f64>>> {
    Some(vec![vec![root(x)? * y; 2], vec![x, root(y)?]])
}

#[differentiable]
fn outcomes(x: f64, y: f64) -> f64 {
    let rows = match repeated(x, y) {
        Some(rows) => rows,
        None => vec![vec![x]],
    };
    let last = rows[rows.len() - 1][0];
    last * rows[0][0] * listed(x, y).unwrap_or(-y * last)
}

#[differentiable]
fn in_a_loop(x: f64, y: f64) -> f64 {
    let mut total = x;
    for i in 0..5 {
        let pair = vec![
            total * y,
            match i {
                1 => continue,
                3 => break,
                _ => x,
            },
        ];
        total += pair[0] * pair[1];
    }
    total
}

thread_local! {
    static CALLS: Cell<usize> = const { Cell::new(0) };
}

fn count() -> usize {
    CALLS.set(CALLS.get() + 1);
    CALLS.get()
}

#[differentiable]
fn in_turn(x: f64) -> Option<f64> {
    let all = vec![x * count() as f64, root(x - 10.0)?, x * count() as f64];
    Some(all[0] + all[1])
}

#[test]
fn vectors_are_left() {
    check!(outcomes(x, y) at [0.5, 0.7], [1.3, -0.6], [-0.4, 0.3], [1.4, -1.5]);
    check!(in_a_loop(x, y) at [0.5, 0.7], [-1.1, 0.4]);
    assert!(in_turn::vjp(2.0).0.is_none());
    assert_eq!(CALLS.get(), 1);
}
