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

#[differentiable(vjp = softplus_vjp, jvp = softplus_jvp)]
use special::softplus;

fn softplus_vjp(x: f64) -> (f64, impl FnOnce(f64) -> f64) {
    (special::softplus(x), move |cotangent| cotangent / (1.0 + (-x).exp()))
}

fn softplus_jvp(x: f64, x_dot: f64) -> (f64, f64) {
    (special::softplus(x), x_dot / (1.0 + (-x).exp()))
}

#[differentiable(vjp = norm_vjp, jvp = norm_jvp)]
pub(crate) use special::norm as length;

pub(crate) fn norm_jvp(xs: &[f64], xs_dot: &[f64]) -> (f64, f64) {
    let norm = special::norm(xs);
    (norm, xs.iter().zip(xs_dot).map(|(x, x_dot)| x * x_dot / norm).sum())
}

pub(crate) fn norm_vjp(xs: &[f64]) -> (f64, impl FnOnce(f64) -> Vec<f64> + use<>) {
    let (norm, xs) = (special::norm(xs), xs.to_vec());
    (norm, move |cotangent| xs.iter().map(|x| cotangent * x / norm).collect())
}

/// A rule that reads as many cotangents as there are values, and leaves out zeros at the ends of its own.
#[differentiable(vjp = spread_vjp)]
fn spread(xs: &[f64], into: &mut Vec<f64>) -> Vec<f64> {
    into.fill(xs[0]);
    vec![xs[0] * xs[1]; xs.len()]
}

type Spread = (Vec<f64>, Vec<f64>);

fn spread_vjp(
    xs: &[f64],
    into: &mut Vec<f64>,
) -> (Vec<f64>, impl FnOnce(Vec<f64>, Vec<f64>) -> Spread + use<>) {
    let products = spread(xs, into);
    let (first, second, lengths) = (xs[0], xs[1], (xs.len(), into.len()));
    (products, move |bar, into_bar| {
        let by_products: f64 = (0..lengths.0).map(|i| bar[i]).sum();
        let by_into: f64 = (0..lengths.1).map(|i| into_bar[i]).sum();
        (vec![by_products * second + by_into, by_products * first], Vec::new())
    })
}

#[differentiable(reverse)]
fn spread_out(x: f64, y: f64) -> f64 {
    let mut into = vec![y, 1.0, 2.0, 3.0];
    let products = spread(&[x, y, 5.0], &mut into);
    products[1] * into[0] + x
}

#[test]
fn rules_know_the_sizes_of_lists() {
    assert_eq!(spread_out::grad(1.5, 0.5), (2.5, 2.25));
    let (_, pullback) = spread::vjp(&[1.0, 2.0, 3.0], &mut vec![1.0, 2.0]);
    assert_eq!(pullback(Vec::new(), Vec::new()), (vec![0.0; 3], vec![0.0; 2]));
}

#[differentiable]
impl Series {
    #[differentiable(vjp = Self::sum_rule, jvp = Self::sum_forward)]
    fn sum(&self, by: f64) -> f64 {
        self.x + self.y * by
    }

    #[differentiable(boxed, vjp = product_rule, jvp = product_forward)]
    fn product(&mut self, by: f64) {
        self.x *= by;
    }
}

impl Series {
    fn sum_rule(&self, by: f64) -> (f64, impl FnOnce(f64) -> (SeriesTangent, f64) + use<>) {
        let y = self.y;
        (self.sum(by), move |bar| (SeriesTangent { x: bar, y: by * bar }, y * bar))
    }

    fn sum_forward(&self, by: f64, self_dot: &SeriesTangent, by_dot: f64) -> (f64, f64) {
        (self.sum(by), self_dot.x + self_dot.y * by + self.y * by_dot)
    }
}

fn product_forward(
    series: &mut Series,
    by: f64,
    series_dot: &mut SeriesTangent,
    by_dot: f64,
) -> ((), ()) {
    series_dot.x = series_dot.x * by + series.x * by_dot;
    series.product(by);
    ((), ())
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

#[derive(Clone, Copy)]
struct Unknown {
    x: f64,
    n: usize,
}

impl Unknown {
    fn rounded(self) -> f64 {
        (self.x * 8.0).round() / 8.0 * self.n as f64
    }
}

/// What cannot be differentiated, wherever it stands.
#[differentiable]
fn not_differentiated(x: f64, y: f64) -> f64 {
    let mut sum = 0.0;
    let n = 3;
    for a in [x, y].iter() {
        let rounded = ad::no_diff(|| {
            let unknown = Unknown { x: *a, n };
            let mut total = unknown.rounded();
            while total > 10.0 {
                total /= 2.0;
            }
            println!("{} {}", total, sum);
            total
        });
        sum += rounded * a;
        if ad::no_diff(|| vec![x, y].len() == 2) {
            sum *= y;
        }
    }
    sum
}

#[test]
fn no_diff() {
    let (value, gradient) = not_differentiated::value_and_grad(1.3, 0.7);
    // 1.3 and 0.7 to eighths, times 3.
    let (a, b) = (1.25 * 3.0, 0.75 * 3.0);
    let (x, y) = (1.3, 0.7);
    assert_eq!(value, (a * x * y + b * y) * y);
    let by_y = 2.0 * a * x * y + 2.0 * b * y;
    assert!((gradient.0 - a * y * y).abs() < 1e-12 && (gradient.1 - by_y).abs() < 1e-12);
}

/// A tree of formulas.
#[derive(Clone, Differentiable)]
enum Formula {
    X,
    Number(f64),
    Add(Box<Formula>, Box<Formula>),
    Scale { by: f64, of: Box<Formula> },
    Sum(Vec<Formula>),
}

#[differentiable(boxed)]
fn evaluate(formula: &Formula, x: f64) -> f64 {
    match formula {
        Formula::X => x,
        Formula::Number(number) => *number,
        Formula::Add(a, b) => evaluate(a, x) + evaluate(b, x) * evaluate(a, x),
        Formula::Scale { by, of } => by * evaluate(of, x),
        Formula::Sum(terms) => {
            let mut sum = 0.0;
            for term in terms.iter() {
                sum += evaluate(term, x) * x;
            }
            sum
        }
    }
}

#[differentiable]
fn of_formula(x: f64, y: f64) -> f64 {
    let sum = Formula::Add(Box::new(Formula::X), Box::new(Formula::Number(y)));
    let scaled = Formula::Scale { by: x * y, of: Box::new(sum.clone()) };
    evaluate(&scaled, x) * evaluate(&Formula::Sum(vec![sum, Formula::X, scaled.clone()]), y)
}

#[derive(Clone, Copy, Differentiable)]
struct Point {
    at: [f64; 2],
}

#[differentiable]
impl Point {
    fn product(&self) -> f64 {
        self.at[0] * self.at[1]
    }

    fn shift(&mut self, by: f64) {
        self.at[0] += by;
    }
}

#[differentiable]
fn move_point(point: &mut Point, by: f64) {
    point.at[1] *= by;
}

#[differentiable]
fn boxed_points(mut point: Box<Point>, y: f64) -> f64 {
    let copy = *point;
    point.shift(y);
    point.at[1] += y;
    (*point).at[0] *= 2.0;
    move_point(&mut point, y);
    let other = Box::new(copy);
    point.product() * other.at[0] + copy.product() + (*other).at[1]
}

#[differentiable]
fn unboxed(point: Box<Point>) -> f64 {
    point.product()
}

#[differentiable]
fn in_boxes(x: f64, y: f64) -> f64 {
    let first = Box::new(Point { at: [x, y] });
    boxed_points(first, y) * unboxed(Box::new(Point { at: [y, x] }))
}

#[test]
fn recursive_data() {
    check!(of_formula(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(in_boxes(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    let formula = Formula::Scale { by: 3.0, of: Box::new(Formula::Number(5.0)) };
    let (by_formula, by_x) = evaluate::grad(&formula, 2.0);
    assert_eq!((by_formula.Scale.by, by_formula.Scale.of.Number.0, by_x), (5.0, 3.0, 0.0));
    assert_eq!(unboxed::grad(Box::new(Point { at: [2.0, 3.0] })).at, [3.0, 2.0]);
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
fn rules_are_checked() {
    ad::check::assert_rule(special::softplus, softplus_vjp, (0.7,));
    ad::check::assert_rule(cube_root, cube_root::vjp, (0.7,));
    let norm = |xs: Vec<f64>| special::norm(&xs);
    ad::check::assert_rule(norm, |xs: Vec<f64>| norm_vjp(&xs), (vec![1.0, 2.0, 0.5],));
    let pairs = |x: f64, y: [f64; 2], n: usize| vec![x * y[0], y[1].sin() * n as f64];
    let wrong = |x: f64, y: [f64; 2], n: usize| {
        let pullback = move |bar: Vec<f64>| {
            (bar[0] * y[0], [bar[0] * x, bar[1] * y[1].cos() * n as f64 + 0.5 * bar[0]], ())
        };
        (pairs(x, y, n), pullback)
    };
    let settings = ad::check::Settings::default();
    let worst = ad::check::worst(pairs, wrong, (0.3, [0.4, 0.5], 2), settings);
    let worst = worst.expect("there are components");
    assert_eq!((worst.result, worst.parameter), (0, 2));
    assert!((worst.error() - 0.5).abs() < 1e-9);
}

#[test]
#[should_panic(expected = "coordinate 0 of the result by coordinate 0 of the parameters")]
fn wrong_rules_are_found() {
    ad::check::assert_rule(|x: f64| x * x, |x: f64| (x * x, move |bar: f64| bar * x), (1.5,));
}

#[test]
fn rules_by_hand() {
    check!(by_hand(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    assert_eq!(cube_root::value_and_grad(8.0), (2.0, 1.0 / 12.0));
    let (value, pullback) = softplus::vjp(0.0);
    assert_eq!((value, pullback(2.0)), (2.0_f64.ln(), 1.0));
}

/// Of no interest to derivatives: it has none.
struct Table {
    rows: Vec<[f64; 2]>,
    scale: f64,
}

impl Table {
    fn at(&self, row: usize) -> f64 {
        self.rows[row][1] * self.scale
    }
}

#[differentiable]
fn looked_up(#[constant] table: &Table, x: f64, #[constant] (power, shift): (i32, f64)) -> f64 {
    let mut total = shift;
    for (i, row) in table.rows.iter().enumerate() {
        total += row[0] * x.powi(power) * table.at(i);
    }
    total * table.scale
}

#[differentiable]
impl Spring {
    fn stretched(&self, x: f64, #[constant] rest: f64) -> f64 {
        looked_up(&Table { rows: vec![[rest, 0.5]], scale: 2.0 }, x * self.stiffness, (2, rest))
    }
}

#[derive(Clone, Copy, Differentiable)]
struct Spring {
    stiffness: f64,
}

#[test]
fn constant_parameters() {
    let table = Table { rows: vec![[1.0, 2.0], [-0.5, 3.0]], scale: 0.7 };
    let primal = |p: &[f64]| looked_up(&table, p[0], (3, 0.4));
    let ((), by_x, ()) = looked_up::grad(&table, 1.3, (3, 0.4));
    crate::oracle::assert_gradient("looked_up", primal, &[1.3], &[by_x]);
    let primal = |p: &[f64]| Spring { stiffness: p[0] }.stretched(p[1], 0.3);
    let (by_self, by_x, ()) = Spring { stiffness: 2.0 }.stretched_grad(1.3, 0.3);
    let gradient = [by_self.stiffness, by_x];
    crate::oracle::assert_gradient("stretched", primal, &[2.0, 1.3], &gradient);
}

#[differentiable]
fn filled<const N: usize>(x: f64) -> [f64; N] {
    [x * x; N]
}

#[differentiable]
fn beside_default<T: Default + ad::Differentiable>(x: f64) -> (T, f64) {
    (T::default(), x.sin())
}

#[differentiable]
fn product(pair: [f64; 2]) -> f64 {
    pair[0] * pair[1]
}

#[differentiable]
fn told_by_results(x: f64, y: f64) -> f64 {
    let triple: [f64; 3] = filled(x);
    let (zero, sine): (f64, f64) = beside_default(y);
    product(filled(y)) * triple[2] + zero + sine
}

#[test]
fn results_tell_type_arguments() {
    check!(told_by_results(x, y) at [0.7, 0.4], [-0.4, 1.7]);
}
