//! Structs under `#[constant]`: errors, indices and other data beside numbers.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[derive(Debug, Clone, Differentiable)]
#[constant]
struct TooLarge(usize);

#[derive(Debug, Clone, Differentiable)]
#[constant]
struct Failure {
    at: usize,
    reason: String,
}

impl From<TooLarge> for Failure {
    fn from(TooLarge(at): TooLarge) -> Self {
        Self { at, reason: "too large".to_owned() }
    }
}

#[derive(Debug, Clone, Copy, Differentiable)]
#[constant]
struct Nothing;

#[derive(Debug, Clone, Copy, Differentiable)]
#[constant]
struct Id(usize);

#[differentiable]
fn squared(x: f64) -> Result<f64, TooLarge> {
    if x > 10.0 {
        return Err(TooLarge(3));
    }
    Ok(x * x)
}

#[differentiable]
fn summed(x: f64) -> Result<f64, TooLarge> {
    let mut sum = squared(x)? * 0.5;
    for i in 0..3 {
        sum += squared(x + i as f64)?;
    }
    Ok(sum)
}

#[differentiable]
fn converted(x: f64) -> Result<f64, Failure> {
    let y = squared(x)?;
    if y < 0.0 {
        return Err(Failure { at: 1, reason: "negative".to_owned() });
    }
    Ok(y * x)
}

#[differentiable]
fn root(x: f64) -> Result<f64, Nothing> {
    if x < 0.0 { Err(Nothing) } else { Ok(x.sqrt()) }
}

#[differentiable]
fn of_root(x: f64) -> Result<f64, Nothing> {
    let y = root(x * x + 1.0)?;
    Ok(y * y * y)
}

#[differentiable]
fn chosen(v: &[f64], id: Option<Id>) -> Option<f64> {
    let id = id?;
    let (other, x) = (Id(0), v[1]);
    Some(v[id.0] * x + v[other.0])
}

#[differentiable]
fn with_data(x: f64) -> Option<(f64, Failure)> {
    Some((x.sin(), Failure { at: 2, reason: String::new() }))
}

#[differentiable]
fn taken_apart(x: f64) -> Option<f64> {
    let (y, failure) = with_data(x)?;
    Some(y * (failure.at + failure.reason.len()) as f64)
}

#[differentiable]
fn all(x: f64, y: f64) -> f64 {
    let v = [x, y, x * y];
    let mut sum = summed(x).unwrap() * converted(y).unwrap_or(0.5) + of_root(x).unwrap_or(0.0);
    sum += chosen(&v, Some(Id(2))).unwrap() * taken_apart(y).unwrap();
    match squared(y) {
        Ok(z) => sum * z,
        Err(TooLarge(n)) => sum * n as f64,
    }
}

#[test]
fn data_goes_beside_numbers() {
    check!(all(x, y) at [0.7, 0.4], [-0.4, 11.0], [1.3, -0.2]);
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Call,
    Put,
}

#[derive(Clone, Differentiable)]
struct Contract {
    strike: f64,
    dates: Vec<f64>,
    barrier: Option<[f64; 2]>,
    #[constant]
    spread: f64,
    #[constant]
    kind: Kind,
}

/// `#[constant]` fields may be given beside the rest of another struct.
#[differentiable]
fn updated(x: f64, y: f64) -> f64 {
    let barrier = Some([x, y]);
    let call = Contract { strike: x, dates: vec![y], barrier, spread: 0.5, kind: Kind::Call };
    let put = Contract { kind: Kind::Put, spread: 2.0, ..call.clone() };
    let plain = Contract { barrier: None, dates: vec![3.0, 1.0], ..put.clone() };
    let moved = Contract { strike: x * y, barrier: Some([1.0, 2.0]), ..plain.clone() };
    match put.kind == Kind::Put {
        true => {
            put.strike * put.dates[0] + moved.strike * plain.dates[0] * moved.barrier.unwrap()[1]
        }
        false => call.strike,
    }
}

#[test]
fn constant_fields_of_updated_structs() {
    check!(updated(x, y) at [0.7, 0.4], [-0.4, 11.0]);
}
