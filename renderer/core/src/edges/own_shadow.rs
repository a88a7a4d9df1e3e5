//! The search for own shadows of smooth meshes, on triangles that have [turned away](super::turned) from a light.
//! The next sample may be where shading normals face away, too, so that both seem to be in the same light.

use super::crossing::{Link, Part, Path, Search};
use crate::primal::known::KnownHit;
use crate::trace::bvh::rays;
use crate::transport::camera::CameraFrame;

/// How far from a terminator own shadows are looked for, as a part of the way to where lights face shading normals most.
const TERMINATOR: f64 = 0.02;

impl Search<'_> {
    /// A place on a part of a link, over these triangles and the parts of the way that they take, at which the surface
    /// is in its own shadow with respect to a light that no shadow is known to keep off, and the path there.
    pub(super) fn own_shadow(
        &mut self,
        link: &Link,
        Part { from, to, first, last }: Part,
        (depth, camera): (usize, CameraFrame<f64>),
        facets: impl Iterator<Item = (u32, [f64; 2])>,
    ) -> Option<(f64, Path)> {
        let [of_first, of_last] = [first, last].map(|path| self.of(path)[depth].blocked);
        let known = of_first | of_last;
        let place = |at: f64| from + at * (to - from);
        for (triangle, ends) in facets {
            for light in rays(self.turned.of(triangle).lights & !known) {
                let facing = |at: f64| {
                    let ray = self.geometry.linear_ray(camera, link.place(place(at)));
                    self.geometry.facing_turned(light, triangle, ray)
                };
                let [Some(start), Some(end)] = ends.map(facing) else { continue };
                // Next to a lit triangle rays that start above the surface may come to the light.
                let part = match [start > 0.0, end > 0.0] {
                    [false, false] => continue,
                    [true, true] => 0.5,
                    [true, false] => (1.0 - TERMINATOR) * start / (start - end),
                    [false, true] => 1.0 - (1.0 - TERMINATOR) * end / (end - start),
                };
                let at = place(ends[0] + part * (ends[1] - ends[0]));
                let path = self.traced(link, at);
                let is_dark =
                    |hit: &KnownHit| hit.primitive == triangle && hit.blocked >> light & 1 == 1;
                if self.of(path).get(depth).is_some_and(is_dark) {
                    return Some((at, path));
                }
            }
        }
        None
    }

    /// Where a smooth surface, at the end of a path, is in its own shadow on the way to its silhouette, and the path
    /// there.
    pub(super) fn own_shadow_before(
        &mut self,
        link: &Link,
        [from, to]: [f64; 2],
        (depth, path): (usize, Path),
    ) -> Option<(f64, Path)> {
        let (&hit, passed) = self.of(path).split_last()?;
        if passed.len() != depth || self.turned.of(hit.primitive).lights == 0 {
            return None;
        }
        let camera = self.geometry.camera_after(passed)?;
        let facets = [(hit.primitive, [0.0, 1.0])].into_iter();
        self.own_shadow(link, Part { from, to, first: path, last: path }, (depth, camera), facets)
    }
}
