//! Strips along silhouettes of smooth meshes, of curved surfaces, and of flat triangles that the camera grazes.
//!
//! The last facets before a silhouette are seen edge-on. They may be much narrower than the distance between samples
//! and go from light to dark; then hardly a sample meets them, and the derivative of their radiance is large. So the
//! interior term of a strip along a silhouette in which a facet ends does not come from the samples that are there,
//! but from one ray in the middle of each facet, across the silhouette at each crossing: of each part of a facet where
//! a light begins to face it, and from several if its material has more than a Lambertian lobe.
//!
//! The derivative of the radiance of a sphere, or of another curved surface, grows towards its silhouette like one
//! over the root of the distance, and may begin to at a terminator next to it. Samples in its strip count the more the
//! deeper they are, from nothing at the silhouette on, so that what they sum is smooth; a few rays stand for the rest.
//! They are as dense over the root of the distance as what they stand for, so that each brings about as much, and shifted
//! by where the silhouette crosses the link, which is as good as a random number. They have to come close to the
//! silhouette: what rough metal reflects changes there like a logarithm. Turned down: one ray where it is exact for a
//! root and a constant, which is off by 15 % where the terminator is a fraction of a pixel inside.

use super::geometry::Geometry;
use super::outline::root;
use super::rays::Shadow;
use super::turned::Turned;
use crate::primal::known::KnownHit;
use crate::transport::camera::CameraFrame;
use crate::transport::material::Lobes;

/// How deep the pixels of a finer grid reach within curved silhouettes, in widths of their strips.
const DEPTH: f64 = 3.0;

/// How many rays a part of a facet has whose radiance is far from linear.
const NONLINEAR_PARTS: u32 = 4;

/// How far within the part of a facet that a light faces its shadow is looked for, as a part of it.
const WITHIN: f64 = 0.01;

/// How often the part of a facet in which a shadow ends is halved.
const HALVINGS: usize = 8;

/// How near to a curved silhouette rays of its strip are at least, as a part of the width that they stand for: there
/// single precision cannot tell their depth.
const NEAREST: f64 = 0.0075;

/// The strip at a crossing of a silhouette.
pub struct Strip {
    extent: Extent,
    /// The parts from facet to facet, as far as the mesh goes on; none if the strip is one facet. Of a curved surface
    /// the strip is one part.
    pub parts: Vec<Part>,
}

/// Where a strip is, in pixels.
#[derive(Clone, Copy)]
struct Extent {
    /// A place on the silhouette.
    place: [f64; 2],
    /// The unit normal of the silhouette into the surface.
    inward: [f64; 2],
    width: f64,
    /// Up to which depth samples do not count, and from which on they do; between these more and more.
    counted: [f64; 2],
}

/// A part of a strip, across the silhouette.
pub struct Part {
    /// Where its ray is, in pixels.
    pub place: [f64; 2],
    /// How wide that is what the ray stands for.
    pub width: f64,
}

impl Strip {
    /// The strip of a `width`, in pixels, within an edge of a triangle that a camera sees.
    pub fn of_facets(
        geometry: &Geometry<'_>,
        (camera, triangle, edge): (CameraFrame<f64>, u32, [u32; 2]),
        (place, inward): ([f64; 2], [f64; 2]),
        width: f64,
    ) -> Self {
        let extent = Extent { place, inward, width, counted: [0.0; 2] };
        let mut strip = Self { extent, parts: Vec::new() };
        let way = [place, extent.at(width)].map(|place| geometry.linear_ray(camera, place));
        let facets = geometry.facets(triangle, Some(edge), way);
        if facets != [(triangle, 1.0)] {
            let mut start = 0.0;
            for (triangle, end) in facets {
                let end = end * width;
                let mut ends = extent.ends_of_light(geometry, (camera, triangle), [start, end]);
                ends.push(end);
                ends.sort_by(f64::total_cmp);
                let lobes = geometry.layout.traits_of(triangle as usize).lobes;
                let rays = if lobes == Lobes::default() { 1 } else { NONLINEAR_PARTS };
                for end in ends {
                    let width = (end - start) / f64::from(rays);
                    let depth = |ray: u32| start + (f64::from(ray) + 0.5) * width;
                    let parts = (0..rays).map(|ray| Part { place: extent.at(depth(ray)), width });
                    strip.parts.extend(parts);
                    start = end;
                }
            }
            strip.extent.counted = [start; 2];
        }
        strip
    }

    /// The strip of a `width`, in pixels, within the silhouette of a curved surface. Its rays, so
    /// many parts of it, are shifted by a number between 0 and 1.
    pub fn curved(
        (place, inward): ([f64; 2], [f64; 2]),
        width: f64,
        (parts, shift): (usize, f64),
    ) -> Self {
        let extent = Extent { place, inward, width, counted: [0.0, width] };
        // Of a depth of `root^2` widths `1 - root^2` is not counted: the rays are as dense over the root. The part of them
        // that is nearer to the silhouette is `(3 root - root^3) / 2`.
        let part = |index: usize| {
            let nearer = ((index as f64 + shift) / parts as f64).max(NEAREST);
            let root = 2.0 * (nearer.asin() / 3.0).sin();
            let stands_for = 4.0 / 3.0 * root / parts as f64;
            Part { place: extent.at(root * root * width), width: stands_for * width }
        };
        Self { extent, parts: (0..parts).map(part).collect() }
    }

    /// Places in pixels next to the silhouette, which need rays of a finer grid.
    pub fn needs(&self) -> [[f64; 2]; 3] {
        let Extent { width, counted, .. } = self.extent;
        let is_curved = counted[0] < counted[1];
        let deepest = if is_curved { DEPTH * width } else { width };
        [0.0, width, deepest].map(|depth| self.extent.at(depth))
    }
}

impl Extent {
    /// The place at a depth.
    fn at(&self, depth: f64) -> [f64; 2] {
        [0, 1].map(|axis| self.place[axis] + depth * self.inward[axis])
    }

    /// The depths on a facet at which lights begin to face it, or to face away, and at which its own shadow ends.
    fn ends_of_light(
        &self,
        geometry: &Geometry<'_>,
        (camera, triangle): (CameraFrame<f64>, u32),
        [start, end]: [f64; 2],
    ) -> Vec<f64> {
        let facet = KnownHit::of_triangle(triangle);
        let depth = |part: f64| start + part * (end - start);
        let meet = |part: f64| {
            let ray = geometry.linear_ray(camera, self.at(depth(part)));
            geometry.meet(&facet, ray)
        };
        let turned_away = Turned::of(geometry, triangle).lights;
        let mut found = Vec::new();
        for light in 0..geometry.edged_lights() {
            let facing = |part: f64| geometry.facing(light, &meet(part));
            let ends = [facing(0.0), facing(1.0)];
            let sign = if ends[0] < 0.0 { -1.0 } else { 1.0 };
            let [low, high] = ends.map(|end| sign * end);
            let mut faced = [0.0, 1.0];
            let terminator = || root(|part| sign * facing(part), low, high);
            if let Some(terminator) = (high < 0.0).then(terminator).flatten() {
                found.push(depth(terminator));
                faced[usize::from(sign > 0.0)] = terminator;
            } else if sign < 0.0 {
                continue;
            }
            if turned_away >> light & 1 == 0 {
                continue;
            }
            let is_dark = |part: f64| {
                let met = meet(part);
                matches!(geometry.shadow(light, &facet, &met), Shadow::Of(_))
            };
            let within = |part: f64| faced[0] + part * (faced[1] - faced[0]);
            let (first, last) = (within(WITHIN), within(1.0 - WITHIN));
            if is_dark(first) != is_dark(last) {
                let [mut lit, mut dark] =
                    if is_dark(first) { [last, first] } else { [first, last] };
                for _ in 0..HALVINGS {
                    let middle = 0.5 * (lit + dark);
                    *if is_dark(middle) { &mut dark } else { &mut lit } = middle;
                }
                found.push(depth(0.5 * (lit + dark)));
            }
        }
        found
    }

    /// The pixels of an image that may be so far away from its place.
    fn pixels(self, reach: f64, size: [u32; 2]) -> impl Iterator<Item = u32> {
        let along = |axis: usize| {
            let end = |by: f64| ((self.place[axis] + by).max(0.0) as u32).min(size[axis]);
            end(-reach)..(end(reach) + 1).min(size[axis])
        };
        let columns = along(0);
        along(1).flat_map(move |y| columns.clone().map(move |x| y * size[0] + x))
    }
}

/// How much samples count in strips.
#[derive(Default)]
pub struct Strips {
    /// How far strips reach along the silhouette to either side of their place, in pixels.
    reach: f64,
    /// By pixel: the strips that may be there.
    extents: Vec<Extent>,
    /// Where those of each pixel start in the list, then its length; nothing if there are none.
    starts: Vec<u32>,
}

impl Strips {
    /// Of strips of this `reach`, in an image of a size in pixels.
    pub fn new<'a>(reach: f64, strips: impl Iterator<Item = &'a Strip>, size: [u32; 2]) -> Self {
        let of_strip = |strip: &'a Strip| {
            let extent = strip.extent;
            extent.pixels(reach.max(extent.width), size).map(move |pixel| (pixel, extent))
        };
        let mut extents: Vec<(u32, Extent)> = strips.flat_map(of_strip).collect();
        extents.sort_by_key(|&(pixel, _)| pixel);
        let mut starts = vec![0; size[0] as usize * size[1] as usize + 1];
        extents.iter().for_each(|&(pixel, _)| starts[pixel as usize + 1] += 1);
        (1..starts.len()).for_each(|pixel| starts[pixel] += starts[pixel - 1]);
        Self { reach, extents: extents.into_iter().map(|(_, extent)| extent).collect(), starts }
    }

    /// How much a sample counts in a pixel: less than 1 in the nearest strip, if there is one.
    pub fn weight(&self, pixel: usize, place: [f64; 2]) -> f64 {
        let Some(&[start, end]) = self.starts.get(pixel..pixel + 2) else { return 1.0 };
        let (mut nearest, mut weight) = (self.reach, 1.0);
        for extent in &self.extents[start as usize..end as usize] {
            let Extent { place: [x, y], inward: [u, v], width, counted: [none, all] } = *extent;
            let [x, y] = [place[0] - x, place[1] - y];
            let (depth, along) = (x * u + y * v, (x * v - y * u).abs());
            if depth > 0.0 && depth < width && along < nearest {
                let part = if depth >= all { 1.0 } else { (depth - none) / (all - none) };
                (nearest, weight) = (along, part.max(0.0));
            }
        }
        weight
    }
}
