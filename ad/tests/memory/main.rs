//! What gradients take from the heap.
//!
//! Bytes stand for work where work is linear: a cotangent made for each call or each access would
//! be as long as what it is the cotangent of.

mod arms;
mod moved;
mod nested;

use std::alloc::System;

use ad::{Differentiable, differentiable};
use stats_alloc::{INSTRUMENTED_SYSTEM, Region, StatsAlloc};

#[global_allocator]
static GLOBAL: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

/// The allocations that `f` makes, and their bytes.
fn taken<R>(f: impl FnOnce() -> R) -> (usize, usize) {
    let region = Region::new(GLOBAL);
    std::hint::black_box(f());
    let change = region.change();
    (change.allocations + change.reallocations, change.bytes_allocated)
}

#[derive(Clone, Differentiable)]
struct Layer {
    weights: Vec<f64>,
    biases: Vec<f64>,
}

#[differentiable]
fn neighbours(xs: &[f64], i: usize) -> f64 {
    xs[i] * xs[(i + 1) % xs.len()]
}

// A `Vec` is lent too, not slices alone.
#[allow(clippy::ptr_arg)]
#[differentiable]
fn cell(layer: &Layer, xs: &Vec<f64>, i: usize) -> f64 {
    (layer.weights[i] * xs[i] + layer.biases[i]).tanh()
}

#[differentiable]
impl Layer {
    fn weight(&self, i: usize) -> f64 {
        self.weights[i]
    }

    fn cell(&self, xs: &[f64], i: usize) -> f64 {
        (self.weight(i) * xs[i] + self.biases[i]).tanh()
    }

    fn relax(&self, at: &mut f64, i: usize) {
        *at = 0.5 * (*at + self.weights[i]);
    }

    fn set(&mut self, i: usize, weight: f64) {
        self.weights[i] = weight;
    }

    fn relax_all(&mut self) -> f64 {
        let mut sum = 0.0;
        for i in 0..self.weights.len() {
            let weight = self.weight(i) * 0.5;
            self.set(i, weight);
            sum += self.weight(i);
        }
        sum
    }
}

#[differentiable]
fn relax(at: &mut f64, xs: &[f64], i: usize) -> f64 {
    *at = 0.5 * (*at + xs[i]);
    *at * xs[i]
}

/// Elements, and calls with slices, with `Vec`s, with structs of `Vec`s, beside a `&mut`.
#[differentiable]
fn chain(xs: Vec<f64>, layer: &Layer) -> f64 {
    let mut sum = 0.0;
    let mut at = 0.0;
    for i in 0..xs.len() {
        sum += neighbours(&xs, i) * xs[i];
        sum += cell(layer, &xs, i);
        sum += relax(&mut at, &xs, i);
    }
    sum
}

/// The same of methods, on what may change, and by way of another method.
#[differentiable]
fn methods(xs: &[f64], layer: &Layer) -> f64 {
    let mut own = layer.clone();
    let mut sum = 0.0;
    let mut at = 0.0;
    for i in 0..xs.len() {
        sum += layer.cell(xs, i) * own.weight(i);
        layer.relax(&mut at, i);
        own.set(i, at * sum);
    }
    sum
}

/// What is behind a `&mut`, passed on by its name: as `&mut`, or as `&`.
#[differentiable]
fn passed_on(xs: &mut [f64], by: &[f64]) -> f64 {
    let mut sum = 0.0;
    for i in 0..xs.len() {
        sum += neighbours(xs, i) + scale(xs, by, i);
    }
    let mut own = by.to_vec();
    let name = &mut own;
    for i in 0..name.len() {
        sum += neighbours(name, i);
    }
    sum
}

#[differentiable]
fn scale(xs: &mut [f64], by: &[f64], i: usize) -> f64 {
    xs[i] *= by[i];
    xs[i]
}

#[differentiable]
fn behind(xs: &[f64], layer: &Layer) -> f64 {
    let (mut xs, mut layer) = (xs.to_vec(), layer.clone());
    let by = layer.biases.clone();
    passed_on(&mut xs, &by) + layer.relax_all()
}

/// A recursion along a slice.
#[differentiable]
fn from(xs: &[f64], i: usize) -> f64 {
    if i == xs.len() { 0.0 } else { xs[i] * xs[i] + from(xs, i + 1) }
}

fn layer(n: usize) -> Layer {
    Layer { weights: vec![0.5; n], biases: vec![0.25; n] }
}

/// The bytes for each of n elements, at n = 10, 1,000 and `largest`.
fn per_element(largest: usize, f: impl Fn(usize)) -> [f64; 3] {
    [10, 1000, largest].map(|n| taken(|| f(n)).1 as f64 / n as f64)
}

fn assert_linear(name: &str, [few, some, many]: [f64; 3]) {
    // A vector that grows takes at most three times its last length; what a gradient takes but for
    // its elements counts for little.
    assert!(some < few + 100.0, "{name}: {few} bytes an element of 10, {some} of 1,000");
    assert!(many < 3.0 * some, "{name}: {some} bytes an element of 1,000, {many} of many");
}

#[differentiable]
fn blur(image: &[[f64; 4]; 4], kernel: &[f64; 9]) -> f64 {
    let mut sum = 0.0;
    for y in 0..2 {
        for x in 0..2 {
            let mut value = 0.0;
            for k in 0..9 {
                value += image[y + k / 3][x + k % 3] * kernel[k];
            }
            sum += value.tanh();
        }
    }
    sum
}

#[differentiable]
fn newton(a: f64) -> f64 {
    let mut x = a;
    for _ in 0..20 {
        x = 0.5 * (x + a / x);
    }
    x
}

#[differentiable]
fn table(x: f64, rows: usize, columns: usize) -> f64 {
    let mut sum = x;
    for _ in 0..rows {
        for _ in 0..columns {
            sum = (sum * x).sin();
        }
    }
    sum
}

#[differentiable]
fn every_other(xs: &[f64]) -> f64 {
    let mut product = 1.0;
    for i in (0..xs.len()).rev().skip(3).step_by(2).take(1000) {
        product = (product + xs[i]).sin();
    }
    for pair in xs.chunks_exact(2) {
        product = (product * pair[0] + pair[1]).sin();
    }
    for triple in xs.windows(3) {
        product = (product * triple[0] + triple[2]).sin();
    }
    for x in xs.iter().skip(1) {
        product = (product * x).sin();
    }
    product
}

/// One test: the counts are those of the whole process. Frames of unoptimised code need room.
#[test]
fn heap() {
    std::thread::Builder::new().stack_size(64 << 20).spawn(counts).unwrap().join().unwrap();
}

fn counts() {
    let gradients = |n: usize| {
        chain::grad(vec![0.125; n], &layer(n));
    };
    assert_linear("calls in a loop", per_element(100_000, gradients));
    assert_linear(
        "calls of methods in a loop",
        per_element(100_000, |n| {
            methods::grad(&vec![0.125; n], &layer(n));
        }),
    );
    assert_linear(
        "calls with what is behind a `&mut`",
        per_element(10_000, |n| {
            behind::grad(&vec![0.125; n], &layer(n));
        }),
    );
    arms::arms_that_are_not_taken_take_no_room();
    for (name, gradient) in nested::ALL {
        let gradient = |n| {
            gradient(&vec![0.5; n]);
        };
        assert_linear(name, per_element(10_000, gradient));
    }
    for (name, derivative, by_gradient) in moved::ALL {
        let input = |n| -> (Vec<f64>, Vec<f64>) {
            (0..n).map(|i| ((i as f64).cos() * 0.5, (i as f64).sin())).unzip()
        };
        assert_linear(
            name,
            per_element(10_000, |n| {
                let (xs, along) = input(n);
                derivative(&xs, &along);
            }),
        );
        let (xs, along) = input(10);
        let ((value, dot), (expected, product)) =
            (derivative(&xs, &along), by_gradient(&xs, &along));
        assert!(value == expected && (dot - product).abs() < 1e-12 * product.abs(), "{name}");
    }
    // Each call has a place on the stack.
    assert_linear(
        "recursion",
        per_element(3000, |n| {
            from::grad(&vec![0.5; n], 0);
        }),
    );

    assert_eq!(taken(|| newton::grad(2.0)).0, 0, "one short loop");
    assert_eq!(taken(|| blur::grad(&[[0.5; 4]; 4], &[0.125; 9])).0, 0, "short loops in loops");
    let allocations = taken(|| table::grad(0.5, 100, 100)).0;
    assert_eq!(allocations, 2, "loops in loops: one tape for each");
    let (few, many) = ([0.5; 100], [0.5; 10_000]);
    let [few, many] = [&few[..], &many].map(|xs| taken(|| every_other::grad(xs)).0);
    assert_eq!(few, many, "tapes of loops over slices have room for all iterations");
}
