//! Arithmetic on a type parameter `S: Real`, which both modes write as arithmetic.

use std::ops::Mul;

use ad::rules::MulPullback;
use ad::{Real, differentiable};
use glam::DVec3;

use crate::oracle::{assert_close, assert_gradient, check_generic};

#[differentiable]
fn constants<S: Real>(x: S, y: S) -> S {
    let scaled = S::TWO * x - S::from_f64(0.25) * y;
    let shifted = S::ONE + scaled / S::PI - S::HALF * y / S::from_f64(-3.0);
    let far = S::from_f64(1e30) * (x - y) / S::from_f64(1e30);
    S::ZERO - shifted * scaled + far
}

#[differentiable]
fn assigned<S>(x: S, y: S) -> S
where
    S: Real<Mask = bool>,
{
    let mut sum = S::ZERO;
    let mut product = S::ONE;
    for i in 0..4 {
        sum += x * S::from_f64(i as f64);
        product *= y + sum;
        sum -= product / (x * x + S::ONE);
        product /= S::TWO;
    }
    sum + product
}

#[differentiable]
fn tables<Element: Real>(x: Element, y: Element) -> Element {
    let mut table = [[Element::ZERO; 3]; 2];
    for i in 0..2 {
        for j in 0..3 {
            table[i][j] = x * Element::from_f64((i + j) as f64) + y;
        }
    }
    let mut last = Element::ONE;
    for i in 0..3 {
        table[1][i] = table[0][2 - i] * table[1][i] - last;
        last = table[1][i].tanh();
    }
    table[1][0] * table[1][2] + last
}

/// A constant that is infinite in single precision, and one that vanishes there.
#[differentiable]
fn out_of_range<S: Real>(x: S) -> S {
    let huge = S::from_f64(1e100);
    let tiny = S::from_f64(1e-100);
    (x * huge).recip() + (x * tiny).min(S::ONE)
}

struct Line<S> {
    slope: S,
    offset: S,
}

/// The parameter of the block.
#[differentiable]
impl<S: Real> Line<S> {
    fn at(#[constant] &self, x: S) -> S {
        let mut y = S::ZERO;
        y += x * x;
        y * self.slope + self.offset
    }
}

/// A type parameter of its own that hides nothing: operands of other types stay what they are.
#[differentiable]
fn mixed<S: Real>(x: S, y: f64) -> S {
    let half = 0.5 * y * y;
    let mut sum = x;
    sum += S::from_f64(ad::stop_gradient(half)) * x;
    sum
}

/// An operator between the type parameter and a literal.
#[differentiable]
fn by_literals<S>(x: S) -> S
where
    S: Real + Mul<f64, Output = S> + MulPullback<f64>,
{
    let doubled = x * 2.0;
    let mut scaled = doubled * x;
    scaled = scaled * 0.5;
    scaled + doubled
}

#[test]
fn arithmetic_of_a_type_parameter() {
    check_generic!(constants(x, y) at [0.7, -1.3], [2.0, 0.1]);
    check_generic!(assigned(x, y) at [0.7, -1.3], [0.2, 1.1]);
    check_generic!(tables(x, y) at [0.7, -1.3], [0.2, 1.1]);
}

#[test]
fn constants_beyond_single_precision() {
    // 1 / (x * inf) is 0, whatever x is.
    assert_eq!(out_of_range::grad(0.5_f32), 0.0);
    assert_close("out of range", out_of_range::grad(0.5_f64) * 1e100, -3.0, 1e-12);
}

#[test]
fn the_type_parameter_of_a_block() {
    let line = Line { slope: 3.0, offset: 1.0 };
    let (value, pullback) = line.at_vjp(0.7);
    let (_, slope) = pullback(1.0);
    assert_eq!(value, line.at(0.7));
    assert_gradient("at", |x| line.at(x[0]), &[0.7], &[slope]);
}

#[test]
fn operands_of_other_types() {
    assert_eq!(by_literals::grad(3.0), 8.0);
    assert_eq!(by_literals::jvp(3.0, 1.0), (15.0, 8.0));
    assert_eq!(mixed::grad(2.0, 3.0), (5.5, 0.0));
    assert_eq!(mixed::jvp(2.0, 3.0, 1.0, 1.0), (11.0, 5.5));
}

#[differentiable]
fn widened(x: f32, y: f64) -> f64 {
    let x: f64 = x.into();
    let v: DVec3 = [x, y, x * y].into();
    let numbers: [f64; 3] = (v * x).into();
    let unit: String = "rad".into();
    numbers[0] * numbers[2] + numbers[1] * unit.len() as f64
}

#[differentiable]
fn result_widened(x: f32) -> f64 {
    (x * x).into()
}

#[test]
fn conversions_by_into() {
    let (x, y) = (1.25_f32, 0.75);
    let (value, (by_x, by_y)) = widened::value_and_grad(x, y);
    // x⁴y + 3xy
    let wide = f64::from(x);
    assert_eq!(value, widened(x, y));
    assert_close("by x", f64::from(by_x), 4.0 * wide.powi(3) * y + 3.0 * y, 1e-6);
    assert_close("by y", by_y, wide.powi(4) + 3.0 * wide, 1e-12);
    let (_, along) = widened::jvp(x, y, 1.0, 0.0);
    assert_close("along x", along, f64::from(by_x), 1e-6);
    assert_eq!(result_widened::grad(1.5), 3.0);
}
