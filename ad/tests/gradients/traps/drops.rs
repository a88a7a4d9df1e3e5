//! Values that have an effect when they are dropped, at the end of their block.

use std::cell::{Cell, RefCell};

use ad::differentiable;

use crate::oracle::check;

thread_local! {
    static SCALE: Cell<f64> = const { Cell::new(1.0) };
}

/// Sets the scale, until it is dropped.
pub(super) struct Guard(f64);

impl Guard {
    pub(super) fn push(scale: f64) -> Self {
        Self(SCALE.replace(scale))
    }

    pub(super) fn get(&self) -> f64 {
        SCALE.get()
    }
}

impl Drop for Guard {
    fn drop(&mut self) {
        SCALE.set(self.0);
    }
}

pub(super) fn scale() -> f64 {
    SCALE.get()
}

#[differentiable]
fn in_a_block(x: f64, y: f64) -> f64 {
    let a = {
        let _guard = Guard::push(3.0);
        x * scale()
    };
    a * scale() * y
}

#[differentiable]
fn in_a_closure(x: f64, y: f64) -> f64 {
    let f = |t: f64| {
        let guard = Guard::push(2.0);
        t * guard.get()
    };
    f(x) * scale() * f(y) * scale()
}

#[differentiable]
fn in_the_arm_that_goes_on(x: f64, y: f64) -> f64 {
    let a = if x > 0.0 {
        let _guard = Guard::push(3.0);
        x * scale()
    } else {
        return y * scale();
    };
    a * scale() * y
}

#[differentiable]
fn in_loops(x: f64, y: f64) -> f64 {
    let mut s = 0.0;
    for i in 0..3 {
        let _guard = Guard::push(i as f64 + 1.0);
        {
            let (_inner, k) = (Guard::push(5.0), scale());
            s += x * k * scale();
        }
        s += y * scale() * s;
        if s > 1000.0 {
            break;
        }
    }
    s * scale()
}

#[differentiable]
fn in_adapters_and_labels(x: f64, y: f64) -> f64 {
    let scaled: Vec<f64> = [x, y]
        .iter()
        .map(|t| {
            let _guard = Guard::push(3.0);
            t * scale()
        })
        .collect();
    let mut z = scaled[0] * scale();
    {
        let _guard = Guard::push(7.0);
        z *= scale() * scaled[1];
    }
    'part: {
        let _guard = Guard::push(0.5);
        if x > 1.0 {
            break 'part;
        }
        z *= scale();
    }
    z * scale()
}

#[differentiable]
fn positive(x: f64) -> Option<f64> {
    if x > 0.0 { Some(x) } else { None }
}

#[differentiable]
fn left_early(x: f64, y: f64) -> Option<f64> {
    let a = {
        let _guard = Guard::push(3.0);
        positive(x)? * scale()
    };
    Some(a * y * scale())
}

#[differentiable]
fn by_question_mark(x: f64, y: f64) -> f64 {
    match left_early(x, y) {
        Some(z) => z * scale(),
        None => y,
    }
}

/// A type with a short name is no scalar.
struct G(Guard);

impl G {
    fn new(scale: f64) -> Self {
        Self(Guard::push(scale))
    }
}

#[differentiable]
fn of_a_short_name(x: f64, y: f64) -> f64 {
    let a = {
        let guard = G::new(3.0);
        x * guard.0.get()
    };
    let b = match G::new(2.0).0.get() {
        k if k > 2.5 => y,
        _ => y * scale(),
    };
    a * b * scale()
}

#[differentiable]
fn held_by_something(x: f64, y: f64) -> f64 {
    let a = {
        let _boxed = Box::new(Guard::push(3.0));
        x * scale()
    };
    let b = a * {
        let _chosen = if x > 0.0 { Guard::push(2.0) } else { Guard::push(5.0) };
        scale() * y
    };
    let c = b * {
        let made = || Some(Guard::push(7.0));
        let _unwrapped = made().unwrap();
        scale() * x
    };
    let outside = Guard::push(1.5);
    let d = c * {
        let (_moved, _) = (outside, 1);
        scale()
    };
    let e = {
        let mut late = None;
        if scale() > 0.0 {
            late = Some(Guard::push(0.5));
        }
        let Guard(before) = &Guard::push(9.0);
        d * scale() * *before * late.is_some() as usize as f64
    };
    e * scale()
}

/// Sets the scale back to one.
struct Leave;

impl Leave {
    const NEW: Leave = Leave;
}

impl Drop for Leave {
    fn drop(&mut self) {
        SCALE.set(1.0);
    }
}

#[differentiable]
fn that_are_not_called(x: f64, y: f64) -> f64 {
    let a = {
        SCALE.set(3.0);
        let _leave = Leave;
        x * scale()
    };
    let b = {
        SCALE.set(2.0);
        let _leave = (1, [Leave::NEW]);
        y * scale()
    };
    a * b * scale()
}

#[differentiable]
fn behind_references(x: f64, y: f64) -> f64 {
    let cell = RefCell::new(vec![0_usize, 1]);
    let values = [x, y, x * y];
    let a = {
        let kept = &*cell.borrow();
        values[kept[1]]
    };
    let b = {
        let kept = &cell.borrow()[1..];
        values[kept[0] + 1]
    };
    cell.borrow_mut().push(2);
    a * b * values[cell.borrow()[2]]
}

#[test]
fn guards_end_with_their_blocks() {
    check!(that_are_not_called(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(behind_references(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(of_a_short_name(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(held_by_something(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(in_a_block(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(in_a_closure(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(in_the_arm_that_goes_on(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(in_loops(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(in_adapters_and_labels(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(by_question_mark(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}
