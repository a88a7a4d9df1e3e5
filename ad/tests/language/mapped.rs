//! `map` of what is an array, an option or a result by its type alone.

use ad::{Differentiable, differentiable};
use glam::{DVec2, DVec3};

use crate::oracle::check;

#[derive(Clone, Copy, Differentiable)]
struct Color([f64; 3]);

#[differentiable]
impl Color {
    fn scaled(self, factor: f64) -> Color {
        Color(self.0.map(|channel| channel * factor))
    }

    fn powers(&self, factor: f64) -> [f64; 3] {
        self.0.map(|channel| (channel * factor).exp()).map(|channel| channel * channel)
    }
}

#[differentiable]
fn of_fields(x: f64, y: f64) -> f64 {
    let color = Color([x, y, x * y]).scaled(y);
    let powers = color.powers(x);
    color.0[0] * powers[1] + color.0[2] * powers[2]
}

#[differentiable]
fn pair(x: f64, y: f64) -> [f64; 2] {
    [x * x, x - y]
}

#[differentiable]
fn of_calls(x: f64, y: f64) -> f64 {
    let sines = pair(x, y).map(f64::sin);
    let [first, second] = pair(sines[0], y).map(|z| z * x).map(|z| z + y);
    first * second * sines[1]
}

#[differentiable]
fn of_items(x: f64, y: f64) -> f64 {
    let rows = [pair(x, y), pair(y, x)];
    let mut sum = 0.0;
    for row in rows {
        let row = row.map(|z| z * y);
        sum += row[0] * row[1];
    }
    for row in &rows {
        let row = row.map(|z| z * z);
        sum += row[0] - row[1] * x;
    }
    sum
}

#[differentiable]
fn of_rows(rows: &[[f64; 2]], x: f64) -> f64 {
    rows.iter().map(|row| row.map(|z| z * x)).map(|[a, b]| a * b).sum::<f64>()
        + rows[0].map(|z| z * z)[1]
}

#[differentiable]
fn through_rows(x: f64, y: f64) -> f64 {
    of_rows(&[pair(x, y), pair(y, x)], x * y)
}

#[differentiable]
fn behind(array: &[f64; 2], x: f64) -> f64 {
    let scaled = array.map(|z| z * x);
    scaled[0] * scaled[1]
}

#[differentiable]
fn of_references(x: f64, y: f64) -> f64 {
    behind(&pair(x, y), y)
}

#[differentiable]
fn in_each_other(x: f64, y: f64) -> f64 {
    let matrix = [pair(x, y), pair(y, x)];
    let [[a, b], [c, d]] = matrix.map(|row| row.map(|z| z * x));
    let (turned, _) = ([[b, a], [d, c]], x);
    let transposed = turned.map(|row| row.map(|z| z - y));
    a * d - b * c * transposed[0][1]
}

/// Closures run in order, once for each element.
#[differentiable]
fn with_changes(x: f64, y: f64) -> f64 {
    let (mut sum, mut count) = (0.0, 0);
    let sums = pair(x, y).map(|z| {
        sum += z * y;
        count += 1;
        sum * z
    });
    if count == 2 { sums[0] * sums[1] + sum } else { 0.0 }
}

#[derive(Clone, Differentiable)]
struct Mixed {
    lists: [Vec<f64>; 2],
    perhaps: Option<f64>,
    outcome: Result<f64, String>,
    options: [Option<f64>; 2],
    nothing: [f64; 0],
}

#[differentiable]
fn dot(list: Vec<f64>, factor: f64) -> f64 {
    list.iter().map(|z| z * factor).sum()
}

#[differentiable]
fn of_mixed(x: f64, y: f64) -> f64 {
    let mixed = Mixed {
        lists: [vec![x, y], vec![x * y]],
        perhaps: if x > y { Some(x) } else { None },
        outcome: if x > y { Ok(y) } else { Err("small".to_owned()) },
        options: [Some(x * x), None],
        nothing: [],
    };
    let sums = mixed.lists.map(|list| dot(list, y));
    let perhaps = mixed.perhaps.map(|z| z * y).unwrap_or(y);
    let outcome = mixed.outcome.map(|z| z * x).unwrap_or(x);
    let [full, empty] = mixed.options.map(|option| option.map(|z| z * y).unwrap_or(x * y));
    let nothing = mixed.nothing.map(|z| z * y);
    sums[0] * perhaps + sums[1] * outcome + full * empty + nothing.len() as f64 * x
}

/// What an option holds may move into a closure with what the closure captures.
#[differentiable]
fn moved(mixed: Mixed, list: Vec<f64>) -> f64 {
    mixed.perhaps.map(|z| dot(list, z)).unwrap_or(1.0)
}

#[differentiable]
fn through_moved(x: f64, y: f64) -> f64 {
    let perhaps = if x > y { Some(x) } else { None };
    let mixed = Mixed {
        lists: [vec![], vec![]],
        perhaps,
        outcome: Ok(y),
        options: [None, None],
        nothing: [],
    };
    moved(mixed, vec![x, y, y * y]) * y
}

#[differentiable]
fn generic<T: ad::Real, const N: usize>(wrapped: Wrapped<T, N>, factor: T) -> [T; N] {
    wrapped.0.map(|z| z * factor)
}

#[derive(Clone, Copy, Differentiable)]
struct Wrapped<T, const N: usize>([T; N]);

#[differentiable]
fn of_generic(x: f64, y: f64) -> f64 {
    let [a, b, c] = generic(Wrapped([x, y, x * y]), y);
    a * b + c
}

/// It is not `Clone`: what elements would have to be is not asked of contents.
#[derive(Differentiable)]
struct Node {
    value: f64,
    list: Vec<f64>,
}

#[differentiable]
fn node(x: f64, y: f64) -> Option<Node> {
    if x > y { Some(Node { value: x * x, list: vec![x, y] }) } else { None }
}

#[differentiable]
fn total(node: Node, factor: f64) -> f64 {
    dot(node.list, factor) + node.value
}

#[differentiable]
fn without_clones(x: f64, y: f64) -> f64 {
    let named = node(x, y);
    node(y, x).map(|node| node.value * y).unwrap_or(x) * named.map(|n| total(n, x)).unwrap_or(y)
}

#[differentiable]
fn middle(list: &[f64]) -> Option<&f64> {
    list.get(list.len() / 2)
}

/// What is mapped may be a reference.
#[differentiable]
fn of_lent(x: f64, y: f64) -> f64 {
    let list = [x, y, x * y];
    let (first, middle_one) = (list.first(), middle(&list));
    let named = first.map(|z| z * y).unwrap_or(y) * middle_one.map(|z| *z * x).unwrap_or(x);
    named + middle(&list[1..]).map(|z| *z * *z).unwrap_or(0.0)
}

#[derive(Clone, Copy, Differentiable)]
struct Table {
    #[constant]
    order: [usize; 2],
    weights: [f64; 2],
}

#[differentiable]
impl Table {
    fn weighted(&self, factor: f64) -> f64 {
        self.weights[0] * factor
    }
}

/// Closures look at variables of types of one's own.
#[differentiable]
fn with_captured(x: f64, y: f64) -> f64 {
    let table = Table { order: [1, 0], weights: [x, y * y] };
    let following = table.order.map(|i| (i + 1) % 2);
    let chosen = table.order.map(|i| table.weights[i] * x);
    let weighted = table.weights.map(|w| table.weighted(w) * y);
    chosen[0] * weighted[1] + chosen[following[0]] * weighted[0]
}

#[derive(Clone, Copy, Differentiable)]
struct Light {
    direction: DVec3,
    sizes: DVec2,
}

#[differentiable]
fn brightened(color: DVec3, exponent: f64) -> DVec3 {
    color.map(|channel| if channel > 0.5 { channel.powf(exponent) } else { channel * exponent })
}

#[differentiable]
fn of_vectors(x: f64, y: f64) -> f64 {
    let light = Light { direction: DVec3::new(x, y, x * y), sizes: DVec2::new(y, x) };
    let direction = light.direction.map(|z| z * y).normalize().map(f64::exp);
    let sizes = light.sizes.map(|z| z * z);
    let color = brightened(DVec3::new(x * x, y * y, 0.7), y);
    direction.dot(color) * sizes.x + (color * y).map(|z| z.sin()).x * sizes.y
}

#[test]
fn types_tell_what_is_mapped() {
    check!(of_fields(x, y) at [0.7, 0.4], [0.4, 0.7], [-0.3, 1.2]);
    check!(of_calls(x, y) at [0.7, 0.4], [0.4, 0.7], [-0.3, 1.2]);
    check!(of_items(x, y) at [0.7, 0.4], [0.4, 0.7], [-0.3, 1.2]);
    check!(through_rows(x, y) at [0.7, 0.4], [0.4, 0.7], [-0.3, 1.2]);
    check!(of_references(x, y) at [0.7, 0.4], [0.4, 0.7], [-0.3, 1.2]);
    check!(in_each_other(x, y) at [0.7, 0.4], [0.4, 0.7], [-0.3, 1.2]);
    check!(with_changes(x, y) at [0.7, 0.4], [0.4, 0.7], [-0.3, 1.2]);
    check!(of_mixed(x, y) at [0.7, 0.4], [0.4, 0.7], [-0.3, 1.2]);
    check!(through_moved(x, y) at [0.7, 0.4], [0.4, 0.7], [-0.3, 1.2]);
    check!(without_clones(x, y) at [0.7, 0.4], [0.4, 0.7], [-0.3, 1.2]);
    check!(of_lent(x, y) at [0.7, 0.4], [0.4, 0.7], [-0.3, 1.2]);
    check!(with_captured(x, y) at [0.7, 0.4], [0.4, 0.7], [-0.3, 1.2]);
    check!(of_vectors(x, y) at [0.7, 0.4], [0.4, 0.7], [-0.3, 1.2]);
    check!(of_generic(x, y) at [0.7, 0.4], [0.4, 0.7], [-0.3, 1.2]);
}
