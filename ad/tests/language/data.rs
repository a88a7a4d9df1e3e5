//! Structs, tuples, arrays, and the methods of structs.

use ad::{Differentiable, Mask, Real, Vec3, differentiable, stop_gradient};
use glam::DVec3;

use crate::oracle::{assert_close, check, check_generic};

#[derive(Clone, Copy, Differentiable)]
struct Ray<S: Real> {
    origin: Vec3<S>,
    direction: Vec3<S>,
    #[constant]
    weight: S,
}

#[differentiable]
impl<S: Real> Ray<S> {
    fn new(origin: Vec3<S>, direction: Vec3<S>) -> Self {
        let weight = S::TWO;
        Self { origin, direction, weight }
    }

    fn at(&self, t: S) -> Vec3<S> {
        self.origin + self.direction * t
    }

    fn moved(self, t: S) -> Self {
        let origin = self.at(t);
        Ray { origin, ..self }
    }

    fn turned(&self, by: S) -> Self {
        let mut turned = *self;
        turned.direction = turned.direction * by + self.origin;
        turned
    }
}

#[derive(Clone, Copy, Differentiable)]
struct Pair(f64, f64);

#[derive(Clone, Copy, Differentiable)]
struct Cell {
    pair: Pair,
    row: [Pair; 2],
    #[constant]
    id: usize,
}

#[differentiable]
fn rays(x: f64, y: f64) -> f64 {
    let ray = Ray::new(DVec3::new(x, y, 1.0), DVec3::new(0.3, x * y, y));
    let moved = ray.moved(x).turned(y);
    let p = moved.at(y);
    p.dot(ray.origin) * moved.weight + p.x
}

#[differentiable]
fn struct_update(x: f64, y: f64) -> f64 {
    let ray = Ray { origin: DVec3::splat(x), direction: DVec3::splat(y), weight: 3.0 };
    let fixed = Ray { origin: DVec3::ONE, ..ray };
    let started = Ray { origin: ray.direction * x, ..ray };
    let heavier = Ray { weight: stop_gradient(x), ..started };
    let Ray { origin, direction: towards, .. } = heavier;
    origin.dot(towards) * fixed.direction.y + fixed.origin.x * heavier.weight
}

#[differentiable]
fn tuple_structs(x: f64, y: f64) -> f64 {
    let pair = Pair(x * y, y);
    let Pair(a, b) = pair;
    let mut other = Pair(b, a * x);
    other.0 += pair.1;
    other.1 *= other.0;
    other.1 - Pair(x, 2.0).0
}

#[differentiable]
fn nested_places(x: f64, y: f64) -> f64 {
    let mut cells = [Cell { pair: Pair(x, y), row: [Pair(y, 1.0); 2], id: 1 }; 3];
    for i in 0..3 {
        cells[i].row[i % 2].1 += x * i as f64;
        cells[i].pair.0 *= cells[2 - i].row[0].0;
        cells[i].id += i;
        cells[(i + 1) % 3].row[1] = Pair(cells[i].pair.0, y);
    }
    let k = cells[1].id;
    let mut sum = 0.0;
    for i in 0..3 {
        sum += cells[i].pair.0 * cells[i].row[1].0 + cells[i].row[0].1;
    }
    sum * k as f64
}

#[differentiable]
fn arrays<S: Real>(x: S, y: S) -> S {
    let mut a = [x, y, x * y, S::ONE];
    let copy = a;
    for i in 1..4 {
        a[i] = a[i - 1] * copy[3 - i] + a[i];
    }
    a[0] = copy[2];
    let [first, second, ..] = a;
    let b = [first; 3];
    let grid = [[x, y], [second, a[3]]];
    b[2] * grid[1][0] + grid[0][1] * grid[1][1] + a[2]
}

#[differentiable]
fn tuples<S: Real>(x: S, y: S) -> (S, (S, [S; 2])) {
    let mut t = (x, (y, [x * y, y]));
    t.1.1[0] = t.0 * t.1.0;
    t.0 = t.1.1[0] + t.0;
    if x.cmpgt(y).all() {
        t.1 = (t.0, [x, y]);
    }
    t
}

#[differentiable]
fn tuples_in_use<S: Real>(x: S, y: S) -> S {
    let (a, (b, [c, d])) = tuples(x, y);
    let e = tuples(a, b).1.1[0];
    a * b + c * d * e
}

#[differentiable]
fn parameter_patterns((a, b): (f64, f64), [c, d]: [f64; 2], Pair(e, _): Pair, _: f64) -> f64 {
    a * b + c * d * e
}

#[differentiable]
fn constant_start(x: f64, y: f64) -> f64 {
    let (mut a, mut b) = (0.0, 1.0);
    let [mut c, d] = [2.0, 3.0];
    for _ in 0..3 {
        a += b * x;
        b *= y;
        c = a * d;
    }
    a * b + c
}

#[derive(Clone, Copy, Differentiable)]
struct Camera {
    #[constant]
    up: DVec3,
    #[constant]
    frame: Cell,
    #[constant]
    table: [(f64, f64); 3],
    zoom: f64,
}

#[differentiable]
fn parts_of_constants(x: f64, y: f64) -> f64 {
    let cell = Cell { pair: Pair(1.0, 2.0), row: [Pair(3.0, 4.0); 2], id: 7 };
    let mut camera = Camera { up: DVec3::X, frame: cell, table: [(2.0, 3.0); 3], zoom: x };
    let i = camera.frame.id % 3;
    let Camera { frame: Cell { pair: Pair(a, _), .. }, table: [(b, _), ..], .. } = camera;
    camera.zoom *= camera.up.x + camera.frame.row[1].1 * y;
    camera.zoom += camera.table[i].1 * a * b;
    camera.up.dot(DVec3::splat(y)) * camera.zoom
}

#[derive(Clone, Differentiable)]
struct Sample {
    #[constant]
    time: f64,
    value: f64,
    #[constant]
    count: usize,
    #[constant]
    names: Vec<String>,
    #[constant]
    axis: DVec3,
}

/// What `#[constant]` fields held goes on to others.
#[differentiable]
fn copies_of_constants(x: f64, y: f64) -> f64 {
    let count = 3;
    let axis = DVec3::X;
    let mut first = Sample { time: 2.0, value: x, count, names: vec!["a".to_owned()], axis };
    first.time += 1.0;
    first.count += 1;
    first.time = 3.0;
    let second = Sample { time: first.time, value: y * first.value, ..first.clone() };
    let Sample { time, value, count, names, axis } = second.clone();
    let third = Sample { time, value: value * time, count, names, axis };
    let fourth = Sample { axis: third.axis, value: third.value, ..third.clone() };
    first.time = fourth.time;
    first.axis = third.axis;
    first.count = third.count;
    let both = vec![fourth.clone(), first.clone()];
    let mut last = both[1].clone();
    last.time = both[0].time;
    last.time *= 2.0;
    last.value * first.time * last.axis.x * last.value + fourth.value * last.count as f64
}

#[test]
fn structs() {
    check!(copies_of_constants(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(parts_of_constants(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(rays(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(tuple_structs(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(nested_places(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}

/// The weight is a `#[constant]`, so the derivative is stopped before, and finite differences do not
/// agree in the parameter that it is made from.
#[test]
fn constant_fields_carry_nothing() {
    let (x, y) = (1.3, 0.7);
    let (value, (to_x, to_y)) = struct_update::value_and_grad(x, y);
    assert_eq!(value, struct_update(x, y));
    let without_weight = |x: f64, y: f64| 3.0 * y * x * y * y + 1.3;
    let expected = ad::check::derivative(|x| without_weight(x, y), x, 1e-3).value;
    assert_close("struct_update", to_x, expected, 1e-9);
    let expected = ad::check::derivative(|y| without_weight(x, y), y, 1e-3).value;
    assert_close("struct_update", to_y, expected, 1e-9);
}

#[test]
fn aggregates() {
    check_generic!(arrays(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check_generic!(tuples_in_use(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(constant_start(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}

#[test]
fn patterns_in_parameters() {
    let ((a, b), [c, d], pair, ignored) =
        parameter_patterns::grad((2.0, 3.0), [4.0, 5.0], Pair(6.0, 7.0), 8.0);
    assert_eq!([a, b, c, d, pair.0, pair.1, ignored], [3.0, 2.0, 30.0, 24.0, 20.0, 0.0, 0.0]);
}

#[derive(Clone, Differentiable)]
struct Table {
    rows: Vec<f64>,
    scale: f64,
    inner: Option<f64>,
    #[constant]
    name: String,
}

#[derive(Clone, Copy, Differentiable)]
struct Tolerances {
    absolute: f64,
    relative: Option<f64>,
}

#[differentiable]
impl Table {
    /// What is behind the reference cannot move: only the scale is copied.
    fn scaled(&self, by: f64) -> Table {
        let rows = self.rows.iter().map(|row| row * by).collect();
        Table { rows, inner: Some(by), name: self.name.clone(), ..*self }
    }
}

/// The rest of a struct that is not `Copy`: behind a reference, in a part, in a variable that changed.
#[differentiable]
fn rest_of_tables(x: f64, y: f64) -> f64 {
    let table = Table { rows: vec![x, y], scale: x * y, inner: None, name: "table".to_owned() };
    let mut tables = vec![table.scaled(y), table];
    tables[1].scale *= 3.0;
    let limits = Tolerances { absolute: x, relative: Some(y) };
    let limits = Tolerances { absolute: limits.absolute * x, ..limits };
    let third = Table { rows: vec![y * y], name: String::new(), ..tables[1] };
    let mut last = third.scaled(x);
    last.scale += limits.relative.unwrap_or(1.0) * limits.absolute;
    let last = Table { inner: Some(x), ..last };
    let sum: f64 = tables.iter().map(|t| t.scale * t.rows[0] + t.inner.unwrap_or(y)).sum();
    sum + last.rows[0] * last.scale
        + last.inner.unwrap_or_default()
        + third.inner.unwrap_or_default()
}

fn table_of(scale: f64) -> Table {
    Table { rows: vec![0.3, 1.7], scale, inner: Some(0.4), name: String::new() }
}

/// The rest is a constant, of which a part changes later.
#[differentiable]
fn constant_rests(x: f64, y: f64) -> f64 {
    let mut table = Table { scale: x * y, ..table_of(2.0) };
    let before = table.scaled(y).rows[1];
    table.rows[0] *= x;
    before * table.rows[0] + table.scale
}

#[test]
fn updates_of_what_is_not_copied() {
    check!(constant_rests(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(rest_of_tables(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}

#[derive(Clone, Debug, Differentiable)]
struct Market {
    spot: f64,
    rate: f64,
    names: Vec<f64>,
}

/// What is copied out of a place whose type is not `Copy`.
#[differentiable]
fn of_market(market: &Market) -> f64 {
    let Market { spot, rate, .. } = *market;
    spot * rate + market.names[0]
}

#[differentiable]
fn change_market(market: &mut Market) -> f64 {
    let Market { spot, mut rate, .. } = *market;
    market.spot = 2.0 * rate;
    rate *= spot;
    rate * market.spot
}

#[differentiable]
fn markets(x: f64, y: f64) -> f64 {
    let mut market = Market { spot: x, rate: y, names: vec![x * y, 2.0] };
    let all = vec![market.clone(), Market { spot: y, ..market.clone() }];
    let mut total = 1.0;
    for market in &all {
        let Market { spot, ref names, .. } = *market;
        total = total * spot * names[0] + of_market(market);
    }
    let Market { rate, .. } = all[1];
    let boxed = Box::new(market.clone());
    let Market { spot, .. } = *boxed;
    let mut pairs = [(x, market.clone()), (y, all[1].clone())];
    let (first, Market { spot: inner, .. }) = pairs[0];
    pairs[0].1.spot = y;
    let [(_, Market { names, .. }), _] = pairs;
    while market.spot < 3.0 {
        let Market { spot, ref names, .. } = market;
        total += spot * names[0];
        market.spot = spot + 1.0 + x * x;
    }
    total *= rate + change_market(&mut market) * market.spot * spot;
    total += first * inner * names[0];
    let Market { names, .. } = market;
    total * names[1] + market.rate
}

#[test]
fn parts_of_what_is_not_copied() {
    check!(markets(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}
