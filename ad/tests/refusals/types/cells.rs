use std::cell::{Cell, OnceCell, RefCell};
use std::rc::Rc;

use ad::{differentiable, no_diff};

thread_local! {
    static LAST: Cell<f64> = const { Cell::new(0.0) };
}

#[differentiable]
fn in_a_condition(x: f64, #[constant] cell: &Cell<f64>) -> f64 {
    if cell.replace(x * x) >= 0.0 { cell.get() * x } else { x }
}

#[differentiable]
fn in_an_assertion(x: f64, #[constant] once: &OnceCell<f64>) -> f64 {
    assert!(once.set(x).is_ok());
    x
}

#[differentiable]
fn without_derivative(x: f64, #[constant] cell: &Cell<f64>) -> f64 {
    no_diff(|| cell.set(x));
    x
}

fn put(cell: &Cell<f64>, x: f64) -> bool {
    cell.set(x);
    true
}

#[differentiable]
fn by_a_function(x: f64, #[constant] cell: &Cell<f64>) -> f64 {
    let ok: bool = put(cell, x);
    if ok { x } else { cell.get() }
}

#[differentiable]
fn behind_pointers(x: f64, #[constant] cell: &Rc<RefCell<f64>>) -> f64 {
    if cell.replace(x) > 0.0 && LAST.replace(x) > 0.0 { x } else { 2.0 * x }
}

fn main() {}
