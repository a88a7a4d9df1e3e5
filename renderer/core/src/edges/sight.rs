//! What the samples of an image see: the paths that they met, and which lights were blocked there.

use std::sync::atomic::{AtomicU32, AtomicU64, Ordering};

use super::code::{END, LEAVES, MOST_LIGHTS, code, decode};
use super::geometry::Geometry;
use crate::number::Plain;
use crate::primal::integrator::Integrator;
use crate::primal::known::KnownHit;
use crate::primal::wavefront::Wavefront;
use crate::trace::bvh::{NO_PRIMITIVE, rays};
use crate::trace::tile::Tile;

/// The path of every sample of a regular grid, and of one more row and column of samples on each side of
/// the image.
pub struct Sights {
    /// How many samples stand side by side in a pixel.
    pub side: usize,
    pub columns: usize,
    pub rows: usize,
    depths: Vec<Plane>,
}

/// What the samples see at one depth.
struct Plane {
    primitives: Vec<AtomicU32>,
    blocked: Vec<AtomicU64>,
}

impl Sights {
    /// Those of an image of this size, with paths of at most `depths` surfaces.
    pub fn new(width: u32, height: u32, side: usize, depths: usize, has_lights: bool) -> Self {
        let (columns, rows) = (width as usize * side + 2, height as usize * side + 2);
        let plane = || Plane {
            primitives: (0..columns * rows).map(|_| AtomicU32::new(END)).collect(),
            blocked: (0..if has_lights { columns * rows } else { 0 })
                .map(|_| AtomicU64::new(0))
                .collect(),
        };
        Self { side, columns, rows, depths: (0..depths).map(|_| plane()).collect() }
    }

    /// Where a sample is, in pixels from the upper left corner of the image.
    pub fn place(&self, column: usize, row: usize) -> [f64; 2] {
        [column, row].map(|index| (index as f64 - 0.5) / self.side as f64)
    }

    /// The pixel of a sample, unless it is outside of the image.
    pub fn pixel(&self, column: usize, row: usize) -> Option<u32> {
        let is_inside =
            (1..self.columns - 1).contains(&column) && (1..self.rows - 1).contains(&row);
        let width = (self.columns - 2) / self.side;
        is_inside.then(|| ((row - 1) / self.side * width + (column - 1) / self.side) as u32)
    }

    /// Keeps what the samples of a tile see, one of each pixel.
    pub fn keep<L: Plain>(&self, tile: &Tile, index: u32, wavefronts: &[Wavefront<L>]) {
        let (right, down) = (index as usize % self.side, index as usize / self.side);
        for (depth, (wavefront, plane)) in wavefronts.iter().zip(&self.depths).enumerate() {
            let seen = wavefront.hits.met() | wavefront.missed;
            let wanted = if depth == 0 { tile.rays() } else { seen };
            for ray in rays(wanted & tile.rays()) {
                let (x, y) = tile.pixel(ray);
                let column = x as usize * self.side + right + 1;
                let row = y as usize * self.side + down + 1;
                let at = row * self.columns + column;
                let primitive = wavefront.hits.primitive[ray];
                let leaves = (wavefront.hits.leaves >> ray & 1) as u32 * LEAVES;
                let primitive =
                    if primitive == NO_PRIMITIVE { primitive } else { primitive | leaves };
                plane.primitives[at].store(primitive, Ordering::Relaxed);
                let blocked = wavefront.blocked.iter().take(MOST_LIGHTS).enumerate();
                let blocked =
                    blocked.fold(0, |bits, (light, blocked)| bits | (blocked >> ray & 1) << light);
                if let Some(of_plane) = plane.blocked.get(at) {
                    of_plane.store(blocked, Ordering::Relaxed);
                }
            }
        }
    }

    /// Keeps what the samples around the image see.
    pub fn keep_border<L: Plain>(&self, geometry: &Geometry<'_, L>) {
        use rayon::prelude::*;
        let (columns, rows) = (self.columns, self.rows);
        let across = (0..columns).flat_map(|column| [(column, 0), (column, rows - 1)]);
        let down = (1..rows - 1).flat_map(|row| [(0, row), (columns - 1, row)]);
        let border: Vec<(usize, usize)> = across.chain(down).collect();
        border.par_iter().for_each_init(Vec::new, |path, &(column, row)| {
            path.clear();
            geometry.trace(self.place(column, row), path);
            let at = row * columns + column;
            for (known, plane) in path.iter().zip(&self.depths) {
                plane.primitives[at].store(code(known), Ordering::Relaxed);
                if let Some(of_plane) = plane.blocked.get(at) {
                    of_plane.store(known.blocked, Ordering::Relaxed);
                }
            }
        });
    }

    /// Whether two samples see the same surfaces under the same lights.
    #[inline]
    pub fn are_same(&self, a: usize, b: usize) -> bool {
        self.depths.iter().all(|plane| {
            let primitive = |at: usize| plane.primitives[at].load(Ordering::Relaxed);
            let blocked =
                |at: usize| plane.blocked.get(at).map(|bits| bits.load(Ordering::Relaxed));
            primitive(a) == primitive(b) && blocked(a) == blocked(b)
        })
    }

    /// Whether two samples see the same surfaces: the same primitives, or some that are `continuous`.
    pub fn have_same_path(
        &self,
        a: usize,
        b: usize,
        continuous: impl Fn(u32, u32) -> bool,
    ) -> bool {
        self.depths.iter().all(|plane| {
            let [a, b] = [a, b].map(|at| plane.primitives[at].load(Ordering::Relaxed));
            let is_seen = |code: u32| code & !LEAVES != END;
            a == b || is_seen(a) && is_seen(b) && continuous(a & !LEAVES, b & !LEAVES)
        })
    }

    /// The path of a sample.
    pub fn path(&self, at: usize, path: &mut Vec<KnownHit>) {
        for plane in &self.depths {
            let primitive = plane.primitives[at].load(Ordering::Relaxed);
            if primitive == END {
                return;
            }
            let blocked = plane.blocked.get(at).map_or(0, |bits| bits.load(Ordering::Relaxed));
            path.push(decode(primitive, blocked));
        }
    }
}

/// How many surfaces the paths of a scene have at most.
pub fn depths<L: Plain>(integrator: &Integrator<'_, L>) -> usize {
    let layout = integrator.layout;
    let goes_on = integrator.zero_weight.mirrors || layout.has_mirrors || layout.has_transparency;
    if goes_on { layout.bounces as usize + 1 } else { 1 }
}
