//! Where along a link between two samples a ray leaves the outline of a primitive.

use super::geometry::{Edge, Geometry};
use crate::trace::adjacency::sides;
use crate::trace::layout::Kind;
use crate::transport::camera::Ray;

/// How close to a root the search for it ends, as a part of the link.
const TOLERANCE: f64 = 1e-13;

/// How near to 0 a number is at its root, in parts of those at the ends: else the sign changes without a root.
const NEAR_ZERO: f64 = 1e-6;

/// The most steps to a root; a few are taken.
const MOST_STEPS: usize = 80;

/// Where a ray leaves an outline on its way along a link: the part of the link, and the edge.
pub type Exit = (f64, Edge);

impl Geometry<'_> {
    /// Where `ray`, which goes through a primitive at `from`, first leaves its outline on the way to `to`,
    /// and by which edge; nothing if it never does.
    pub fn exit(
        &self,
        primitive: u32,
        [from, to]: [f64; 2],
        ray: impl Fn(f64) -> Ray<f64>,
    ) -> Option<Exit> {
        let margin = |edge: Edge, at: f64| self.margin(edge, ray(from + at * (to - from)));
        let layout = self.layout;
        let found = match layout.kind_of(primitive as usize) {
            (Kind::Triangle, index) => {
                let edges = sides(layout.triangles[index]).map(Edge::Segment);
                let (start, end) = (ray(from), ray(to));
                let ends = edges.map(|edge| [self.margin(edge, start), self.margin(edge, end)]);
                first_exit(ends, |edge, at| margin(edges[edge], at))
                    .map(|(at, edge)| (at, edges[edge]))
            }
            _ => {
                let edge = Edge::Silhouette(primitive);
                let (before, after) = (margin(edge, 0.0), margin(edge, 1.0));
                let at = || root(|at| margin(edge, at), before, after);
                (after < 0.0).then(at).flatten().map(|at| (at, edge))
            }
        };
        found.map(|(at, edge)| (from + at * (to - from), edge))
    }
}

/// The first of the roots of the numbers of the edges of a triangle, each given at both `ends` and by
/// `margin`, and its edge.
fn first_exit(ends: [[f64; 2]; 3], margin: impl Fn(usize, f64) -> f64) -> Option<(f64, usize)> {
    // All edges have the same sign where a ray goes through the triangle.
    let farther = |a: f64, b: f64| if b.abs() > a.abs() { b } else { a };
    let sign = ends.iter().fold(0.0, |largest, [start, _]| farther(largest, *start)).signum();
    let mut first: Option<(f64, usize)> = None;
    for (estimate, edge) in estimates(ends, sign) {
        let signed = |at: f64| sign * margin(edge, at);
        if estimate == f64::INFINITY || first.is_some_and(|(at, _)| signed(at) >= 0.0) {
            continue;
        }
        let [before, after] = ends[edge].map(|number| sign * number);
        let Some(at) = root(signed, before, after) else { continue };
        if first.is_none_or(|(nearest, _)| at < nearest) {
            first = Some((at, edge));
        }
    }
    first
}

/// Where the roots would be if the numbers were linear, the first of them first: most of those after it are not searched.
fn estimates(ends: [[f64; 2]; 3], sign: f64) -> [(f64, usize); 3] {
    let mut estimates = [0, 1, 2].map(|edge| {
        let [before, after] = ends[edge].map(|number: f64| sign * number);
        let at = if before <= 0.0 { 0.0 } else { before / (before - after) };
        (if after < 0.0 { at } else { f64::INFINITY }, edge)
    });
    estimates.sort_by(|a, b| a.0.total_cmp(&b.0));
    estimates
}

/// The root between 0 and 1 of a function with the value `low` at 0 and `high` < 0 at 1: regula falsi, improved as by
/// Dowell & Jarratt, "A Modified Regula Falsi Method" (Illinois), 1971. It is 0 if `low` is below 0 by rounding. Nothing
/// where the sign changes at a pole or a jump, as it may where a ray that mirrors have turned runs along a plane.
pub fn root(value: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> Option<f64> {
    if low <= 0.0 {
        return (low - high >= -low).then_some(0.0);
    }
    let zero = NEAR_ZERO * low.max(-high);
    let (mut left, mut right) = (0.0, 1.0);
    let mut last = 0;
    for step in 0..MOST_STEPS {
        let mut at = left + (right - left) * (low / (low - high));
        if step > MOST_STEPS / 2 || !at.is_finite() {
            at = 0.5 * (left + right);
        }
        let found = value(at);
        let side = if found > 0.0 { 1 } else { -1 };
        let step = if side > 0 { at - left } else { right - at };
        if found == 0.0 || (right - left).min(step) < TOLERANCE {
            return (found.abs() <= zero).then_some(at);
        }
        if side > 0 {
            (left, low) = (at, found);
            if last == side {
                high *= 0.5;
            }
        } else {
            (right, high) = (at, found);
            if last == side {
                low *= 0.5;
            }
        }
        last = side;
    }
    let at = 0.5 * (left + right);
    (value(at).abs() <= zero).then_some(at)
}
