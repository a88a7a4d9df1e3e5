//! The pullback may keep a value, so the end of one that has a derivative has no effect.

use ad::{Differentiable, differentiable};

#[derive(Clone, Differentiable)]
struct Lent {
    value: f64,
}

impl Drop for Lent {
    fn drop(&mut self) {
        println!("given back");
    }
}

#[differentiable]
fn doubled(lent: &Lent) -> f64 {
    2.0 * lent.value
}

fn main() {
    doubled::grad(&Lent { value: 1.0 });
}
