use std::cell::{Cell, OnceCell, RefCell};
use std::rc::Rc;
use std::sync::Mutex;
use std::sync::mpsc::Sender;

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

#[differentiable]
fn by_a_guard(x: f64, #[constant] cells: &[RefCell<Vec<f64>>; 2]) -> f64 {
    no_diff(|| cells[1].borrow_mut()[0] += x);
    if { cells[0].borrow_mut().push(x); true } { x } else { 0.0 }
}

#[differentiable]
fn by_a_lock(x: f64, #[constant] cell: &Mutex<Vec<f64>>) -> f64 {
    if { cell.lock().unwrap().push(x); true } { x } else { 0.0 }
}

#[differentiable]
fn by_a_channel(x: f64, #[constant] sender: &Sender<f64>) -> f64 {
    if sender.send(x).is_ok() { x } else { 0.0 }
}

#[differentiable]
fn in_a_predicate(xs: &[f64], #[constant] cell: &Cell<f64>) -> f64 {
    let any = xs.iter().any(|x| { cell.set(*x); true });
    let mut sorted = xs.to_vec();
    sorted.sort_by(|a, b| { cell.set(*a); a.total_cmp(b) });
    if any { sorted[0] } else { 0.0 }
}

// Without forward mode nothing asks for the tangent of what nothing flows back to.
#[differentiable(reverse)]
fn in_a_statement(x: f64, #[constant] cell: &Cell<f64>) -> f64 {
    cell.set(x);
    let n: usize = { cell.set(x); 2 };
    cell.get() * n as f64
}

#[differentiable(reverse)]
fn by_a_guard_in_a_statement(x: f64, #[constant] cell: &RefCell<Vec<f64>>) -> f64 {
    cell.borrow_mut().push(x);
    cell.borrow()[0]
}

#[differentiable(reverse)]
fn by_a_function_in_a_statement(x: f64, #[constant] cell: &Cell<f64>) -> f64 {
    put(cell, x);
    cell.get()
}

// The number of an element is none that has a derivative.
#[differentiable]
fn counts(xs: &[f64], #[constant] cell: &Cell<usize>) -> f64 {
    let any = xs.iter().enumerate().any(|(i, x)| { cell.set(i); *x > 0.0 });
    if any { xs[cell.get()] } else { 0.0 }
}

fn main() {}
