//! Closures and what they capture.

use std::cell::Cell;

use ad::differentiable;

use crate::oracle::check;

/// Each call changes the variable that it captures.
#[differentiable]
fn captures_a_mutable(x: f64, y: f64) -> f64 {
    let mut total = x;
    let mut add = |t: f64| {
        total = total * y + t;
        total
    };
    let a = add(x);
    let b = add(a * y);
    a * b + total
}

#[differentiable]
fn changes_an_element(x: f64, y: f64) -> f64 {
    let mut values = [x, y, x * y];
    let mut bump = |i: usize, t: f64| values[i] *= t;
    for i in 0..3 {
        bump(i, y);
        bump(2 - i, x);
    }
    values[0] * values[1] + values[2]
}

/// A `move` closure keeps what the variable was when the closure was made, and changes its copy.
#[differentiable]
fn moved_mutable(x: f64, y: f64) -> f64 {
    let mut a = x * y;
    let mut counter = move |t: f64| {
        a += t;
        a * t
    };
    let first = counter(y);
    a = y * y;
    let second = counter(a);
    first * second + a
}

/// A captured name that means something else where the closure is called.
#[differentiable]
fn shadowed_capture(x: f64, y: f64) -> f64 {
    let a = x * x;
    let times_a = |t: f64| t * a;
    let a = times_a(y) + 1.0;
    let t = 3.0 * y;
    let b = {
        let a = t * a;
        times_a(a) + t
    };
    a * b
}

#[differentiable]
fn called_zero_and_many_times(x: f64, y: f64) -> f64 {
    let unused = |t: f64| t.ln() * x;
    let mut a = y;
    let f = |t: f64| t * x + y;
    for _ in 0..3 {
        a = f(f(a));
    }
    if a < -1e9 { unused(a) } else { a }
}

/// A closure that changes what another item's closure reads.
#[differentiable]
fn changes_in_a_chain(x: f64, y: f64) -> f64 {
    let mut running = x;
    let total: f64 = [x, y, 2.0 * y]
        .iter()
        .map(|t| {
            running = running * t + 0.5;
            running * y
        })
        .sum();
    total * running
}

/// What stands to the left of a call is evaluated before it.
#[differentiable]
fn counts_behind_another_call(x: f64, y: f64) -> f64 {
    let count = Cell::new(0_usize);
    let next = || {
        count.set(count.get() + 1);
        count.get()
    };
    let values = [x, y, x * y, 2.0];
    let a = values[count.get() * 2 + next()];
    let b = if count.get() + next() > 3 { y } else { x };
    let c = if count.get() == 2 && next() + count.get() == 6 { a } else { 1.0 };
    a * b * c + values[count.get() + 2 - next()]
}

#[test]
fn captures() {
    check!(counts_behind_another_call(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(captures_a_mutable(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(changes_an_element(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(moved_mutable(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(shadowed_capture(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(called_zero_and_many_times(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(changes_in_a_chain(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}
