//! The recording of what samples see, by the threads that trace them.

use std::sync::atomic::Ordering::Relaxed;
use std::sync::atomic::{AtomicU32, AtomicU64};

use super::code::{END, code, code_packet};
use super::geometry::Geometry;
use super::sight::Sights;
use crate::number::Plain;
use crate::parallel;
use crate::primal::frame::Seen;
use crate::primal::integrator::Integrator;
use crate::primal::known::KnownHit;
use crate::primal::path::Path;
use crate::primal::wavefront::{Wavefront, samples};
use crate::trace::layout::Layout;
use crate::trace::tile::{Tile, for_each_strip};

/// How many samples around the image are traced one after the other.
const BORDER_CHUNK: usize = 64;

/// What the samples of an image see, as far as they are traced.
pub struct Recording {
    /// Without anything seen.
    sights: Sights,
    depths: Vec<Atoms>,
}

/// What the samples see at one depth.
struct Atoms {
    primitives: Vec<AtomicU32>,
    blocked: Vec<AtomicU64>,
    filters: Vec<AtomicU32>,
}

impl Recording {
    /// Of what the samples of the image of a scene see, by the regular grid of its rays, in memory that is used again.
    pub fn new(geometry: &Geometry<'_>, mut memory: Vec<Seen>) -> Self {
        let layout = geometry.layout;
        let side = layout.sampling.grid_side() as usize;
        let (columns, rows) = (layout.width as usize * side + 2, layout.height as usize * side + 2);
        let samples = columns * rows;
        let lights = geometry.edged_lights();
        let with_lights = if lights == 0 { 0 } else { samples };
        let with_filters = if layout.has_transparency { with_lights } else { 0 };
        memory.resize_with(geometry.zero_weight.depths(layout), Seen::default);
        let of_depth = |seen: Seen| Atoms {
            primitives: atoms(seen.primitives, samples, AtomicU32::new),
            blocked: atoms(seen.blocked, with_lights, AtomicU64::new),
            filters: atoms(seen.filters, with_filters, AtomicU32::new),
        };
        let sights = Sights { side, columns, rows, lights, depths: Vec::new() };
        Self { sights, depths: memory.into_iter().map(of_depth).collect() }
    }

    /// What the samples of a scene see, traced and not shaded.
    pub fn traced<L: Plain>(geometry: &Geometry<'_>, integrator: Integrator<'_, L>) -> Sights {
        let recording = Self::new(geometry, Vec::new());
        let Layout { width, height, sampling, .. } = integrator.layout;
        for_each_strip(*width, *height, Path::default, |path, strip| {
            for tile in strip.tiles() {
                for (index, sample) in samples(&tile, sampling.as_grid()).enumerate() {
                    integrator.trace_path(sample, path);
                    recording.keep(&tile, index as u32, path.wavefronts());
                }
            }
        });
        recording.finish(geometry)
    }

    /// Keeps what the samples of a tile see, one of each pixel.
    pub fn keep<L: Plain>(&self, tile: &Tile, index: u32, wavefronts: &[Wavefront<L>]) {
        for (depth, atoms) in self.depths.iter().enumerate() {
            let samples = || self.sights.of_tile(tile, index);
            let Some(Wavefront { hits, missed, blocked, filters, .. }) = wavefronts.get(depth)
            else {
                samples().for_each(|(_, at)| atoms.keep(at, None));
                continue;
            };
            let seen = hits.met() | missed;
            let codes = code_packet(hits, seen);
            samples().for_each(|(ray, at)| atoms.primitives[at].store(codes[ray], Relaxed));
            if !atoms.blocked.is_empty() {
                let lights = &blocked[..self.sights.lights];
                samples().for_each(|(ray, at)| {
                    let bit = |(light, bits): (usize, &u64)| ((bits & seen) >> ray & 1) << light;
                    atoms.blocked[at].store(lights.iter().enumerate().map(bit).sum(), Relaxed);
                });
            }
            if !atoms.filters.is_empty() {
                for (ray, at) in samples() {
                    let filters = filters.get(ray).filter(|_| seen >> ray & 1 == 1);
                    atoms.filters[at].store(filters.copied().unwrap_or(0), Relaxed);
                }
            }
        }
    }

    /// What all samples see, with those around the image.
    pub fn finish(self, geometry: &Geometry<'_>) -> Sights {
        let Self { sights, depths } = self;
        let Sights { columns, rows, .. } = sights;
        let across = (0..columns).flat_map(|column| [(column, 0), (column, rows - 1)]);
        let down = (1..rows - 1).flat_map(|row| [(0, row), (columns - 1, row)]);
        let border: Vec<(usize, usize)> = across.chain(down).collect();
        parallel::map_init(border.chunks(BORDER_CHUNK).collect(), Vec::new, |path, samples| {
            for &(column, row) in samples {
                path.clear();
                geometry.trace(sights.place(column, row), path);
                for (depth, atoms) in depths.iter().enumerate() {
                    atoms.keep(row * columns + column, path.get(depth));
                }
            }
        });
        Sights { depths: depths.into_iter().map(Atoms::seen).collect(), ..sights }
    }
}

impl Atoms {
    /// Keeps what a sample sees, or that its path has ended.
    fn keep(&self, at: usize, known: Option<&KnownHit>) {
        self.primitives[at].store(known.map_or(END, code), Relaxed);
        if let Some(blocked) = self.blocked.get(at) {
            blocked.store(known.map_or(0, |known| known.blocked), Relaxed);
        }
        if let Some(filters) = self.filters.get(at) {
            filters.store(known.map_or(0, |known| known.filters), Relaxed);
        }
    }

    fn seen(self) -> Seen {
        Seen {
            primitives: self.primitives.into_iter().map(AtomicU32::into_inner).collect(),
            blocked: self.blocked.into_iter().map(AtomicU64::into_inner).collect(),
            filters: self.filters.into_iter().map(AtomicU32::into_inner).collect(),
        }
    }
}

/// So many numbers that threads may write to, in the memory of others.
fn atoms<T: Clone + Default, A>(mut memory: Vec<T>, count: usize, atom: fn(T) -> A) -> Vec<A> {
    memory.resize(count, T::default());
    memory.into_iter().map(atom).collect()
}
