//! Strips along silhouettes of smooth meshes.
//!
//! The last facets before a silhouette are seen edge-on. They may be much narrower than the distance between samples
//! and go from light to dark; then hardly a sample meets them, and the derivative of their radiance is large. So the
//! interior term of a strip along a silhouette in which a facet ends does not come from the samples that are there,
//! but from one ray in the middle of each facet, across the silhouette at each crossing.

use super::geometry::Geometry;
use crate::number::Plain;
use crate::primal::known::KnownHit;

/// The strip at a crossing of a silhouette.
pub struct Strip {
    /// A place on the silhouette, in pixels.
    place: [f64; 2],
    /// The unit normal of the silhouette into the mesh.
    inward: [f64; 2],
    /// The parts from facet to facet, as far as the mesh goes on; none if the strip is one facet.
    pub parts: Vec<Part>,
}

/// A part of a strip, across the silhouette.
pub struct Part {
    /// Its middle, in pixels.
    pub place: [f64; 2],
    pub width: f64,
    /// What is seen there.
    pub hits: Vec<KnownHit>,
}

impl Strip {
    /// The strip of a `width`, in pixels, within an edge of a triangle.
    pub fn new<L: Plain>(
        geometry: &Geometry<'_, L>,
        (triangle, edge): (u32, [u32; 2]),
        (place, inward): ([f64; 2], [f64; 2]),
        width: f64,
    ) -> Self {
        let mut strip = Self { place, inward, parts: Vec::new() };
        let ends = geometry.facets(triangle, edge, [place, strip.at(width)]);
        if ends != [1.0] {
            let mut start = 0.0;
            let parts = ends.into_iter().map(|end| {
                let place = strip.at(0.5 * (start + end) * width);
                let mut hits = Vec::new();
                geometry.trace(place, &mut hits);
                let part = Part { place, width: (end - start) * width, hits };
                start = end;
                part
            });
            strip.parts = parts.collect();
        }
        strip
    }

    /// The place at a depth, in pixels.
    pub fn at(&self, depth: f64) -> [f64; 2] {
        [0, 1].map(|axis| self.place[axis] + depth * self.inward[axis])
    }
}

/// Which places of an image are in strips that have parts.
#[derive(Default)]
pub struct Strips {
    /// How wide they are, and how far they reach along the silhouette to either side of their place, in pixels.
    size: [f64; 2],
    /// By pixel: the place, the normal into the mesh, and how wide the parts are together.
    strips: Vec<([f64; 2], [f64; 2], f64)>,
    /// Where those of each pixel start in the list, then its length; nothing if there are none.
    starts: Vec<u32>,
}

impl Strips {
    /// Strips of this `size`, each with its pixel, of so many pixels.
    pub fn new(size: [f64; 2], mut strips: Vec<(u32, &Strip)>, pixels: usize) -> Self {
        strips.sort_by_key(|&(pixel, _)| pixel);
        let mut starts = vec![0; pixels + 1];
        strips.iter().for_each(|&(pixel, _)| starts[pixel as usize + 1] += 1);
        (0..pixels).for_each(|pixel| starts[pixel + 1] += starts[pixel]);
        let widths = |strip: &Strip| strip.parts.iter().map(|part| part.width).sum();
        let strips = strips.into_iter();
        let strips = strips.map(|(_, strip)| (strip.place, strip.inward, widths(strip)));
        Self { size, strips: strips.collect(), starts }
    }

    /// Whether a place in a pixel is in a part of the nearest strip.
    pub fn hold(&self, pixel: usize, place: [f64; 2]) -> bool {
        let Some(&[start, end]) = self.starts.get(pixel..pixel + 2) else { return false };
        let [width, reach] = self.size;
        let (mut nearest, mut holds) = (reach, false);
        for &([x, y], [u, v], of_parts) in &self.strips[start as usize..end as usize] {
            let [x, y] = [place[0] - x, place[1] - y];
            let (depth, along) = (x * u + y * v, (x * v - y * u).abs());
            if depth > 0.0 && depth < width && along < nearest {
                (nearest, holds) = (along, depth < of_parts);
            }
        }
        holds
    }
}
