//! Methods of options and results.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[differentiable]
fn root(x: f64) -> Result<f64, String> {
    if x < 0.0 {
        return Err(format!("negative: {x}"));
    }
    Ok(x.sqrt())
}
#[differentiable]
fn opt(x: f64) -> Option<f64> {
    if x > 0.0 { Some(x * x) } else { None }
}
#[differentiable]
fn chain(x: f64, y: f64) -> Result<f64, String> {
    let a = opt(x).ok_or("none").map_err(|e| e.to_string())?;
    let b = opt(y).ok_or_else(|| "none".to_string())?;
    let c = root(a - b).unwrap_or(y * 3.0);
    let d = root(a - 2.0 * b).ok().unwrap_or_default();
    let e: Result<f64, String> = root(b);
    let f = e.map(|v| v * x).and_then(|v| root(v * y)).map_or(y, |v| v * v);
    let g = root(-x).unwrap_or_default() + root(x).unwrap_or_default();
    let h: Result<f64, String> = root(y - x);
    let i =
        h.or_else(|e| if e.is_empty() { Err(e) } else { Ok::<f64, String>(x * y) }).unwrap_or(7.0);
    Ok(a * b + c * d + f * g + i)
}
#[differentiable]
fn caught(x: f64, y: f64) -> f64 {
    chain(x, y).unwrap_or_else(|_| x + 2.0 * y)
}

#[test]
fn methods() {
    // Each point goes another way: the difference of two squares is negative, or one is missing.
    check!(caught(x, y) at [0.7, 0.4], [0.4, 0.7], [1.3, 0.2], [-1.0, 0.5], [1.0, -2.0]);
}

/// Methods that take an option by value, on options behind references.
#[differentiable]
fn behind_references(x: f64, y: f64) -> f64 {
    let list = [Some(x), None, Some(x * y), Some(y)];
    let first = list.iter().find_map(|o| o.filter(|v| *v > 1.0)).unwrap_or(y);
    let mut sum = 0.0;
    for o in &list {
        sum += o.map(|v| v * x).unwrap_or(y) + o.map_or(0.5 * y, |v| v.sin());
        sum *= o.and_then(|v| (v > 0.9).then_some(v * v)).unwrap_or_else(|| 1.1);
    }
    first + sum + of_reference(&list[2]) + of_result(&Ok(x)) * of_result(&Err(3))
}

#[differentiable]
fn of_reference(o: &Option<f64>) -> f64 {
    o.map(|v| v * v).or_else(|| Some(1.0)).unwrap_or(0.0) + o.ok_or(2).map_or(0.0, |v: f64| v * 3.0)
}

#[differentiable]
fn of_result(r: &Result<f64, u8>) -> f64 {
    r.map_or(2.0, |v| v * v) + r.unwrap_or_else(|e| e as f64)
}

/// Elements, or other numbers where there are none, as references.
#[derive(Clone, Differentiable)]
struct History {
    values: Vec<f64>,
    fallback: f64,
}
#[differentiable]
impl History {
    fn newest(&self) -> f64 {
        *self.values.last().unwrap_or(&self.fallback)
    }
    fn oldest(&self) -> &f64 {
        self.values.first().unwrap_or(&self.fallback)
    }
}
#[differentiable]
fn element_or(v: &[f64], i: usize) -> f64 {
    *v.get(i).unwrap_or(&0.5) * v.last().unwrap_or(&v[0])
}
#[differentiable]
fn chosen(v: &[f64], i: usize, w: &f64) -> f64 {
    v.get(i).unwrap_or(w) * 2.0
}
#[differentiable]
fn references_or(x: f64, y: f64) -> f64 {
    let v = [x, y, x * y];
    let mut h = History { values: vec![], fallback: y * y };
    let a = h.newest() + *h.oldest();
    h.values.push(x * x);
    h.values.push(x);
    let z: &f64 = v.get(7).unwrap_or(&y);
    (0..5).map(|i| element_or(&v, i) + chosen(&v, i, &x)).sum::<f64>() * a
        + h.newest() * *h.oldest()
        + z * z
}

#[test]
fn options_behind_references() {
    check!(behind_references(x, y) at [1.3, 0.7], [0.4, 2.1]);
    check!(references_or(x, y) at [1.3, 0.7], [0.4, 2.1]);
}

#[derive(Differentiable)]
struct Layer {
    cache: Option<Vec<f64>>,
    output: Result<Vec<f64>, String>,
}

#[differentiable]
impl Layer {
    fn cached(&self) -> Option<&Vec<f64>> {
        self.cache.as_ref()
    }
}

/// What is looked at through an option lives no longer than the function.
#[differentiable]
fn contents_of_locals(x: f64, y: f64) -> f64 {
    let option = if x > 0.0 { Some(vec![x, y]) } else { None };
    let content = option.as_ref().unwrap();
    let layer = Layer { cache: Some(vec![y, x * y]), output: Ok(vec![x * x]) };
    let cached = layer.cached().expect("it is there")[1] * layer.cache.as_ref().unwrap()[0];
    let output = layer.output.as_ref().expect("it is there");
    option.as_ref().unwrap()[0] * content[1]
        + cached * output[0]
        + layer.output.as_ref().unwrap().iter().sum::<f64>()
}

#[test]
fn contents_are_looked_at_where_they_live() {
    check!(contents_of_locals(x, y) at [0.7, 1.3]);
}
