//! Variants without the name of their enum, and structs that look like them.

use ad::{Differentiable, differentiable};

use self::Shape::*;
use crate::oracle::check;

#[derive(Clone, Copy, Differentiable)]
enum Shape {
    Disc(f64),
    Rect { width: f64, height: f64 },
    Ring(f64, f64),
    Empty,
}

#[derive(Clone, Copy, Differentiable)]
struct Point(f64, f64);

#[derive(Clone, Copy, Differentiable)]
struct Extent {
    lo: f64,
    hi: f64,
}

#[differentiable]
fn area(shape: &Shape) -> f64 {
    match shape {
        Disc(r) => 3.0 * r * r,
        Rect { width, height } => width * height,
        Ring(outer, inner) => 3.0 * (outer * outer - inner * inner),
        Empty => 0.0,
    }
}

#[differentiable]
fn grown(shape: Shape, by: f64) -> Shape {
    match shape {
        Disc(r) => Ring(r + by, r),
        Rect { width, .. } => Rect { width: width * by, height: by },
        Ring(outer, _) => Disc(outer * by),
        empty @ Empty => empty,
    }
}

#[differentiable]
fn one_of_them(shape: Shape, y: f64) -> f64 {
    let Disc(r) = shape else { return y * y };
    let mut sum = r * y;
    if let Disc(r) = shape
        && r > 0.5
    {
        sum += r * r;
    }
    let mut shape = shape;
    while let Disc(r) = shape {
        shape = if r < 0.1 { Empty } else { Disc(r * 0.5 - 0.1) };
        sum *= r;
    }
    sum
}

#[differentiable]
fn pairs(a: Shape, b: Shape) -> f64 {
    match (a, &b) {
        (Disc(r) | Ring(r, _), Disc(s)) => r * s,
        (Rect { width: w, .. }, Rect { height: h, .. }) => w * h * h,
        (Disc(r), Empty) => r,
        (Empty | Disc(_), _) => 1.0,
        (a, b) => area(&a) * area(b),
    }
}

#[differentiable]
fn structs(x: f64, y: f64) -> f64 {
    let Point(a, b) = Point(x * y, y);
    let Extent { lo, .. } = Extent { lo: a, hi: b };
    let nearer = match Point(a, lo) {
        Point(x, y) if x > y => x,
        Point(x, y) => x * y,
    };
    nearer * b
}

#[differentiable]
fn imported_within(x: f64, y: f64) -> f64 {
    use self::Shape::{Disc, Ring};
    let shape = if x > y { Disc(x * y) } else { Ring(y, x) };
    area(&shape) + area(&Disc(y))
}

#[differentiable]
fn shapes(x: f64, y: f64) -> f64 {
    let all =
        [Shape::Disc(x), Shape::Rect { width: x, height: y }, Shape::Ring(x * y, y), Shape::Empty];
    let mut sum = structs(x, y) + imported_within(x, y) * imported_within(y, x);
    for (i, &a) in all.iter().enumerate() {
        let b = grown(a, y);
        sum += area(&b) * (i + 1) as f64 + one_of_them(b, x) + one_of_them(a, y);
        for &c in &all {
            sum *= 1.0 + 0.01 * pairs(a, c);
        }
    }
    sum
}

/// What is left out at the end of patterns of items.
#[differentiable]
fn items(x: f64, y: f64) -> f64 {
    let points = [(x, y, 1.0), (y, x * y, 2.0)];
    let mut sum = 0.0;
    for &(a, ..) in &points {
        sum += a * a;
    }
    for (a, b, ..) in points.iter() {
        sum += a * b;
    }
    let extents = [Extent { lo: x, hi: y }; 2];
    sum * points.iter().map(|(a, ..)| a * x).sum::<f64>()
        + extents.iter().map(|Extent { hi, .. }| hi * y).sum::<f64>()
        + [[x, y, x], [y, y, x]].iter().map(|[a, b, ..]| a * b).sum::<f64>()
}

#[test]
fn variants_by_their_name_alone() {
    check!(shapes(x, y) at [1.3, 0.7], [0.47, 0.9]);
    check!(items(x, y) at [1.3, 0.7]);
}

mod declared {
    use super::*;

    #[derive(Clone, Copy, Debug, Differentiable)]
    enum E {
        Lin(f64),
        Quad { a: f64 },
        Pair(f64, f64),
    }
    use self::E::{Lin, Pair, Quad};
    #[derive(Clone, Copy, Debug, Differentiable)]
    struct W(f64);
    type V = W;
    #[differentiable]
    fn g(x: f64) -> E {
        if x > 50.0 { Quad { a: x } } else { Lin(x * x) }
    }
    #[differentiable]
    fn h(x: f64) -> Option<E> {
        if x > 1.0 {
            return Some(Quad { a: x });
        }
        match x > 0.0 {
            true => Some(Pair(x, 2.0)),
            false => None,
        }
    }
    #[differentiable]
    pub fn by_their_types(x: f64, y: f64) -> f64 {
        let e: E = if x > 9.0 { Lin(x) } else { Pair(x, y) };
        let s = match e {
            E::Pair(a, b) => a * b,
            _ => 0.0,
        };
        let t = match g(x) {
            E::Lin(a) => a * y,
            E::Quad { a } => a,
            E::Pair(a, _) => a,
        };
        let u = match h(y) {
            Some(E::Quad { a }) => a * x,
            Some(E::Pair(a, b)) => a * a * b,
            _ => y,
        };
        s * t + u
    }

    #[differentiable]
    fn wrapped(x: f64) -> V {
        W(x * x)
    }
    #[differentiable]
    pub fn structs(x: f64, y: f64) -> f64 {
        let w: W = W(x * y);
        wrapped(x).0 * w.0 + Some(W(y)).map_or(0.0, |w| w.0 * w.0)
    }
}

/// `Self` and the name of the struct are one constructor.
#[derive(Clone, Copy, Differentiable)]
struct Weighted {
    value: f64,
    #[constant]
    weight: u8,
}

#[differentiable]
impl Weighted {
    fn total(self) -> f64 {
        match self {
            Self { weight: 0, .. } => 0.0,
            Self { value, weight: 1 } => value * value,
            Weighted { value, weight } => value * f64::from(weight),
        }
    }
}

#[differentiable]
fn totals(x: f64, y: f64) -> f64 {
    let [a, b, c] = [x, y, x * y];
    Weighted { value: a, weight: 1 }.total() * Weighted { value: b, weight: 3 }.total()
        + Weighted { value: c, weight: 0 }.total()
}

#[test]
fn the_struct_itself_beside_its_name() {
    check!(totals(x, y) at [1.3, 0.4], [-0.7, 1.1]);
}

#[test]
fn variants_are_told_by_what_is_declared() {
    use declared::{by_their_types, structs};

    check!(by_their_types(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, 1.9]);
    check!(structs(x, y) at [1.3, 0.4], [-0.7, 1.1]);
}

#[differentiable]
fn made_side_by_side(x: f64, y: f64) -> f64 {
    let shapes = [Disc(x), Ring(x * y, y), Empty];
    let mut sum = 0.0;
    for shape in &shapes {
        sum = sum * y + area(shape);
    }
    let either = if x > y { Rect { width: x, height: y } } else { Disc(x * y) };
    let more = vec![Disc(y), if x > 0.0 { Empty } else { Disc(x * x) }];
    let points = [Point(x, y), Point(y, x * y)];
    sum + area(&either) * area(&more[0]) + area(&more[1]) + points[0].0 * points[1].1
}

#[test]
fn several_constructors_of_one_type() {
    check!(made_side_by_side(x, y) at [0.7, 1.3], [1.2, 0.4], [-1.2, 0.4]);
}
