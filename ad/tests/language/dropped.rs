//! `drop`, of what has a derivative and of what has none.

use std::cell::Cell;

use ad::differentiable;

use crate::oracle::check;

struct Guard<'a>(&'a Cell<u32>);

impl Drop for Guard<'_> {
    fn drop(&mut self) {
        self.0.set(self.0.get() + 1);
    }
}

#[differentiable]
fn dropping(x: f64, y: f64) -> f64 {
    let values = vec![x, y, x * y];
    let product = values[0] * values[2];
    drop(values);
    let boxed = Box::new(x * y);
    let square = *boxed * *boxed;
    if x > 0.0 {
        std::mem::drop(boxed);
    }
    product * square
}

#[differentiable]
fn guarded(x: f64, #[constant] count: &Cell<u32>) -> f64 {
    let guard = Guard(count);
    let square = x * x;
    drop(guard);
    square * count.get() as f64
}

#[test]
fn values_and_guards() {
    check!(dropping(x, y) at [0.7, 1.3], [-1.1, 0.4]);
    assert_eq!(guarded::value_and_grad(3.0, &Cell::new(0)), (9.0, (6.0, ())));
}
