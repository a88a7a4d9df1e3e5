//! Paths next to edges: what the samples at the ends of a link see may be in another light there.

use super::crossing::{Link, Part, Path, Search, have_same_light};
use super::geometry::{Geometry, Met};
use super::rays::Shadow;
use super::walk::Step;
use crate::primal::known::KnownHit;
use crate::trace::bvh::{NO_PRIMITIVE, rays};
use crate::transport::camera::Ray;

impl Search<'_> {
    /// The path next to an edge, a step from it on the side of an end of a link. Beyond the surface with the
    /// edge it may be another than at the end, and where lights differ from those of the path across the edge, or nothing
    /// is known of them, shadows may end before it: what lies between them is searched for.
    pub(super) fn settled(
        &mut self,
        link: &Link,
        (at, step): (f64, f64),
        (end, path): (f64, Path),
        across: Option<Path>,
        depth: usize,
        divisions: usize,
    ) -> Path {
        if (end - at).abs() <= 2.0 * step {
            return self.lit_at_edge(link, (path, depth), [end, at]);
        }
        let is_known = self.of(path).len() <= depth + 1
            && across.is_some_and(|across| !self.may_be_shaded(path, across, depth))
            && (0..=depth).all(|depth| self.turned_to(link, (path, depth), [end, at]).is_none());
        if is_known {
            return path;
        }
        let beside = at + step * (end - at).signum();
        let found = self.traced(link, beside);
        if self.parting(path, found).is_some_and(|parting| parting <= depth) {
            return self.lit_at_edge(link, (path, depth), [end, at]);
        }
        let rest = match beside < end {
            true => Part { from: beside, to: end, first: found, last: path },
            false => Part { from: end, to: beside, first: path, last: found },
        };
        self.search(link, rest, divisions + 1);
        self.lit_at_edge(link, (found, depth), [beside, at])
    }

    /// Whether a shadow may end on the surfaces of a path up to a depth, on the way to another path.
    fn may_be_shaded(&self, path: Path, other: Path, depth: usize) -> bool {
        let both = self.of(path).iter().zip(self.of(other)).take(depth + 1);
        both.into_iter().any(|(a, b)| a.primitive != NO_PRIMITIVE && !have_same_light(a, b))
    }

    /// A path with what is in the way of lights at an edge, which is so near to a place of the path that nothing but the
    /// normals of curved surfaces differs.
    fn lit_at_edge(
        &mut self,
        link: &Link,
        (mut path, depth): (Path, usize),
        [near, at]: [f64; 2],
    ) -> Path {
        for depth in 0..=depth {
            let turned = self.turned_to(link, (path, depth), [near, at]);
            let Some((met, lights)) = turned else { continue };
            for light in rays(lights) {
                let known = self.of(path)[depth];
                if let Shadow::Of(_) = self.geometry.shadow(light, &known, &met) {
                    path = self.lit_or_dark(path, (depth, light), true);
                }
            }
        }
        path
    }

    /// The point at an edge of a curved surface, which a path meets at a depth, and the lights that the surface faces there
    /// but not at another place: the path, whose lights are those of that place, does not tell what is in their way.
    /// None if there are no such lights.
    fn turned_to(
        &self,
        link: &Link,
        (path, depth): (Path, usize),
        [known_at, at]: [f64; 2],
    ) -> Option<(Met, u64)> {
        let geometry = &self.geometry;
        let known = self.of(path).get(depth).filter(|known| known.primitive != NO_PRIMITIVE)?;
        if geometry.is_flat(known.primitive) {
            return None;
        }
        let [there, here] =
            [known_at, at].map(|at| geometry.meet(known, self.ray(link, path, depth, at)));
        let turns = |light: &usize| {
            known.blocked >> light & 1 == 0
                && !geometry.face_each_other(*light, &there)
                && geometry.face_each_other(*light, &here)
        };
        let lights = (0..geometry.edged_lights()).filter(turns);
        let lights = lights.fold(0, |lights, light| lights | 1 << light);
        (lights != 0).then_some((here, lights))
    }
}

impl Geometry<'_> {
    /// Whether flat triangles on the way over a surface face a light that those at its ends do not, so that these do not
    /// tell what is in its way. The rays are those through places on the way.
    pub fn turn_to_light(
        &self,
        [a, b]: [KnownHit; 2],
        steps: &[Step],
        ray: impl Fn(f64) -> Ray<f64>,
    ) -> bool {
        if self.is_smooth(a.primitive) {
            return false;
        }
        let ends = [self.meet(&a, ray(0.0)), self.meet(&b, ray(1.0))];
        (0..self.edged_lights()).any(|light| {
            let faces = |met: &Met| self.face_each_other(light, met);
            let mut between = steps.windows(2).map(|steps| {
                let facet = KnownHit::of_triangle(steps[0].triangles[1]);
                self.meet(&facet, ray(0.5 * (steps[0].at + steps[1].at)))
            });
            a.blocked >> light & 1 == 0 && !ends.iter().any(faces) && between.any(|met| faces(&met))
        })
    }
}
