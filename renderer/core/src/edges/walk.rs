//! Walks over meshes: from triangle to neighbour, as a camera ray moves along a link.
//!
//! Most neighbouring samples see the same surface. What lies between them is found without rays: the
//! numbers of edges are linear in the place, so each step is the first of two roots.

use super::geometry::{Edge, Geometry};
use crate::trace::adjacency::sides;
use crate::transport::camera::Ray;

/// The most triangles that a walk goes over.
const MOST_STEPS: usize = 64;

/// By how much a ray may leave a triangle before it has entered it, as a part of the link: rounding.
const BACKWARDS: f64 = 1e-9;

/// From one triangle to the next.
#[derive(Clone, Copy)]
pub struct Step {
    /// The part of the link.
    pub at: f64,
    pub edge: [u32; 2],
    /// The triangles before and after the edge.
    pub triangles: [u32; 2],
}

impl Geometry<'_> {
    /// Walks from the first triangle, which is met at the start of a link, to the second one, which is met
    /// at its end; returns whether the surface leads there. If not, the steps mean nothing.
    pub fn walk(&self, [first, last]: [u32; 2], way: [Ray<f64>; 2], steps: &mut Vec<Step>) -> bool {
        steps.clear();
        matches!(self.follow(first, None, way, |step| steps.push(step)), End::In(end) if end == last)
    }

    /// The triangles that a moving camera ray goes over, from an edge of the first one or from within, with where it
    /// leaves them as parts of the way; 1 at the end if the surface goes on so far.
    pub fn facets(
        &self,
        triangle: u32,
        edge: Option<[u32; 2]>,
        way: [Ray<f64>; 2],
    ) -> Vec<(u32, f64)> {
        let mut facets = Vec::new();
        let (mut last, entered) = (triangle, edge.map(|edge| (edge, 0.0)));
        let end = self.follow(triangle, entered, way, |Step { at, triangles, .. }| {
            facets.push((triangles[0], at));
            last = triangles[1];
        });
        match end {
            End::In(_) => facets.push((last, 1.0)),
            End::Border(at) => facets.push((last, at)),
            End::Lost => {}
        }
        facets
    }

    /// Follows a camera ray over a mesh, from a triangle that it has entered by an edge, or that it meets at the start.
    fn follow(
        &self,
        mut triangle: u32,
        mut entered: Option<([u32; 2], f64)>,
        way: [Ray<f64>; 2],
        mut each: impl FnMut(Step),
    ) -> End {
        for _ in 0..=MOST_STEPS {
            let corners = self.layout.triangles[triangle as usize];
            match self.side_of_exit(corners, entered, way) {
                Exit::Invalid => return End::Lost,
                Exit::None => return End::In(triangle),
                Exit::Side(side, at) => {
                    let next = self.adjacency.across(triangle, side);
                    // A triangle without area has no points to look at.
                    let Some(next) = next.filter(|&next| self.has_area(next as usize)) else {
                        return End::Border(at);
                    };
                    let edge = sides(corners)[side];
                    each(Step { at, edge, triangles: [triangle, next] });
                    (triangle, entered) = (next, Some((edge, at)));
                }
            }
        }
        End::Lost
    }

    /// Where a camera ray, which goes through a triangle at `from`, leaves it on the way to `to`, and by which
    /// edge; nothing if it never does.
    pub fn linear_exit(
        &self,
        triangle: usize,
        [from, to]: [f64; 2],
        ray: impl Fn(f64) -> Ray<f64>,
    ) -> Option<(f64, Edge)> {
        let corners = self.layout.triangles[triangle];
        let Exit::Side(side, at) = self.side_of_exit(corners, None, [from, to].map(ray)) else {
            return None;
        };
        Some((from + at * (to - from), Edge::Segment(sides(corners)[side])))
    }

    /// Where a ray leaves a triangle that it has entered by an edge, or that it meets at the start.
    fn side_of_exit(
        &self,
        corners: [u32; 3],
        entered: Option<([u32; 2], f64)>,
        [from, to]: [Ray<f64>; 2],
    ) -> Exit {
        let [a, b, c] = corners.map(|corner| self.vertex(corner) - from.origin);
        let volumes = [a.cross(b), b.cross(c), c.cross(a)];
        // Where a ray goes through a triangle, all its edges have this sign.
        let sign = volumes[0].dot(c).signum();
        let mut exit = Exit::None;
        for (side, (edge, volume)) in sides(corners).into_iter().zip(volumes).enumerate() {
            let before = sign * volume.dot(from.direction);
            let after = sign * volume.dot(to.direction);
            match entered {
                Some(([p, q], _)) if edge == [p, q] || edge == [q, p] => {
                    // A surface that turns back is behind the one that was left.
                    if after <= before {
                        return Exit::Invalid;
                    }
                    continue;
                }
                _ if after >= 0.0 => continue,
                _ => {}
            }
            let start = entered.map_or(0.0, |(_, at)| at);
            let at = match entered {
                None if before <= 0.0 => 0.0,
                _ => before / (before - after),
            };
            if at.is_nan() || at < start - BACKWARDS || before < 0.0 && entered.is_some() {
                return Exit::Invalid;
            }
            if !matches!(exit, Exit::Side(_, first) if first <= at) {
                exit = Exit::Side(side, at);
            }
        }
        exit
    }
}

/// How a way over a mesh ends.
enum End {
    /// In this triangle.
    In(u32),
    /// Where the mesh does, at this part of the way.
    Border(f64),
    /// Nowhere: it goes over too many triangles, or turns back.
    Lost,
}

/// How a ray leaves a triangle.
enum Exit {
    /// It does not.
    None,
    /// By this side, at this part of the link.
    Side(usize, f64),
    /// It was never within.
    Invalid,
}
