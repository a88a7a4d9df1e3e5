//! Traits, recursion, rules written by hand.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[differentiable]
fn power(x: f64, n: usize) -> f64 {
    if n == 0 { 1.0 } else { x * power(x, n - 1) }
}

/// Simpson's rule, on halves as long as they differ from the whole.
#[differentiable]
fn integral(a: f64, b: f64, depth: usize) -> f64 {
    let middle = 0.5 * (a + b);
    let whole = simpson(a, b);
    let halves = simpson(a, middle) + simpson(middle, b);
    if depth == 0 || (halves - whole).abs() < 1e-6 {
        return halves;
    }
    integral(a, middle, depth - 1) + integral(middle, b, depth - 1)
}

#[differentiable]
fn simpson(a: f64, b: f64) -> f64 {
    let middle = 0.5 * (a + b);
    (b - a) / 6.0 * (bump(a) + 4.0 * bump(middle) + bump(b))
}

#[differentiable]
fn bump(x: f64) -> f64 {
    (-x * x).exp() + 0.3 * (3.0 * x).sin()
}

#[differentiable]
fn is_even(x: f64, n: usize) -> f64 {
    if n == 0 { x } else { is_odd(x * x, n - 1) + x }
}

#[differentiable(boxed)]
fn is_odd(x: f64, n: usize) -> f64 {
    if n == 0 { 1.0 } else { is_even(x.sin(), n - 1) * x }
}

#[differentiable]
fn in_place(xs: &mut [f64], by: f64) -> f64 {
    let n = xs.len();
    if n == 1 {
        xs[0] *= by;
        return by;
    }
    let left = in_place(&mut xs[..n / 2], by);
    xs[n / 2] += xs[0];
    left * in_place(&mut xs[n / 2..], left)
}

#[differentiable]
fn recursive(x: f64, y: f64) -> f64 {
    let mut xs = [x, y, x * y, 1.0, x];
    let scale = in_place(&mut xs, y);
    power(x, 5) + is_even(y, 4) * power(y, 0) + xs[1] * xs[4] * xs[2] + scale
}

#[derive(Clone, Copy, Differentiable)]
struct Series {
    x: f64,
    y: f64,
}

#[differentiable]
impl Series {
    fn term(&self, n: usize) -> f64 {
        if n == 0 { self.y } else { self.x * self.term(n - 1) + Self::constant(self.y, n) }
    }

    fn constant(y: f64, n: usize) -> f64 {
        if n < 2 { y } else { Self::constant(y * 0.5, n - 1) }
    }
}

#[differentiable]
fn methods(x: f64, y: f64) -> f64 {
    Series { x, y }.term(4)
}

#[differentiable]
trait Shape {
    const SIDES: usize;

    fn area(&self) -> f64;

    fn scaled(self, by: f64) -> Self;

    fn grow(&mut self, by: f64);

    fn with_side(side: f64) -> Self
    where
        Self: Sized;

    /// Provided, of required ones.
    fn doubled(&self, by: f64) -> f64 {
        self.area() * by * Self::SIDES as f64
    }
}

#[derive(Clone, Copy, Differentiable)]
struct Square {
    side: f64,
}

#[differentiable]
impl Shape for Square {
    const SIDES: usize = 4;

    fn area(&self) -> f64 {
        self.side * self.side
    }

    fn scaled(self, by: f64) -> Self {
        Square { side: self.side * by }
    }

    fn grow(&mut self, by: f64) {
        self.side *= by;
    }

    fn with_side(side: f64) -> Self {
        Self { side }
    }
}

#[derive(Clone, Copy, Differentiable)]
struct Slab<const N: usize> {
    sides: [f64; N],
}

#[differentiable]
impl<const N: usize> Shape for Slab<N> {
    const SIDES: usize = N;

    fn area(&self) -> f64 {
        self.sides.iter().product()
    }

    fn scaled(self, by: f64) -> Self {
        let mut scaled = self;
        for i in 0..N {
            scaled.sides[i] *= by;
        }
        scaled
    }

    fn grow(&mut self, by: f64) {
        for side in self.sides.iter_mut() {
            *side += by;
        }
    }

    fn with_side(side: f64) -> Self {
        Self { sides: [side; N] }
    }

    fn doubled(&self, by: f64) -> f64 {
        self.area() + by
    }
}

#[differentiable]
fn total<T>(shape: T, by: f64) -> f64
where
    T: Shape + Differentiable + Copy,
{
    let mut grown = shape.scaled(by);
    grown.grow(by);
    grown.area() * shape.doubled(by) + T::with_side(by).area()
}

#[differentiable]
fn traits(x: f64, y: f64) -> f64 {
    total(Square { side: x }, y) + total::<Slab<2>>(Slab { sides: [x, y] }, x)
}

/// As fast as it can be: no derivative could be written of its insides.
#[differentiable(vjp = cube_root_vjp)]
fn cube_root(x: f64) -> f64 {
    f64::from_bits(x.cbrt().to_bits())
}

fn cube_root_vjp(x: f64) -> (f64, impl FnOnce(f64) -> f64) {
    let root = cube_root(x);
    (root, move |cotangent| cotangent / (3.0 * root * root))
}

/// A crate that knows nothing of derivatives.
mod special {
    pub fn softplus(x: f64) -> f64 {
        x.exp().ln_1p()
    }

    pub fn norm(xs: &[f64]) -> f64 {
        xs.iter().map(|x| x * x).sum::<f64>().sqrt()
    }
}

#[differentiable(vjp = softplus_vjp)]
use special::softplus;

fn softplus_vjp(x: f64) -> (f64, impl FnOnce(f64) -> f64) {
    (special::softplus(x), move |cotangent| cotangent / (1.0 + (-x).exp()))
}

#[differentiable(vjp = norm_vjp)]
pub(crate) use special::norm as length;

pub(crate) fn norm_vjp(xs: &[f64]) -> (f64, impl FnOnce(f64) -> Vec<f64> + use<>) {
    let (norm, xs) = (special::norm(xs), xs.to_vec());
    (norm, move |cotangent| xs.iter().map(|x| cotangent * x / norm).collect())
}

#[differentiable]
impl Series {
    #[differentiable(vjp = Self::sum_rule)]
    fn sum(&self, by: f64) -> f64 {
        self.x + self.y * by
    }

    #[differentiable(boxed, vjp = product_rule)]
    fn product(&mut self, by: f64) {
        self.x *= by;
    }
}

impl Series {
    fn sum_rule(&self, by: f64) -> (f64, impl FnOnce(f64) -> (SeriesTangent, f64) + use<>) {
        let y = self.y;
        (self.sum(by), move |bar| (SeriesTangent { x: bar, y: by * bar }, y * bar))
    }
}

fn product_rule(
    series: &mut Series,
    by: f64,
) -> ((), impl FnOnce((), SeriesTangent) -> (SeriesTangent, f64) + use<>) {
    let before = series.x;
    series.product(by);
    ((), move |(), bar| (SeriesTangent { x: bar.x * by, y: bar.y }, before * bar.x))
}

#[differentiable]
fn by_hand(x: f64, y: f64) -> f64 {
    let mut series = Series { x, y };
    series.product(y);
    let sum = series.sum(x) * softplus(x * y) + length(&[x, y, series.x]);
    sum * cube_root(y * y + x)
}

#[test]
fn recursion() {
    check!(recursive(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(methods(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    let (by_a, by_b, ()) = integral::grad(0.1, 1.2, 12);
    assert!((by_a + bump(0.1)).abs() < 1e-5 && (by_b - bump(1.2)).abs() < 1e-5);
}

#[test]
fn trait_methods() {
    check!(traits(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    let square = Square { side: 3.0 };
    let (area, by_square) = square.area_value_and_grad();
    assert_eq!((area, by_square.side), (9.0, 6.0));
    assert_eq!(square.doubled_grad(2.0).1, 36.0);
}

#[test]
fn rules_by_hand() {
    check!(by_hand(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    assert_eq!(cube_root::value_and_grad(8.0), (2.0, 1.0 / 12.0));
    let (value, pullback) = softplus::vjp(0.0);
    assert_eq!((value, pullback(2.0)), (2.0_f64.ln(), 1.0));
}
