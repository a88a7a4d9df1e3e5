//! Methods called `into` of types that have one of their own.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[derive(Clone, Copy, Differentiable)]
struct Angle(f64);

#[differentiable]
#[allow(clippy::should_implement_trait, clippy::wrong_self_convention)]
impl Angle {
    fn into(self) -> f64 {
        self.0.sin()
    }
}

struct Code;

#[allow(clippy::should_implement_trait, clippy::wrong_self_convention)]
impl Code {
    fn into(self) -> f64 {
        3.0
    }
}

impl From<Code> for f64 {
    fn from(_: Code) -> f64 {
        2.0
    }
}

#[differentiable]
fn of_a_code(_x: f64) -> f64 {
    Code.into()
}

#[differentiable]
fn converted(x: f64, y: f64) -> f64 {
    let angle: f64 = Angle(x).into();
    let weight: f64 = Code.into();
    let again: f64 = { Angle(y * x).into() };
    angle * weight * y + again * of_a_code(x)
}

#[test]
fn a_method_of_the_type_comes_first() {
    check!(converted(x, y) at [0.7, 1.3], [-1.1, 0.4]);
    assert_eq!(of_a_code::value_and_grad(1.0), (3.0, 0.0));
}
