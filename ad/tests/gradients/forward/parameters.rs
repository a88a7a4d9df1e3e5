//! The forms of parameters and results.

use ad::{Differentiable, Tangent, differentiable};

#[differentiable]
fn advance(x: &mut f64, v: &mut [f64], dt: f64) {
    for v in v.iter_mut() {
        *v -= *x * dt;
    }
    *x += v[0] * dt;
}

#[differentiable]
fn total(xs: &[f64], from: usize) -> f64 {
    let mut sum = 0.0;
    for x in &xs[from..] {
        sum += x * x;
    }
    sum
}

/// Splits in halves: every call looks at a part.
#[differentiable]
fn halved(xs: &[f64], scale: &f64) -> f64 {
    if xs.len() == 1 {
        return xs[0] * xs[0] * *scale;
    }
    let middle = xs.len() / 2;
    halved(&xs[..middle], scale) + halved(&xs[middle..], scale)
}

#[differentiable]
fn larger<'a>(a: &'a f64, b: &'a f64) -> &'a f64 {
    if a > b { a } else { b }
}

#[differentiable]
fn first(xs: &[f64]) -> &f64 {
    &xs[0]
}

#[differentiable]
fn of_references(a: f64, b: f64) -> f64 {
    let both = [a * b, b];
    let c = *larger(&both[0], &b) * *first(&both);
    c + a
}

#[derive(Clone, Debug, Differentiable)]
struct Table {
    scale: f64,
    #[constant]
    knots: Vec<f64>,
    #[constant]
    offset: f64,
    offsets: Vec<f64>,
}

#[differentiable]
fn interpolate(knots: &[f64], x: f64) -> f64 {
    let mut value = 0.0;
    for knot in knots {
        value += (x - knot) * (x - knot);
    }
    value
}

#[differentiable]
impl Table {
    fn at(&self, x: f64) -> f64 {
        let shifted = x + self.offset * self.offsets[1];
        self.scale * interpolate(&self.knots, shifted) + self.knots[0] * self.offsets.len() as f64
    }

    fn with_scale(self, scale: f64) -> Self {
        Self { scale: scale * self.scale, ..self }
    }

    fn widen(&mut self, by: f64) -> Option<f64> {
        self.offsets.push(by * self.scale);
        self.scale += by;
        self.offsets.last_of()
    }
}

trait LastOf {
    fn last_of(&self) -> Option<f64>;
    fn last_of_vjp(&self) -> (Option<f64>, impl FnOnce(f64) -> Vec<f64> + use<Self>);
    fn last_of_jvp(&self, tangent: &[f64]) -> (Option<f64>, f64);
}

impl LastOf for Vec<f64> {
    fn last_of(&self) -> Option<f64> {
        self.last().copied()
    }

    fn last_of_vjp(&self) -> (Option<f64>, impl FnOnce(f64) -> Vec<f64> + use<>) {
        let len = self.len();
        (self.last_of(), move |bar| {
            let mut bars = vec![0.0; len];
            if let Some(last) = bars.last_mut() {
                *last = bar;
            }
            bars
        })
    }

    fn last_of_jvp(&self, tangent: &[f64]) -> (Option<f64>, f64) {
        (self.last_of(), tangent.last().copied().unwrap_or(0.0))
    }
}

#[differentiable]
fn tables(x: f64, y: f64) -> f64 {
    let table = Table { scale: x, knots: vec![0.5, -1.5], offset: 2.0, offsets: vec![y, x * y] };
    let mut table = table.with_scale(y);
    let last = table.widen(x).unwrap_or(0.0);
    table.at(x * 0.5) * last + table.offset
}

const CONSTANTS: [f64; 3] = [0.5, 1.5, -2.0];

/// Constants of all kinds, passed on.
#[differentiable]
fn constants(x: f64, y: f64) -> f64 {
    let boxed = Box::new(vec![1.0, 2.0]);
    let list = vec![0.25, 4.0];
    let mut sum = total(&CONSTANTS, 1) * x + total(&list, 0) * y;
    sum += interpolate(&boxed, x);
    sum += 2.0_f64.powf(x) + *larger(&x, &1.25) * halved(&CONSTANTS, &y);
    let mut state = [1.0, 2.0];
    let mut start = 3.0;
    advance(&mut start, &mut state, x);
    sum * state[1]
}

#[differentiable]
trait Shape {
    fn size(&self, by: f64) -> f64;

    fn twice(&self, by: f64) -> f64 {
        self.size(by) + self.size(by * 2.0)
    }
}

#[differentiable]
impl Shape for f64 {
    fn size(&self, by: f64) -> f64 {
        *self * *self * by
    }
}

#[differentiable]
impl<T: Shape + Differentiable> Shape for Vec<T> {
    fn size(&self, by: f64) -> f64 {
        let mut sum = 0.0;
        for part in self.iter() {
            sum += part.twice(by);
        }
        sum
    }
}

#[differentiable]
fn nested(x: f64, y: f64) -> f64 {
    let shapes = vec![vec![x, x * y], vec![y]];
    shapes.size(x)
}

#[differentiable]
fn keep<T: Differentiable + Clone>(value: T, times: usize) -> Vec<T> {
    let mut kept = Vec::new();
    for _ in 0..times {
        kept.push(value.clone());
    }
    kept
}

#[differentiable]
fn generic(x: f64, y: f64) -> f64 {
    let kept = keep((x, [y, x * y]), 3);
    let (a, b) = kept[1];
    a * b[1] + kept[2].1[0]
}

#[test]
fn against_gradients() {
    crate::oracle::check!(of_references(x, y) at [0.7, 1.3], [2.1, -0.4]);
    crate::oracle::check!(tables(x, y) at [0.7, 1.3], [2.1, -0.4]);
    crate::oracle::check!(constants(x, y) at [0.7, 1.3], [2.1, -0.4]);
    crate::oracle::check!(nested(x, y) at [0.7, 1.3], [2.1, -0.4]);
    crate::oracle::check!(generic(x, y) at [0.7, 1.3], [2.1, -0.4]);
}

/// The tangent of a `&mut` parameter comes in and goes out.
#[test]
fn in_place() {
    let (mut x, mut v) = (1.0, [0.5, 0.25]);
    let (mut x_dot, mut v_dot) = (1.0, [0.0, 2.0]);
    advance::jvp(&mut x, &mut v, 0.5, &mut x_dot, &mut v_dot, 0.0);
    assert_eq!((x, v), (1.0, [0.0, -0.25]));
    assert_eq!((x_dot, v_dot), (0.75, [-0.5, 1.5]));
}

#[test]
#[should_panic(expected = "as many elements")]
fn a_tangent_of_another_length_is_refused() {
    total::jvp(&[1.0, 2.0, 3.0], 0, &[1.0], ());
}

/// The cost is that of the function, whatever is passed on.
#[test]
fn linear_time() {
    for n in [1, 10, 1000, 1 << 17] {
        let xs: Vec<f64> = (0..n).map(|i| i as f64 / n as f64).collect();
        let (value, tangent) = halved::jvp(&xs, &2.0, &xs, &0.0);
        assert!((tangent - 2.0 * value).abs() <= 1e-9 * value.max(1.0), "{n}");
    }
}

/// The tangent of an enum or a struct tells of its fields.
#[test]
fn structs() {
    let table = Table { scale: 2.0, knots: vec![1.0], offset: 0.0, offsets: vec![0.0, 0.0] };
    let mut dot: Tangent<Table> = table_tangent();
    dot.scale = 1.0;
    let (value, slope) = table.at_jvp(3.0, &dot, 0.0);
    assert_eq!((value, slope), (10.0, 4.0));
    let (wider, wider_dot) = table.with_scale_jvp(5.0, dot, 1.0);
    assert_eq!((wider.scale, wider_dot.scale), (10.0, 2.0 + 5.0));
}

fn table_tangent() -> Tangent<Table> {
    let mut tangent: Tangent<Table> = ad::Additive::zero();
    tangent.offsets = vec![0.0, 0.0];
    tangent
}
