//! A `Clone` that gives another value.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[derive(Debug, Differentiable)]
struct Buffer {
    values: Vec<f64>,
}

impl Clone for Buffer {
    fn clone(&self) -> Self {
        Self { values: vec![0.0; self.values.len()] }
    }
}

#[differentiable]
fn of_a_buffer(buffer: &Buffer) -> f64 {
    let copy = buffer.clone();
    copy.values[0] + buffer.values[1]
}

#[test]
#[cfg(debug_assertions)]
#[should_panic = "a clone differs from its original"]
fn a_clone_that_is_no_copy_is_found() {
    of_a_buffer::grad(&Buffer { values: vec![1.0, 2.0] });
}

#[test]
#[cfg(debug_assertions)]
#[should_panic = "a clone differs from its original"]
fn a_clone_that_is_no_copy_is_found_in_forward_mode() {
    let along = BufferTangent { values: vec![1.0, 0.0] };
    of_a_buffer::jvp(&Buffer { values: vec![1.0, 2.0] }, &along);
}

#[derive(Clone, Debug, Differentiable)]
struct Good {
    values: Vec<f64>,
    boxed: Option<Box<f64>>,
}

/// Nothing is known of it.
#[derive(Clone, Differentiable)]
struct Silent {
    values: Vec<f64>,
}

#[differentiable]
fn of_others(x: f64, y: f64) -> f64 {
    let good = Good { values: vec![x, f64::NAN, y], boxed: Some(Box::new(y)) };
    let mut copy = good.clone();
    copy.values[0] *= 2.0;
    let silent = Silent { values: copy.values.clone() };
    let again = silent.clone();
    copy.values[0] * good.values[2] * again.values[0]
}

#[test]
fn clones_that_are_copies_pass() {
    check!(of_others(x, y) at [1.3, 0.4], [-0.7, 1.1]);
}
