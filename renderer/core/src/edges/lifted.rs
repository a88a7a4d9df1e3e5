//! Jumps of what smooth mirrors show, between their triangles.
//!
//! Where a mirrored ray would enter its triangle it is [lifted](crate::transport::smooth::next_ray_outward) off that one.
//! So its direction jumps from one triangle to the next, and what it comes to with it.

use super::crossing::{Link, Part, SEAM, Search};
use super::geometry::Edge;
use crate::primal::known::KnownHit;

/// How far apart mirrored directions are that jump.
const JUMP: f64 = 1e-6;

impl Search<'_> {
    /// Adds the edges between triangles of a smooth mirror at which mirrored rays jump, with those beside them. Returns
    /// whether there are any.
    pub(super) fn over_mirror(&mut self, link: &Link, part: Part) -> bool {
        let [first, last] = [part.first, part.last].map(|path| self.of(path));
        let beside = first.iter().zip(last).map(|(a, b)| [a.primitive, b.primitive]);
        let Some((depth, mirrors)) = beside.enumerate().find(|(_, [a, b])| a != b) else {
            return false;
        };
        let (passed, geometry) = (&first[..depth], self.geometry);
        let goes_on = first.len().min(last.len()) > depth + 1;
        if !goes_on || !geometry.is_smooth(mirrors[0]) || !self.are_one_surface(mirrors, passed) {
            return false;
        }
        let Some(camera) = geometry.camera_after(passed) else { return false };
        let way = [part.from, part.to].map(|at| geometry.linear_ray(camera, link.place(at)));
        let (mut steps, length) = (Vec::new(), part.to - part.from);
        if !geometry.walk(mirrors, way, &mut steps) {
            return false;
        }
        steps.retain(|step| {
            let place = link.place(part.from + step.at * length);
            let [one, other] = step.triangles.map(|triangle| {
                let path = [passed, &[KnownHit::of_triangle(triangle)]].concat();
                geometry.ray(&path, place).direction
            });
            one.distance(other) > JUMP
        });
        let mut rest = part;
        for step in &steps {
            let at = part.from + step.at * length;
            let [before, after] = [-SEAM, SEAM].map(|beside| {
                let beside = (at + beside * length).clamp(rest.from, part.to);
                (beside, self.traced(link, beside))
            });
            self.search(link, Part { to: before.0, last: before.1, ..rest }, 0);
            let edge = Edge::Segment(step.edge);
            self.emit(link, at, (depth, before.1), edge, [before.1, after.1]);
            rest = Part { from: after.0, first: after.1, ..rest };
        }
        if !steps.is_empty() {
            self.search(link, rest, 0);
        }
        !steps.is_empty()
    }
}
