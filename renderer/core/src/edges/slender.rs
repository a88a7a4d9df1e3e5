//! What may lie between two neighbouring samples whole: triangles next to outlines of meshes that are
//! narrower in the image than the distance between samples.
//!
//! No sample sees them, so nothing tells that there is an edge. They are found from the scene: where such
//! a triangle lies on a link, a ray through it shows what is there, and the search goes on from it. Of two
//! triangles next to a fold only that in front is looked at. Only what the camera sees directly is found:
//! nothing in mirrors, and no shadows. Turned down:
//! to do the same for spheres, whose radiance at the silhouette says little about that of all of it.

use std::ops::Range;

use rayon::prelude::*;

use super::geometry::Geometry;
use super::links::{COLUMNS, Links};
use super::projection::Projection;
use super::sight::Sights;
use crate::parallel;

/// How far on the way to an outline what is slender is looked at. What is on it, shadows too, is then behind.
const BESIDE: f64 = 0.9;

/// The links with something slender on them.
pub struct Slender {
    /// Links, by their index among all, and parts of them, in order.
    places: Vec<(u64, f64)>,
}

impl Slender {
    /// What may lie between the samples of a view.
    pub fn new(geometry: &Geometry<'_>, projection: &Projection<'_>, sights: &Sights) -> Self {
        let count = geometry.layout.triangles.len();
        let is_front = |triangles: Range<usize>| -> Vec<bool> {
            triangles.map(|triangle| projection.is_front(triangle)).collect()
        };
        let is_front = parallel::map_ranges(count, is_front).concat();
        let is_outline = |triangle: usize, side: usize| {
            let across = geometry.adjacency.across(triangle as u32, side);
            across.is_none_or(|across| {
                let is_fold = is_front[triangle] != is_front[across as usize];
                is_fold && !geometry.is_behind([triangle, across as usize], geometry.frame.origin)
            })
        };
        let finder = Finder { sights };
        let of_some = |triangles: Range<usize>| {
            let mut places = Vec::new();
            for triangle in triangles {
                let outline = [0, 1, 2].map(|side| is_outline(triangle, side));
                if outline.contains(&true)
                    && geometry.has_area(triangle)
                    && let Some(corners) = projection.corners(triangle)
                {
                    finder.triangle(corners, outline, &mut places);
                }
            }
            places
        };
        let mut places = parallel::map_ranges(count, of_some).concat();
        places.par_sort_unstable_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        Self { places }
    }

    /// Adds the links of a row of samples on which something slender may be seen.
    pub fn mark(&self, row: usize, sights: &Sights, links: &mut [Links]) {
        let ends = [row, row + 1].map(|row| self.start_of(sights.link([0, row], 0)));
        for &(link, _) in &self.places[ends[0]..ends[1]] {
            let ([column, _], axis) = sights.start_of(link as usize);
            links[column / COLUMNS][axis] |= 1 << (column % COLUMNS);
        }
    }

    /// Parts of a link at which something slender may be seen, in order. Links that have some are asked for in
    /// theirs, from a `start` in the list that is moved along.
    pub fn of_link(&self, link: usize, start: &mut usize) -> impl Iterator<Item = f64> {
        let first = *start;
        let rest = self.places[first..].iter();
        *start += rest.take_while(|(of, _)| *of == link as u64).count();
        self.places[first..*start].iter().map(|&(_, at)| at)
    }

    /// Where the places of the links from this one on start in the list.
    pub fn start_of(&self, link: usize) -> usize {
        self.places.partition_point(|(of, _)| *of < link as u64)
    }
}

/// Finds links on which something lies between the samples.
struct Finder<'a> {
    sights: &'a Sights,
}

impl Finder<'_> {
    /// A place in distances between samples, from the first sample of all.
    fn in_samples(&self, place: [f64; 2]) -> [f64; 2] {
        place.map(|at| at * self.sights.side as f64 + 0.5)
    }

    /// Adds the links that a triangle lies on, given which of its sides are of an outline.
    fn triangle(&self, corners: [[f64; 2]; 3], outline: [bool; 3], to: &mut Vec<(u64, f64)>) {
        let corners = corners.map(|corner| self.in_samples(corner));
        for axis in [0, 1] {
            let across = 1 - axis;
            let [low, high] = extent(corners.map(|corner| corner[across]));
            for line in self.lines(axis, low, high) {
                let level = line as f64;
                let (mut ends, mut count, mut is_outline) = ([0.0; 2], 0, [false; 2]);
                for side in 0..3 {
                    let (a, b) = (corners[side], corners[(side + 1) % 3]);
                    if (a[across] <= level) != (b[across] <= level) && count < 2 {
                        let part = (level - a[across]) / (b[across] - a[across]);
                        ends[count] = a[axis] + part * (b[axis] - a[axis]);
                        is_outline[count] = outline[side];
                        count += 1;
                    }
                }
                if count == 2 && is_outline != [false; 2] {
                    self.between(axis, line, ends, is_outline, to);
                }
            }
        }
    }

    /// The rows of samples, or the columns for links that run downwards, between two of their places.
    fn lines(&self, axis: usize, low: f64, high: f64) -> Range<usize> {
        let count = if axis == 0 { self.sights.rows } else { self.sights.columns };
        // What is not a number is 0 as an index.
        low.ceil().max(0.0) as usize..((high.floor() + 1.0).max(0.0) as usize).min(count)
    }

    /// Adds a link if what is between two ends, of which some are of an outline, lies between its samples.
    fn between(
        &self,
        axis: usize,
        line: usize,
        ends: [f64; 2],
        is_outline: [bool; 2],
        to: &mut Vec<(u64, f64)>,
    ) {
        let [start, end] = extent(ends);
        let first = start.floor();
        let count = if axis == 0 { self.sights.columns } else { self.sights.rows };
        if first < 0.0 || end.floor() != first || first + 1.0 >= count as f64 {
            return;
        }
        let place = if axis == 0 { [first as usize, line] } else { [line, first as usize] };
        let link = self.sights.link(place, axis);
        let part = match is_outline {
            [true, false] => 1.0 - BESIDE,
            [false, true] => BESIDE,
            _ => 0.5,
        };
        to.push((link as u64, ends[0] + part * (ends[1] - ends[0]) - first));
    }
}

/// The smallest and the largest of some numbers.
fn extent<const N: usize>(numbers: [f64; N]) -> [f64; 2] {
    numbers.into_iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], number| {
        [low.min(number), high.max(number)]
    })
}
