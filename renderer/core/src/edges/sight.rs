//! What the samples of an image see: the paths that they met, and which lights were blocked there.

use super::code::{END, LEAVES, decode, decode_packet};
use super::geometry::Geometry;
use super::links::{COLUMNS, Links};
use super::projection::Projection;
use super::turned::AllTurned;
use crate::primal::frame::Seen;
use crate::primal::known::{KnownHit, KnownPaths};
use crate::trace::bvh::{PACKET_RAYS, ray_at};
use crate::trace::tile::Tile;

/// The path of every sample of a regular grid, and of one more row and column of samples on each side of
/// the image. They are [recorded](super::record) while rays are traced.
pub struct Sights {
    /// How many samples stand side by side in a pixel.
    pub side: usize,
    pub columns: usize,
    pub rows: usize,
    /// How many lights have shadows with edges.
    pub(super) lights: usize,
    pub(super) depths: Vec<Seen>,
}

impl Sights {
    /// Where a sample is, in pixels from the upper left corner of the image.
    pub fn place(&self, column: usize, row: usize) -> [f64; 2] {
        [column, row].map(|index| (index as f64 - 0.5) / self.side as f64)
    }

    /// The index of the link that starts at a sample, row by row, to the right before downwards.
    pub fn link(&self, [column, row]: [usize; 2], axis: usize) -> usize {
        2 * (row * self.columns + column) + axis
    }

    /// The sample that a link starts at, its column and its row, and its axis.
    pub fn start_of(&self, link: usize) -> ([usize; 2], usize) {
        let sample = link / 2;
        ([sample % self.columns, sample / self.columns], link % 2)
    }

    /// The pixel of a sample, unless it is outside of the image.
    pub fn pixel(&self, column: usize, row: usize) -> Option<u32> {
        let is_inside =
            (1..self.columns - 1).contains(&column) && (1..self.rows - 1).contains(&row);
        let width = (self.columns - 2) / self.side;
        is_inside.then(|| ((row - 1) / self.side * width + (column - 1) / self.side) as u32)
    }

    /// The samples of a tile, those with this index of the rays of their pixels: rays and places.
    pub(super) fn of_tile(
        &self,
        tile: &Tile,
        index: u32,
    ) -> impl Iterator<Item = (usize, usize)> + use<> {
        let (side, columns, tile) = (self.side, self.columns, *tile);
        let (right, down) = (index as usize % side, index as usize / side);
        (0..tile.rows).flat_map(move |row| {
            let first =
                ((tile.top + row) * side + down + 1) * columns + tile.left * side + right + 1;
            (0..tile.columns).map(move |column| (ray_at(column, row), first + column * side))
        })
    }

    /// The paths of the samples of a tile, one of each pixel, as they were kept.
    pub fn paths(&self, tile: &Tile, index: u32, paths: &mut KnownPaths) {
        paths.clear();
        for seen in &self.depths {
            let mut codes = [END; PACKET_RAYS];
            self.of_tile(tile, index).for_each(|(ray, at)| codes[ray] = seen.primitives[at]);
            if codes.iter().all(|&code| code == END) {
                return;
            }
            let known = paths.next_depth(self.lights);
            (known.hits.primitive, known.hits.leaves) = decode_packet(&codes);
            for (light, blocked) in known.blocked.iter_mut().enumerate() {
                let bit = |(ray, at): (usize, usize)| (seen.blocked[at] >> light & 1) << ray;
                *blocked = self.of_tile(tile, index).map(bit).sum();
            }
        }
    }

    /// The links that start in a row of samples and whose ends see other surfaces, or lights.
    pub fn differences(&self, row: usize, differ: &mut Vec<Links>) {
        differ.clear();
        differ.resize(self.columns.div_ceil(COLUMNS), [0; 2]);
        for seen in &self.depths {
            self.compare(&seen.primitives, row, differ);
            self.compare(&seen.blocked, row, differ);
            self.compare(&seen.filters, row, differ);
        }
    }

    fn compare<T: PartialEq>(&self, values: &[T], row: usize, differ: &mut [Links]) {
        let start = row * self.columns;
        let Some(values) = values.get(start..) else { return };
        let (values, below) = values.split_at(self.columns.min(values.len()));
        let beside = values.get(1..).unwrap_or_default();
        for (axis, others) in [beside, below].into_iter().enumerate() {
            let chunks = values.chunks(COLUMNS).zip(others.chunks(COLUMNS));
            for (links, (values, others)) in differ.iter_mut().zip(chunks) {
                let pairs = values.iter().zip(others).enumerate();
                links[axis] |= pairs.fold(0, |bits, (at, (a, b))| bits | u64::from(a != b) << at);
            }
        }
    }

    /// Whether nothing changes between two neighbouring samples that differ, at these places: their paths end at
    /// triangles of a smooth surface in the same light. On finely tessellated meshes most links are such.
    pub fn are_over_surface(
        &self,
        [a, b]: [usize; 2],
        places: [[f64; 2]; 2],
        projection: &Projection<'_>,
        turned: &AllTurned<'_>,
    ) -> bool {
        let Some((first, others)) = self.depths.split_first() else { return false };
        let have_ended = |at: usize| others.first().is_none_or(|seen| seen.primitives[at] == END);
        let [of_a, of_b] = [a, b].map(|at| first.hit(at));
        have_ended(a)
            && have_ended(b)
            && (of_a.blocked, of_a.filters) == (of_b.blocked, of_b.filters)
            && projection.leads_smoothly([of_a.primitive, of_b.primitive], places, |triangle| {
                Some(turned.of(triangle)).filter(|turned| turned.lights & !of_a.blocked == 0)
            })
    }

    /// Whether two samples see the same surfaces: the same primitives, or parts of smooth ones.
    pub fn have_same_path(&self, a: usize, b: usize, geometry: &Geometry<'_>) -> bool {
        self.depths.iter().all(|seen| {
            let [a, b] = [a, b].map(|at| seen.primitives[at]);
            a == b || geometry.are_continuous(a & !LEAVES, b & !LEAVES)
        })
    }

    /// The path of a sample.
    pub fn hits(&self, at: usize) -> impl Iterator<Item = KnownHit> {
        let depths = self.depths.iter().take_while(move |seen| seen.primitives[at] != END);
        depths.map(move |seen| seen.hit(at))
    }
}

impl Seen {
    #[inline]
    fn hit(&self, at: usize) -> KnownHit {
        let blocked = self.blocked.get(at).copied().unwrap_or(0);
        let filters = self.filters.get(at).copied().unwrap_or(0);
        KnownHit { blocked, filters, ..decode(self.primitives[at]) }
    }
}
