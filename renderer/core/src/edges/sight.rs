//! What the samples of an image see: the paths that they met, and which lights were blocked there.

use std::sync::atomic::{AtomicU32, AtomicU64, Ordering};

use super::code::{END, LEAVES, code, decode};
use super::geometry::Geometry;
use crate::number::Plain;
use crate::parallel;
use crate::primal::known::{KnownHit, KnownPaths};
use crate::primal::path::Path;
use crate::primal::wavefront::{Wavefront, samples};
use crate::trace::bvh::ray_at;
use crate::trace::layout::Layout;
use crate::trace::tile::{Tile, for_each_strip};

/// The path of every sample of a regular grid, and of one more row and column of samples on each side of
/// the image.
pub struct Sights {
    /// How many samples stand side by side in a pixel.
    pub side: usize,
    pub columns: usize,
    pub rows: usize,
    /// How many lights have shadows with edges.
    lights: usize,
    depths: Vec<Plane>,
}

/// How many samples around the image are traced one after the other.
const BORDER_CHUNK: usize = 64;

/// What the samples see at one depth.
struct Plane {
    primitives: Vec<AtomicU32>,
    blocked: Vec<AtomicU64>,
    filters: Vec<AtomicU32>,
}

impl Sights {
    /// Room for those of the image of a scene, by the regular grid of its rays.
    pub fn new<L: Plain>(geometry: &Geometry<'_, L>) -> Self {
        let layout = geometry.integrator.layout;
        let side = layout.sampling.grid_side() as usize;
        let (columns, rows) = (layout.width as usize * side + 2, layout.height as usize * side + 2);
        let samples = columns * rows;
        let lights = geometry.edged_lights();
        let with_lights = if lights == 0 { 0 } else { samples };
        let with_filters = if layout.has_transparency { with_lights } else { 0 };
        let plane = |_| Plane {
            primitives: (0..samples).map(|_| AtomicU32::new(END)).collect(),
            blocked: (0..with_lights).map(|_| AtomicU64::new(0)).collect(),
            filters: (0..with_filters).map(|_| AtomicU32::new(0)).collect(),
        };
        let depths = (0..geometry.integrator.depths()).map(plane).collect();
        Self { side, columns, rows, lights, depths }
    }

    /// Those of the image of a scene, traced and not shaded, with what the samples around it see.
    pub fn traced<L: Plain>(geometry: &Geometry<'_, L>) -> Self {
        let (sights, integrator) = (Self::new(geometry), geometry.integrator);
        let Layout { width, height, sampling, .. } = integrator.layout;
        for_each_strip(*width, *height, Path::default, |path, strip| {
            for tile in strip.tiles() {
                for (index, sample) in samples(&tile, sampling.as_grid()).enumerate() {
                    integrator.trace_path(sample, path);
                    sights.keep(&tile, index as u32, path.wavefronts());
                }
            }
        });
        sights.keep_border(geometry);
        sights
    }

    /// Where a sample is, in pixels from the upper left corner of the image.
    pub fn place(&self, column: usize, row: usize) -> [f64; 2] {
        [column, row].map(|index| (index as f64 - 0.5) / self.side as f64)
    }

    /// The index of the link that starts at a sample, row by row, to the right before downwards.
    pub fn link(&self, [column, row]: [usize; 2], axis: usize) -> usize {
        2 * (row * self.columns + column) + axis
    }

    /// The pixel of a sample, unless it is outside of the image.
    pub fn pixel(&self, column: usize, row: usize) -> Option<u32> {
        let is_inside =
            (1..self.columns - 1).contains(&column) && (1..self.rows - 1).contains(&row);
        let width = (self.columns - 2) / self.side;
        is_inside.then(|| ((row - 1) / self.side * width + (column - 1) / self.side) as u32)
    }

    /// The samples of a tile, those with this index of the rays of their pixels: rays and places.
    fn of_tile(&self, tile: &Tile, index: u32) -> impl Iterator<Item = (usize, usize)> + use<> {
        let (side, columns, tile) = (self.side, self.columns, *tile);
        let (right, down) = (index as usize % side, index as usize / side);
        (0..tile.rows).flat_map(move |row| {
            let first =
                ((tile.top + row) * side + down + 1) * columns + tile.left * side + right + 1;
            (0..tile.columns).map(move |column| (ray_at(column, row), first + column * side))
        })
    }

    /// Keeps what the samples of a tile see, one of each pixel.
    pub fn keep<L: Plain>(&self, tile: &Tile, index: u32, wavefronts: &[Wavefront<L>]) {
        for (wavefront, plane) in wavefronts.iter().zip(&self.depths) {
            let seen = wavefront.hits.met() | wavefront.missed;
            let lights = &wavefront.blocked[..self.lights];
            for (ray, at) in self.of_tile(tile, index) {
                if seen >> ray & 1 == 1 {
                    let blocked = lights.iter().enumerate();
                    let blocked = blocked
                        .fold(0, |bits, (light, blocked)| bits | (blocked >> ray & 1) << light);
                    let leaves = wavefront.hits.leaves >> ray & 1 == 1;
                    let primitive = wavefront.hits.primitive[ray];
                    let filters = wavefront.filters.get(ray).copied().unwrap_or(0);
                    plane.keep(at, &KnownHit { primitive, leaves, blocked, filters });
                }
            }
        }
    }

    /// The paths of the samples of a tile, one of each pixel, as they were kept.
    pub fn paths(&self, tile: &Tile, index: u32, paths: &mut KnownPaths) {
        paths.clear();
        for (ray, at) in self.of_tile(tile, index) {
            paths.set(ray, self.hits(at), self.lights);
        }
    }

    /// Keeps what the samples around the image see.
    pub fn keep_border<L: Plain>(&self, geometry: &Geometry<'_, L>) {
        let (columns, rows) = (self.columns, self.rows);
        let across = (0..columns).flat_map(|column| [(column, 0), (column, rows - 1)]);
        let down = (1..rows - 1).flat_map(|row| [(0, row), (columns - 1, row)]);
        let border: Vec<(usize, usize)> = across.chain(down).collect();
        parallel::map(border.chunks(BORDER_CHUNK).collect(), Vec::new, |path, samples| {
            for &(column, row) in samples {
                path.clear();
                geometry.trace(self.place(column, row), path);
                let at = row * columns + column;
                path.iter().zip(&self.depths).for_each(|(known, plane)| plane.keep(at, known));
            }
        });
    }

    /// Of the samples of a row: a bit for a neighbour to the right that sees other surfaces, or lights, and
    /// one for such a neighbour below.
    pub fn differences(&self, row: usize, differ: &mut Vec<[bool; 2]>) {
        differ.clear();
        differ.resize(self.columns, [false; 2]);
        let start = row * self.columns;
        let has_next = row + 1 < self.rows;
        for plane in &self.depths {
            for (column, differ) in differ.iter_mut().enumerate() {
                let at = start + column;
                let seen = plane.hit(at);
                let differs = |other: usize| plane.hit(other) != seen;
                differ[0] |= column + 1 < self.columns && differs(at + 1);
                differ[1] |= has_next && differs(at + self.columns);
            }
        }
    }

    /// Whether two samples see the same surfaces: the same primitives, or parts of smooth ones.
    pub fn have_same_path<L: Plain>(&self, a: usize, b: usize, geometry: &Geometry<'_, L>) -> bool {
        self.depths.iter().all(|plane| {
            let [a, b] = [a, b].map(|at| plane.primitive(at));
            a == b || geometry.are_continuous(a & !LEAVES, b & !LEAVES)
        })
    }

    /// The path of a sample.
    pub fn hits(&self, at: usize) -> impl Iterator<Item = KnownHit> {
        let planes = self.depths.iter().take_while(move |plane| plane.primitive(at) != END);
        planes.map(move |plane| plane.hit(at))
    }
}

impl Plane {
    fn keep(&self, at: usize, known: &KnownHit) {
        self.primitives[at].store(code(known), Ordering::Relaxed);
        if let Some(blocked) = self.blocked.get(at) {
            blocked.store(known.blocked, Ordering::Relaxed);
        }
        if let Some(filters) = self.filters.get(at) {
            filters.store(known.filters, Ordering::Relaxed);
        }
    }

    #[inline]
    fn hit(&self, at: usize) -> KnownHit {
        let filters = self.filters.get(at).map_or(0, |filters| filters.load(Ordering::Relaxed));
        KnownHit { blocked: self.blocked(at), filters, ..decode(self.primitive(at)) }
    }

    #[inline]
    fn primitive(&self, at: usize) -> u32 {
        self.primitives[at].load(Ordering::Relaxed)
    }

    #[inline]
    fn blocked(&self, at: usize) -> u64 {
        self.blocked.get(at).map_or(0, |bits| bits.load(Ordering::Relaxed))
    }
}
