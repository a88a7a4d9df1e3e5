//! `collect` into an option or a result of a `Vec`, `sum` and `product` into one of a number.

use std::cell::Cell;

use ad::{Differentiable, differentiable};

use crate::oracle::check_list;

thread_local! {
    static CALLS: Cell<usize> = const { Cell::new(0) };
}

/// An error that carries a derivative.
#[derive(Clone, Debug, PartialEq, Differentiable)]
enum Failure {
    Negative(f64),
    #[allow(dead_code)]
    Other,
}

#[differentiable]
fn root(x: f64) -> Result<f64, Failure> {
    if x < 0.0 {
        return Err(Failure::Negative(x * x));
    }
    Ok(x.sqrt())
}

#[differentiable]
fn counted(x: f64) -> Option<f64> {
    ad::no_diff(|| CALLS.set(CALLS.get() + 1));
    if x < 0.0 { None } else { Some(x * x) }
}

#[differentiable]
fn roots(x: &[f64]) -> Result<Vec<f64>, Failure> {
    x.iter().filter(|x| **x != 1.0).map(|x| root(*x)).collect()
}

#[differentiable]
fn named_root(x: f64) -> Result<f64, String> {
    root(x).map_err(|_| "negative".to_owned())
}

#[differentiable]
fn sum_of_roots(x: &[f64]) -> Result<f64, String> {
    let all: Vec<f64> = x.iter().copied().map(named_root).collect::<Result<_, _>>()?;
    Ok(all.iter().zip(x).map(|(a, b)| a * b).sum::<f64>())
}

#[differentiable]
fn in_turns(x: &[f64]) -> f64 {
    let first = match roots(x) {
        Ok(roots) => roots[0] * roots[roots.len() - 1],
        Err(Failure::Negative(square)) => square * x[0],
        Err(Failure::Other) => 0.0,
    };
    first * sum_of_roots(x).unwrap_or(x[1])
}

#[differentiable]
fn squares(x: &[f64]) -> Option<f64> {
    let pairs: Option<Vec<(f64, usize)>> =
        x.iter().enumerate().map(|(i, x)| counted(*x).map(|square| (square, i))).collect();
    let mut total = 0.0;
    let pairs = pairs?;
    for (square, i) in pairs {
        total += square * (i + 1) as f64;
    }
    let rows = x
        .chunks(2)
        .map(|row| row.iter().map(|x| counted(*x)).collect::<Option<Vec<f64>>>())
        .collect::<Option<Vec<_>>>()?;
    Some(total * rows[1][0])
}

#[differentiable]
fn of_options(x: &[f64]) -> f64 {
    squares(x).unwrap_or(x[0] * x[2])
}

#[test]
fn attempts_are_collected() {
    check_list!(in_turns, of_options at [0.5, 0.9, 3.0]);
    check_list!(in_turns, of_options at [0.5, -0.9, 3.0, -2.0]);
    assert_eq!(roots(&[1.0]), Ok(Vec::new()));
    assert_eq!(roots::vjp(&[1.0]).0, Ok(Vec::new()));
    CALLS.set(0);
    assert_eq!(squares::vjp(&[1.0, -1.0, 2.0]).0, None);
    assert_eq!(CALLS.get(), 2);
}

#[differentiable]
fn added(x: &[f64]) -> f64 {
    let sum: Result<f64, Failure> = x.iter().skip(1).map(|x| root(*x)).sum();
    match sum {
        Ok(sum) => sum * sum,
        Err(Failure::Negative(square)) => square * x[0],
        Err(Failure::Other) => 0.0,
    }
}

#[differentiable]
fn multiplied(x: &[f64]) -> Option<f64> {
    x.iter().map(|x| counted(*x)).product()
}

#[differentiable]
fn of_products(x: &[f64]) -> f64 {
    let own = multiplied(&x[..2]).map_or(x[0], |product| product * x[1]);
    own + x.iter().map(|x| counted(*x)).sum::<Option<f64>>().unwrap_or(x[0] * x[2])
}

#[test]
fn attempts_are_added_and_multiplied() {
    check_list!(added, of_products at [0.5, 0.9, 3.0]);
    check_list!(added, of_products at [0.5, -0.9, 3.0, -2.0]);
    assert_eq!(multiplied::vjp(&[]).0, Some(1.0));
    CALLS.set(0);
    assert_eq!(multiplied::vjp(&[1.0, -1.0, 2.0]).0, None);
    assert_eq!(CALLS.get(), 2);
}
