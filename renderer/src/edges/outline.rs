//! Where along a link between two samples a ray leaves the outline of a primitive.

use super::geometry::{Edge, Geometry};
use crate::number::Plain;
use crate::trace::layout::Kind;
use crate::transport::camera::Ray;

/// How close to a root the search for it ends, as a part of the link.
const TOLERANCE: f64 = 1e-13;

/// The most steps to a root; a few are taken.
const MOST_STEPS: usize = 80;

/// The edges of a primitive.
fn outline<L: Plain>(geometry: &Geometry<'_, L>, primitive: u32) -> ([Edge; 3], usize) {
    let layout = geometry.integrator.layout;
    match layout.kind_of(primitive as usize) {
        (Kind::Triangle, index) => {
            let [a, b, c] = layout.triangles[index];
            ([[a, b], [b, c], [c, a]].map(Edge::Segment), 3)
        }
        _ => ([Edge::Silhouette(primitive); 3], 1),
    }
}

impl<L: Plain> Geometry<'_, L> {
    /// Where `ray`, which goes through a primitive at `from`, first leaves its outline on the way to `to`,
    /// and by which edge; nothing if it never does.
    pub fn exit(
        &self,
        primitive: u32,
        [from, to]: [f64; 2],
        is_linear: bool,
        ray: impl Fn(f64) -> Ray<f64>,
    ) -> Option<(f64, Edge)> {
        let (edges, count) = outline(self, primitive);
        let edges = &edges[..count];
        let (start, end) = (ray(from), ray(to));
        let at_start: Vec<f64> = edges.iter().map(|&edge| self.margin(edge, start)).collect();
        // All edges of a triangle have the same sign where a ray goes through it.
        let largest = at_start.iter().copied().max_by(|a, b| a.abs().total_cmp(&b.abs()))?;
        let sign = if count == 1 { 1.0 } else { largest.signum() };
        let mut first: Option<(f64, Edge)> = None;
        for (&edge, before) in edges.iter().zip(at_start) {
            let (before, after) = (sign * before, sign * self.margin(edge, end));
            if after >= 0.0 {
                continue;
            }
            let at = match () {
                () if before <= 0.0 => 0.0,
                () if is_linear => before / (before - after),
                () => {
                    let margin = |at: f64| sign * self.margin(edge, ray(from + at * (to - from)));
                    root(margin, before, after)
                }
            };
            if first.is_none_or(|(nearest, _)| at < nearest) {
                first = Some((at, edge));
            }
        }
        first.map(|(at, edge)| (from + at * (to - from), edge))
    }
}

/// The root between 0 and 1 of a function with the values `low` >= 0 there and `high` < 0 there: regula
/// falsi, improved as by Dowell & Jarratt, "A Modified Regula Falsi Method" (Illinois), 1971.
pub fn root(value: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let (mut left, mut right) = (0.0, 1.0);
    let mut last = 0;
    for step in 0..MOST_STEPS {
        let mut at = left + (right - left) * (low / (low - high));
        if step > MOST_STEPS / 2 || !at.is_finite() {
            at = 0.5 * (left + right);
        }
        let found = value(at);
        if found.abs() == 0.0 || right - left < TOLERANCE {
            return at;
        }
        let side = if found > 0.0 { 1 } else { -1 };
        let step = if side > 0 { at - left } else { right - at };
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
        if step < TOLERANCE {
            return at;
        }
    }
    0.5 * (left + right)
}
