//! Enums with data, options, results, and the patterns that take them apart.

use std::marker::PhantomData;

use ad::{Differentiable, Mask, Real, differentiable};

use crate::oracle::{check, check_generic};

#[derive(Clone, Copy, Differentiable)]
enum Shape {
    Point,
    Disc(f64),
    Box { width: f64, height: f64 },
    Ring(f64, [f64; 2], #[constant] usize),
}

#[differentiable]
impl Shape {
    fn area(self) -> f64 {
        match self {
            Self::Point => 0.0,
            Self::Disc(radius) => radius * radius * 3.0,
            Self::Box { width, height: h } => width * h,
            Self::Ring(outer, [inner, _], n) => (outer * outer - inner * inner) * n as f64,
        }
    }

    fn scaled(&self, by: f64) -> Self {
        match *self {
            Shape::Point => Shape::Point,
            Shape::Disc(r) if r > 1.0 => Shape::Disc(r * by),
            Shape::Disc(r) => Shape::Box { width: r, height: by },
            Shape::Box { width, height } => Shape::Ring(width * by, [height, by], 2),
            Shape::Ring(outer, rest, count) => Shape::Ring(outer, [rest[1], rest[0] * by], count),
        }
    }

    fn grow(&mut self, by: f64) {
        let grown = self.scaled(by);
        if let Shape::Ring(a, b, _) = grown {
            *self = Shape::Box { width: a, height: b[0] };
        } else {
            *self = grown;
        }
    }
}

/// Without a `*` where Rust needs none.
#[differentiable]
impl Shape {
    fn perimeter(&self, other: &f64) -> f64 {
        let doubled = match self {
            Self::Point => return -other,
            Self::Disc(radius) => radius * 6.0,
            Self::Box { width, height } => width + 2.0 * height - other,
            Self::Ring(outer, [inner, _], _) => outer * inner + -outer,
        };
        let mut sum = 2.0 * doubled;
        sum += other;
        let &Self::Disc(radius) = self else { return sum };
        match (self, &Self::Disc(sum)) {
            (Self::Disc(a), Self::Disc(b)) => a * b * radius,
            _ => sum,
        }
    }
}

#[differentiable]
fn perimeters(x: f64, y: f64) -> f64 {
    let sum = Shape::Disc(x).perimeter(&y) + Shape::Box { width: x, height: y }.perimeter(&x);
    sum * Shape::Ring(x, [y, x], 1).perimeter(&y) + Shape::Point.perimeter(&x)
}

#[differentiable]
fn shapes(x: f64, y: f64) -> f64 {
    let mut shape = if x > 0.0 { Shape::Disc(x) } else { Shape::Box { width: x, height: y } };
    let mut sum = 0.0;
    for i in 0..4 {
        sum += shape.area() * y;
        shape = shape.scaled(y + i as f64);
    }
    shape.grow(x);
    shape.grow(y);
    sum + shape.area() + Shape::Point.scaled(x).area()
}

#[differentiable]
fn alternatives(x: f64, y: f64) -> f64 {
    let shapes = [Shape::Disc(x), Shape::Box { width: y, height: x }, Shape::Point];
    let mut sum = 0.0;
    for i in 0..3 {
        sum += match shapes[i] {
            Shape::Disc(size) | Shape::Box { width: size, .. } if size > 0.5 => size * size * x,
            whole @ (Shape::Disc(_) | Shape::Box { height: _, .. }) => whole.area(),
            _ => y,
        };
        let (Shape::Disc(a) | Shape::Ring(a, ..) | Shape::Box { height: a, .. }) = shapes[i] else {
            return sum * y;
        };
        sum *= a;
        if let Shape::Disc(b) | Shape::Ring(b, ..) = shapes[i] {
            sum += b * y;
        }
    }
    sum
}

#[differentiable]
fn chains(x: f64, y: f64) -> f64 {
    let mut sum = x;
    if let Some(a) = root(x)
        && let Some(mut b) = root(a - 0.5)
        && a > 0.1
        && b < 10.0
    {
        b *= a;
        sum += a * b;
    } else if x < 0.0
        && let Some(c) = root(y)
    {
        sum *= c;
    }
    if y > 1.0
        && let Some(a @ 0.0..2.0) = root(y)
    {
        return sum * a;
    }
    sum + y
}

#[differentiable]
fn root(x: f64) -> Option<f64> {
    if x < 0.0 { None } else { Some(x.sqrt()) }
}

#[derive(Clone, Copy, Debug, PartialEq, Differentiable)]
enum Failure {
    Negative,
    Large,
}

#[derive(Debug, PartialEq)]
struct Report(Failure);

impl From<Failure> for Report {
    fn from(failure: Failure) -> Self {
        Self(failure)
    }
}

#[derive(Differentiable)]
#[constant]
struct Note(#[allow(dead_code)] String);

impl From<Failure> for Note {
    fn from(failure: Failure) -> Self {
        Self(format!("{failure:?}"))
    }
}

#[differentiable]
fn checked(x: f64) -> Result<f64, Failure> {
    if x < 0.0 {
        return Err(Failure::Negative);
    }
    match x {
        0.0..100.0 => Ok(x.sqrt()),
        _ => Err(Failure::Large),
    }
}

#[differentiable]
fn sum_of_roots(x: f64, y: f64) -> Result<f64, Note> {
    let product = checked(x)? * checked(y)?;
    let mut sum = product;
    for i in 0..3 {
        sum += checked(sum * y - 0.5 * i as f64)?;
    }
    Ok(sum * x)
}

#[differentiable]
fn recovered(x: f64, y: f64) -> f64 {
    let a = match checked(x - y) {
        Ok(root) => root * x,
        Err(Failure::Negative) => x * y,
        Err(_) => y,
    };
    let Ok(b) = sum_of_roots(x, y) else { return a * y };
    a * b
}

#[differentiable]
fn either(x: f64, y: f64) -> f64 {
    let outcome: Result<f64, [f64; 2]> = if x > 0.0 { Ok(x * y) } else { Err([y, x * x]) };
    match outcome {
        Ok(value) => value * value,
        Err([a, b]) => a * b,
    }
}

#[differentiable]
fn tuples(x: f64, y: f64) -> f64 {
    match (root(x), root(y)) {
        (Some(a), Some(b)) => a * b,
        (Some(a), None) | (None, Some(a)) => a,
        (None, None) => x * y,
    }
}

#[differentiable]
fn tail_patterns(x: f64, y: f64) -> f64 {
    let pair @ (a, b) = (x * y, y);
    let ref c = a;
    let n = 3;
    let k = match n {
        small @ 0..=2 => small,
        large @ 3.. => large * 2,
        _ => 0,
    };
    pair.0 * b * *c * k as f64
}

#[derive(Clone, Copy, Differentiable)]
struct Pair<T, U, K> {
    first: T,
    second: U,
    kind: PhantomData<K>,
}

#[derive(Clone, Copy, Differentiable)]
enum Either<T, U> {
    Left(T),
    Right { value: U },
}

struct Kind;

#[differentiable]
fn swapped<T: Differentiable, U: Differentiable>(pair: Pair<T, U, Kind>) -> Pair<U, T, Kind> {
    Pair { first: pair.second, second: pair.first, kind: PhantomData }
}

#[differentiable]
fn generics<S: Real>(x: S, y: S) -> S {
    let pair = swapped(Pair { first: x, second: [y, x * y], kind: PhantomData });
    let either =
        if x.cmpgt(y).all() { Either::Left(pair.first) } else { Either::Right { value: pair } };
    match either {
        Either::Left([a, b]) => a * b,
        Either::Right { value } => value.second * value.first[0],
    }
}

#[derive(Clone, Differentiable)]
enum Tree {
    Leaf(f64),
    Node { weights: Vec<f64>, bias: f64 },
    Empty,
}

#[differentiable]
fn tree(tree: Tree, x: f64) -> f64 {
    match tree {
        Tree::Leaf(value) => value * x,
        Tree::Node { weights, bias } => weights[1] * x + bias,
        Tree::Empty => 1.0,
    }
}

#[derive(Clone, Copy, PartialEq, Differentiable)]
enum Mode {
    Fast,
    Slow,
}

#[differentiable]
fn modes(mode: Mode, x: f64) -> f64 {
    let factor = match mode {
        Mode::Fast => 2.0,
        Mode::Slow => 1.0,
    };
    if mode == Mode::Slow { x * x } else { x * factor }
}

/// Its variants have the names of associated types.
#[derive(Clone, Copy, Differentiable)]
enum Named {
    Shape(f64),
    Tangent(f64),
}

#[differentiable]
fn named(x: f64, y: f64) -> f64 {
    let [a, b] = [Named::Shape(x * y), Named::Tangent(y)];
    let mut sum = 0.0;
    for one in [a, b] {
        sum += match one {
            Named::Shape(x) => x * x,
            Named::Tangent(y) => y.sin() * x,
        };
    }
    sum
}

/// More arms than there are variants in the largest enum of saved values.
#[differentiable]
fn many_arms(x: f64, n: usize) -> f64 {
    match n {
        0 => x,
        1 => x * x,
        2 => x + 1.0,
        3 => x.sin(),
        4 => x.cos(),
        5 => x.exp(),
        6 => x * 6.0,
        7 => x * x * x,
        8 => x - 8.0,
        9 => 9.0 / x,
        10 => x / 10.0,
        11 => x.sqrt(),
        12 => x.ln(),
        13 => x.tan(),
        14 => x.sin() * x,
        _ => 1.0,
    }
}

#[test]
fn enums() {
    check!(named(x, y) at [0.7, 1.3], [-0.4, 0.8]);
    check!(shapes(x, y) at [1.3, 0.7], [0.4, 2.1], [-0.4, 2.1]);
    check!(perimeters(x, y) at [1.3, 0.7], [0.4, 2.1], [-0.4, 2.1]);
    check!(alternatives(x, y) at [1.3, 0.7], [0.4, 2.1], [-0.4, 2.1]);
    check!(modes_by_number(x, n) at [1.3, 0.0], [1.3, 1.0]);
    check_generic!(generics(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    for n in 0..16 {
        let gradient = many_arms::grad(1.3, n).0;
        let slope = ad::check::derivative(|x| many_arms(x, n), 1.3, 1e-3);
        assert!((gradient - slope.value).abs() < 1e-7, "arm {n}");
    }
}

#[differentiable]
fn modes_by_number(x: f64, n: f64) -> f64 {
    let mode = if n > 0.5 { Mode::Fast } else { Mode::Slow };
    modes(mode, x) + n
}

#[test]
fn conditions() {
    check!(chains(x, y) at [1.3, 0.7], [0.4, 2.1], [-0.4, 2.1], [0.2, 0.3], [-0.2, 9.0]);
    check!(tuples(x, y) at [1.3, 0.7], [-0.4, 2.1], [0.4, -2.1], [-0.4, -2.1]);
    check!(tail_patterns(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}

#[test]
fn results() {
    check!(recovered(x, y) at [1.3, 0.7], [0.3, 0.7], [-0.4, 2.1], [400.0, 1.5]);
    check!(either(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    let (value, pullback) = checked::vjp(4.0);
    assert_eq!((value, pullback((1.0, ()))), (Ok(2.0), 0.25));
    let (value, pullback) = checked::vjp(-4.0);
    assert_eq!((value, pullback((1.0, ()))), (Err(Failure::Negative), 0.0));
    assert_eq!(Report::from(Failure::Large), Report(Failure::Large));
}

#[test]
fn tangents_of_enums_hold_those_of_all_variants() {
    let (by_shape, by_factor) = scaled_area::grad(Shape::Box { width: 2.0, height: 3.0 }, 4.0);
    assert_eq!((by_shape.Box.width, by_shape.Box.height, by_factor), (12.0, 8.0, 6.0));
    assert_eq!((by_shape.Disc.0, by_shape.Ring.1), (0.0, [0.0; 2]));

    let (by_tree, _) = tree::grad(Tree::Node { weights: vec![1.0, 2.0, 3.0], bias: 0.5 }, 4.0);
    assert_eq!((by_tree.Node.weights, by_tree.Node.bias), (vec![0.0, 4.0, 0.0], 1.0));
    assert_eq!(tree::grad(Tree::Leaf(3.0), 4.0).0.Leaf.0, 4.0);
    assert_eq!(tree::grad(Tree::Empty, 4.0).1, 0.0);
}

#[differentiable]
fn scaled_area(shape: Shape, factor: f64) -> f64 {
    shape.area() * factor
}
