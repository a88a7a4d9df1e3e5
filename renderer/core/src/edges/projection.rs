//! Meshes as they are seen in the image. Most links of a finely tessellated mesh lie over one smooth surface: they are
//! followed there with a few numbers for each triangle, where the [walk](super::walk) of a ray would take ten times as
//! long.

use std::ops::Range;

use super::geometry::Geometry;
use super::turned::Turned;
use crate::parallel;
use crate::trace::adjacency::sides;

/// The most triangles that a link is followed over.
const MOST_STEPS: usize = 16;

/// Where the camera sees the vertices of a scene.
pub struct Projection<'a> {
    geometry: Geometry<'a>,
    /// By vertex, in pixels; not a number behind the camera.
    places: Vec<[f64; 2]>,
    /// The orientation in the image of triangles whose front the camera sees.
    front: f64,
}

impl<'a> Projection<'a> {
    /// Of a scene.
    pub fn new(geometry: &Geometry<'a>) -> Self {
        let geometry = *geometry;
        let count = geometry.layout.vertices();
        let place = |vertex: usize| {
            let place = geometry.project(geometry.frame, geometry.vertex(vertex as u32));
            place.unwrap_or([f64::NAN; 2])
        };
        let of_some = |vertices: Range<usize>| -> Vec<_> { vertices.map(place).collect() };
        let frame = geometry.frame;
        // Rows run downwards.
        let front = frame.right.cross(frame.up).dot(frame.forward).signum();
        Self { geometry, places: parallel::map_ranges(count, of_some).concat(), front }
    }

    /// The corners of a triangle; nothing if one is behind the camera.
    pub fn corners(&self, triangle: usize) -> Option<[[f64; 2]; 3]> {
        let corners = self.geometry.layout.triangles[triangle].map(|vertex| self.place(vertex));
        corners.iter().all(|[x, _]| !x.is_nan()).then_some(corners)
    }

    /// Whether the corners of a triangle stand anticlockwise for the camera.
    pub fn is_front(&self, triangle: usize) -> bool {
        match self.corners(triangle) {
            Some(corners) => self.front * turn(corners) > 0.0,
            None => self.geometry.faces(triangle, self.geometry.frame.origin),
        }
    }

    /// Whether a way in the image leads from within one triangle to within another over one smooth surface, of triangles
    /// of which `turned` tells how they stand: nothing where they are not to be gone over. Where only rounding could tell, it does not.
    pub fn leads_smoothly(
        &self,
        [first, last]: [u32; 2],
        [from, to]: [[f64; 2]; 2],
        turned: impl Fn(u32) -> Option<Turned>,
    ) -> bool {
        let layout = self.geometry.layout;
        if ![first, last].into_iter().all(|primitive| self.geometry.is_triangle(primitive)) {
            return false;
        }
        let beside = |vertex: u32| turn([from, to, self.place(vertex)]);
        let mut corners = layout.triangles[first as usize];
        let places = corners.map(|corner| self.place(corner));
        let orientation = turn(places).signum();
        let is_left_of = |[p, q]: [u32; 2], place: [f64; 2]| {
            orientation * turn([self.place(p), self.place(q), place]) > 0.0
        };
        let Some(mut of_triangle) = turned(first) else { return false };
        if !sides(corners).into_iter().all(|side| is_left_of(side, from)) {
            return false;
        }
        let mut triangle = first;
        for _ in 0..MOST_STEPS {
            // The side that the way leaves the triangle by has its first corner to the right of it, the other to the left.
            let across = corners.map(|corner| orientation * beside(corner));
            let leaves = |&side: &usize| across[side] < 0.0 && across[(side + 1) % 3] > 0.0;
            let Some(side) = (0..3).find(leaves) else { return false };
            let [p, q] = sides(corners)[side];
            if is_left_of([p, q], to) {
                return triangle == last;
            }
            let Some(next) = self.geometry.adjacency.across(triangle, side) else { return false };
            corners = layout.triangles[next as usize];
            let Some(apex) = (0..3).find(|&at| corners[at] != p && corners[at] != q) else {
                return false;
            };
            // At a fold the next triangle is on the same side.
            let goes_on =
                orientation * turn([self.place(q), self.place(p), self.place(corners[apex])]) > 0.0;
            let Some(of_next) = turned(next) else { return false };
            let is_even = of_next.has_normals_behind == of_triangle.has_normals_behind
                && corners[(apex + 1) % 3] == q;
            let is_smooth = match is_even && self.geometry.adjacency.is_seam(triangle, side) {
                true => layout.look_alike(triangle as usize, next as usize),
                false => self.geometry.are_continuous(triangle, next),
            };
            if !goes_on || !is_smooth {
                return false;
            }
            (triangle, of_triangle) = (next, of_next);
        }
        false
    }

    fn place(&self, vertex: u32) -> [f64; 2] {
        self.places[vertex as usize]
    }
}

/// Twice the area of a triangle in the image, positive where its corners turn from x to y.
fn turn([a, b, c]: [[f64; 2]; 3]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}
