//! Where along a link between two samples a ray leaves the outline of a primitive.

use super::geometry::{Edge, Geometry};
use crate::number::Plain;
use crate::trace::layout::Kind;
use crate::transport::camera::Ray;

/// How close to a root the search for it ends, as a part of the link.
const TOLERANCE: f64 = 1e-13;

/// The most steps to a root; a few are taken.
const MOST_STEPS: usize = 80;

/// Where a ray leaves an outline on its way along a link: the part of the link, and the edge.
pub type Exit = (f64, Edge);

impl<L: Plain> Geometry<'_, L> {
    /// Where `ray`, which goes through a primitive at `from`, first leaves its outline on the way to `to`,
    /// and by which edge; nothing if it never does.
    pub fn exit(
        &self,
        primitive: u32,
        [from, to]: [f64; 2],
        ray: impl Fn(f64) -> Ray<f64>,
    ) -> Option<Exit> {
        let (start, end) = (ray(from), ray(to));
        let root_of = |edge: Edge, sign: f64, before: f64, after: f64| {
            let margin = |at: f64| sign * self.margin(edge, ray(from + at * (to - from)));
            root(margin, before, after)
        };
        let layout = self.integrator.layout;
        let found = match layout.kind_of(primitive as usize) {
            (Kind::Triangle, index) => {
                let edges = segments(layout.triangles[index]);
                let margins = edges.map(|edge| {
                    let edge = Edge::Segment(edge);
                    [self.margin(edge, start), self.margin(edge, end)]
                });
                first_exit(margins, |edge, sign, before, after| {
                    root_of(Edge::Segment(edges[edge]), sign, before, after)
                })
                .map(|(at, edge)| (at, Edge::Segment(edges[edge])))
            }
            _ => {
                let edge = Edge::Silhouette(primitive);
                let (before, after) = (self.margin(edge, start), self.margin(edge, end));
                let at = || if before <= 0.0 { 0.0 } else { root_of(edge, 1.0, before, after) };
                (after < 0.0).then(|| (at(), edge))
            }
        };
        found.map(|(at, edge)| (from + at * (to - from), edge))
    }

    /// The same for a camera ray and a triangle: the numbers of its edges are linear in the place if the
    /// direction of the ray is.
    pub fn linear_exit(
        &self,
        triangle: usize,
        [from, to]: [f64; 2],
        ray: impl Fn(f64) -> Ray<f64>,
    ) -> Option<Exit> {
        let corners = self.integrator.layout.triangles[triangle];
        let (start, end) = (ray(from), ray(to));
        let [a, b, c] = corners.map(|corner| self.vertex(corner) - start.origin);
        let margins = [a.cross(b), b.cross(c), c.cross(a)]
            .map(|volume| [volume.dot(start.direction), volume.dot(end.direction)]);
        let (at, edge) = first_exit(margins, |_, _, before, after| before / (before - after))?;
        Some((from + at * (to - from), Edge::Segment(segments(corners)[edge])))
    }
}

/// The edges of a triangle.
fn segments([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

/// The first of the roots of the numbers of the edges of a triangle, each given at the start and at the
/// end, and its edge. `root` gives the root of an edge by its sign and its numbers with it.
fn first_exit(
    margins: [[f64; 2]; 3],
    root: impl Fn(usize, f64, f64, f64) -> f64,
) -> Option<(f64, usize)> {
    // All edges have the same sign where a ray goes through the triangle.
    let largest =
        margins.iter().fold(
            0.0_f64,
            |largest, [start, _]| {
                if start.abs() > largest.abs() { *start } else { largest }
            },
        );
    let sign = largest.signum();
    let mut first: Option<(f64, usize)> = None;
    for (edge, [before, after]) in margins.into_iter().enumerate() {
        let (before, after) = (sign * before, sign * after);
        if after >= 0.0 {
            continue;
        }
        let at = if before <= 0.0 { 0.0 } else { root(edge, sign, before, after) };
        if first.is_none_or(|(nearest, _)| at < nearest) {
            first = Some((at, edge));
        }
    }
    first
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
