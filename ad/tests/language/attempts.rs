//! Options and results that only their types tell from each other, and names of types.

use std::num::ParseIntError;

use ad::{Differentiable, differentiable};

use crate::oracle::check;

type Float = f64;
type Outcome<T> = Result<T, String>;
type Perhaps = Option<Float>;

#[differentiable]
fn perhaps(x: f64) -> Perhaps {
    if x > 0.0 { Some(x * x) } else { None }
}

#[differentiable]
fn root(x: f64) -> Outcome<f64> {
    if x < 0.0 {
        return Err("negative".to_owned());
    }
    Ok(x.sqrt())
}

#[differentiable]
fn mapped(x: f64, y: f64) -> f64 {
    let option = perhaps(x).map(|t| t * y).unwrap_or(y);
    let result = root(x).map(|t| t * y).unwrap_or(x * y);
    let chained = perhaps(x).and_then(|t| perhaps(t - y)).map_or(y * y, |t| t * x);
    let also = root(x).and_then(|t| root(t - y)).map_or(y, |t| t * x);
    option * result + chained * also
}

#[derive(Clone, Differentiable)]
struct Body {
    radius: Option<f64>,
    sides: Vec<f64>,
}

#[differentiable]
fn of_fields(x: f64, y: f64) -> f64 {
    let body = Body { radius: perhaps(x), sides: vec![x, x * y] };
    let radius = body.radius.map(|r| r * y).unwrap_or(1.0);
    let area = body.radius.as_ref().map_or(y, |r| r * r);
    let side = body.sides.get(1).map(|side| side * radius).unwrap_or(0.0);
    let first = body.sides.first().map(|side| side * y).unwrap_or(area);
    side + area * first
}

#[differentiable]
fn asked(x: f64, y: f64) -> Outcome<f64> {
    let first = root(x)?;
    let second = root(first + y)?;
    Ok(first * second)
}

#[differentiable]
fn asked_of_options(x: f64, y: f64) -> Perhaps {
    let first = perhaps(x)?;
    Some(first * perhaps(y)? + y)
}

#[differentiable]
fn both(x: f64, y: f64) -> f64 {
    asked(x, y).unwrap_or(x - y) + asked_of_options(x, y).unwrap_or(x * y)
}

#[differentiable]
fn taken(x: f64, y: f64) -> f64 {
    let mut option = perhaps(x);
    let before = option.take();
    let was_taken = option.is_none();
    let replaced = option.replace(x * y);
    let filled = replaced.or(perhaps(y)).unwrap_or(2.0 * x);
    let either = perhaps(x).xor(perhaps(y)).unwrap_or(x);
    let pair = before.zip(option).map(|(a, b)| a * b).unwrap_or(y);
    let inner = Some(before).flatten();
    let inner = inner.filter(|t| *t > y).unwrap_or(x * x);
    if was_taken { pair * filled + inner * either } else { 0.0 }
}

#[differentiable]
fn by_name(x: f64, y: f64) -> f64 {
    let n = 3;
    let scaled = x as Float * n as Float;
    if y as Float > scaled { scaled * y } else { y - scaled }
}

#[test]
fn types_tell_options_from_results() {
    check!(mapped(x, y) at [1.3, 0.4], [-1.3, 0.4], [0.5, 1.4]);
    check!(of_fields(x, y) at [1.3, 0.4], [-1.3, 0.4]);
    check!(both(x, y) at [1.3, 0.4], [-1.3, 0.4], [0.4, -1.3]);
}

#[test]
fn contents_are_taken_and_joined() {
    check!(taken(x, y) at [1.3, 0.4], [-1.3, 0.4], [1.3, -0.4], [-1.3, -0.4]);
    check!(by_name(x, y) at [1.3, 0.4], [0.1, 0.9]);
}

#[differentiable]
fn weighed(x: f64, by: Option<f64>) -> (f64, Option<f64>) {
    (x * 2.0, by.map(|by| by * x))
}

#[differentiable]
fn of_nothing(x: f64, y: f64) -> f64 {
    let (twice, nothing) = weighed(x, None);
    let (again, some) = weighed(y, Some(x));
    twice * nothing.unwrap_or(y) + again * some.unwrap_or(y)
}

#[test]
fn nothing_is_passed() {
    crate::oracle::check!(of_nothing(x, y) at [0.7, 1.3], [-0.4, 0.9]);
}

#[differentiable]
fn root_or_text(x: f64) -> Result<f64, &'static str> {
    if x < 0.0 { Err("negative") } else { Ok(x.sqrt()) }
}

#[differentiable]
fn root_or_nothing(x: f64) -> Result<f64, ()> {
    if x < 0.0 { Err(()) } else { Ok(x.sqrt()) }
}

#[differentiable]
fn with_text(x: f64, y: f64) -> Result<f64, &'static str> {
    let first = perhaps(y).ok_or("not positive")?;
    Ok(first * root_or_text(x)?)
}

#[differentiable]
fn with_owned_text(x: f64, y: f64) -> Outcome<f64> {
    let sides = [x, y];
    let last = *sides.get(1).ok_or("too few")?;
    Ok(last * root_or_text(x)?)
}

#[differentiable]
fn with_nothing(x: f64, y: f64) -> Result<f64, ()> {
    Ok(root_or_nothing(x)? * root_or_nothing(y)?)
}

#[derive(Clone, Differentiable)]
#[constant]
enum Failure {
    Unreadable(String),
    Missing { index: usize },
}

impl From<ParseIntError> for Failure {
    fn from(error: ParseIntError) -> Self {
        Failure::Unreadable(error.to_string())
    }
}

#[differentiable]
fn with_converted(text: &str, x: f64, y: f64) -> Result<f64, Failure> {
    let index: usize = text.parse()?;
    let value = [x, x * y].get(index).copied().ok_or(Failure::Missing { index })?;
    Ok(value * y)
}

#[differentiable]
fn with_texts(x: f64, y: f64) -> f64 {
    let mut sum = 0.0;
    for text in ["1", "x", "0", "9"] {
        sum += match with_converted(text, x, y) {
            Ok(value) => value * x,
            Err(Failure::Unreadable(text)) => y * text.len() as f64,
            Err(Failure::Missing { index }) => x * index as f64,
        };
    }
    sum
}

#[differentiable]
fn with_errors(x: f64, y: f64) -> f64 {
    let texts = with_text(x, y).unwrap_or(x - y) * with_owned_text(x, y).unwrap_or(y);
    texts + with_nothing(x, y).unwrap_or(x * y)
}

#[test]
fn errors_without_derivatives() {
    check!(with_texts(x, y) at [1.3, 0.4], [-1.3, 0.4]);
    check!(with_errors(x, y) at [1.3, 0.4], [-1.3, 0.4], [0.4, -1.3]);
}

/// What `?` returns from a closure its result tells, or what it is given to.
#[differentiable]
fn within_closures(x: f64, y: f64) -> Outcome<f64> {
    let scaled = |t: f64, limit: f64| -> Result<f64, String> {
        if t > limit {
            return Err("too large".to_owned());
        }
        Ok(root(t)? * y)
    };
    let next = root(x).and_then(|t| Ok(root(t + y)? * t));
    let option: Option<f64> = perhaps(x).and_then(|t| Some(perhaps(t - y)? * x));
    let sum: f64 = [x, y].iter().filter_map(|t| Some(perhaps(*t)? * x)).sum();
    Ok(scaled(x, 3.0)? * next.unwrap_or(y) + option.unwrap_or(x) * sum)
}

#[differentiable]
fn of_closures(x: f64, y: f64) -> f64 {
    within_closures(x, y).unwrap_or_else(|error| error.len() as f64 * x * y)
}

#[test]
fn question_marks_within_closures() {
    check!(of_closures(x, y) at [1.3, 0.7], [-0.4, 2.1], [3.4, 0.2], [0.2, 1.1]);
}
