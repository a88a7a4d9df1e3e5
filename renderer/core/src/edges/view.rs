//! The image of a scene with the edges in it.

use std::ops::Range;

use glam::DVec3;

use super::band::{BAND, Band};
use super::cell::{Cell, FARTHEST_CORNER, Share, Side, Workspace};
use super::geometry::{Edge, Geometry};
use super::links::COLUMNS;
use super::projection::Projection;
use super::record::Recording;
use super::sight::Sights;
use super::slender::Slender;
use super::turned::AllTurned;
use crate::image::Image;
use crate::loss::PixelLoss;
use crate::number::Plain;
use crate::parallel::{self, Idle};
use crate::primal::frame::Frame;
use crate::primal::image::mean_traced;
use crate::primal::integrator::Integrator;
use crate::primal::known::KnownPaths;
use crate::primal::path::Path;
use crate::primal::rounds::Round;
use crate::trace::bvh::rays;
use crate::trace::tile::fill_tiles;

/// How many rows of pixels are added up at a time.
const PIXEL_ROWS: usize = 32;

/// An image, and the edges in it.
pub struct View {
    /// The radiance of the pixels, row by row: areas count on both sides of edges. Where areas are estimated from
    /// single crossings they may be a little too large; what falls below zero by that is black, to losses, too, while
    /// its derivative is that of the estimate. None where light takes all paths.
    pub pixels: Vec<DVec3>,
    pub sights: Sights,
    pub bands: Vec<Band>,
    /// By band: the index of its first crossing among all, then the number of all.
    firsts: Vec<usize>,
    /// By band: what its cells give to pixels.
    shares: Vec<Vec<Share>>,
}

impl View {
    /// The view of a scene, by a regular grid of rays.
    pub fn new<L: Plain>(geometry: &Geometry<'_>, integrator: Integrator<'_, L>) -> Self {
        let layout = integrator.layout;
        let Frame { mut pixels, depths } = integrator.frames.take().unwrap_or_default();
        pixels.resize(layout.width as usize * layout.height as usize, DVec3::ZERO);
        let recording = Recording::new(geometry, depths);
        fill_tiles(layout.width, &mut pixels, Path::default, |path, tile| {
            let grid = layout.sampling.as_grid();
            let keep = |index, path: &Path<L>| recording.keep(tile, index, path.wavefronts());
            let radiance = mean_traced(integrator, tile, grid, path, keep);
            move |ray| radiance[ray]
        });
        let view = Self::of(geometry, integrator, recording.finish(geometry));
        view.add_shares(layout.width, &mut pixels, |band, crossing, share| {
            let [a, b] = view.bands[band].radiance[crossing];
            a * share.areas[0] + b * share.areas[1]
        });
        if !layout.pass.is_signed() {
            let none_below =
                |pixel: DVec3| DVec3::select(pixel.cmplt(DVec3::ZERO), DVec3::ZERO, pixel);
            pixels.iter_mut().for_each(|pixel| *pixel = none_below(*pixel));
        }
        Self { pixels, ..view }
    }

    /// The edges of a scene in `direct` light, without pixels, where light takes all `paths`: what those of a round
    /// bring is on both sides of the edges of surfaces that the camera sees first.
    pub fn of_paths<L: Plain>(
        geometry: &Geometry<'_>,
        direct: Integrator<'_, L>,
        paths: Integrator<'_, L>,
        round: Round,
    ) -> Self {
        let mut view = Self::of(geometry, direct, Recording::traced(geometry, direct));
        let start = || (KnownPaths::default(), Path::default());
        let length = 1.0 / view.sights.side as f64;
        let bands = view.bands.iter_mut().enumerate().collect();
        parallel::map_init(bands, start, |scratch, (index, band): (usize, &mut Band)| {
            band.scatter(geometry, (paths, round), (index, length), scratch);
        });
        view
    }

    /// Leaves its memory to the next view of the scene.
    pub fn recycle(self, frames: &Idle<Frame>) {
        let Self { pixels, sights, .. } = self;
        frames.give(Frame { pixels, depths: sights.depths });
    }

    /// The view of what samples see, without pixels.
    fn of<L: Plain>(
        geometry: &Geometry<'_>,
        integrator: Integrator<'_, L>,
        sights: Sights,
    ) -> Self {
        let (projection, turned) = (Projection::new(geometry), AllTurned::new(geometry));
        let slender = Slender::new(geometry, &projection, &sights);
        let start = || (KnownPaths::default(), Path::default());
        let bands = (0..sights.rows.div_ceil(BAND)).collect();
        let bands = parallel::map_init(bands, start, |scratch, band| {
            let known = (&projection, &slender, &turned);
            let mut band = Band::new(geometry, &sights, known, band);
            band.shade(geometry, integrator, scratch);
            band
        });

        let mut firsts = vec![0];
        for band in &bands {
            firsts.push(firsts[firsts.len() - 1] + band.crossings.len());
        }
        let mut view = Self { pixels: Vec::new(), sights, bands, firsts, shares: Vec::new() };
        let bands = (0..view.bands.len()).collect();
        view.shares = parallel::map_init(bands, Workspace::default, |scratch, band| {
            view.shares(geometry, band, scratch)
        });
        view
    }

    /// Adds to pixels, which stand in rows of `width`, what shares give them, by the band of their
    /// crossing and by its index there.
    pub fn add_shares(
        &self,
        width: u32,
        pixels: &mut [DVec3],
        given: impl Fn(usize, usize, &Share) -> DVec3 + Sync,
    ) {
        let per_chunk = PIXEL_ROWS * width as usize;
        let chunks = pixels.chunks_mut(per_chunk).enumerate().collect();
        parallel::map(chunks, |(chunk, pixels): (usize, &mut [DVec3])| {
            let first = chunk * per_chunk;
            // Those of the cells around the pixels: corners may be outside of their cell.
            let rows = self.sights.side * PIXEL_ROWS;
            let margin = FARTHEST_CORNER.ceil() as usize + 2;
            let start = (chunk * rows).saturating_sub(margin) / BAND;
            let end = ((chunk + 1) * rows + margin).div_ceil(BAND).min(self.shares.len());
            for band in start..end {
                for share in &self.shares[band] {
                    let place = (share.pixel as usize).wrapping_sub(first);
                    if let Some(pixel) = pixels.get_mut(place) {
                        let (band, crossing) = self.place_of(band, share);
                        *pixel += given(band, crossing, share);
                    }
                }
            }
        });
    }

    /// The shares of the crossings of a band, with their indices there.
    pub fn shares_of(&self, band: usize) -> impl Iterator<Item = (usize, &Share)> {
        let own = self.firsts[band]..self.firsts[band + 1];
        // Cells have crossings of the row of samples below them, too.
        let lists = &self.shares[band.saturating_sub(1)..=band];
        lists.iter().flatten().filter_map(move |share| {
            let crossing = share.crossing as usize;
            own.contains(&crossing).then(|| (crossing - own.start, share))
        })
    }

    /// The band of the crossing of a share of the cells of a band, and its index there.
    fn place_of(&self, band: usize, share: &Share) -> (usize, usize) {
        let crossing = share.crossing as usize;
        let band = if crossing < self.firsts[band + 1] { band } else { band + 1 };
        (band, crossing - self.firsts[band])
    }

    /// Writes the pixels over an image.
    ///
    /// # Panics
    ///
    /// If the image has another size.
    pub fn fill(&self, image: &mut Image) {
        assert_eq!(image.pixels.len(), self.pixels.len(), "the image has the size of the scene's");
        let pixels = image.pixels.iter_mut().zip(&self.pixels);
        pixels.for_each(|(to, pixel)| *to = pixel.as_vec3().to_array());
    }

    /// A loss of the pixels, which stand in rows of `width`.
    pub fn loss(&self, width: u32, loss: &dyn PixelLoss) -> f64 {
        let value = |(index, &radiance): (usize, &DVec3)| {
            let (x, y) = (index as u32 % width, index as u32 / width);
            loss.evaluate(x, y, radiance).0
        };
        self.pixels.iter().enumerate().map(value).sum()
    }

    /// The crossings of a link, by the band that it starts in.
    fn of_link(&self, row: usize, column: usize, axis: usize) -> (usize, Range<usize>) {
        let band = row / BAND;
        (band, self.bands[band].starts.of_link(row % BAND, column, axis))
    }

    /// The cells of a set of columns with crossings on their sides: a bit for each.
    fn cells(&self, row: usize, set: usize) -> u64 {
        let links = |row: usize, set: usize| self.bands[row / BAND].starts.links(row % BAND, set);
        let ([right, down], [_, next]) = (links(row, set), links(row, set + 1));
        let [below, _] = links(row + 1, set);
        right | below | down | down >> 1 | next << (COLUMNS - 1)
    }

    /// What the cells below the rows of samples of a band give to pixels.
    fn shares<'a>(
        &'a self,
        geometry: &Geometry<'_>,
        band: usize,
        work: &mut Workspace<'a>,
    ) -> Vec<Share> {
        let (sights, layout) = (&self.sights, geometry.layout);
        let length = 1.0 / sights.side as f64;
        let is_quiet = |[x, y]: [f64; 2]| {
            let index = |along: f64| (along / length + 0.5).floor();
            let (column, row) = (index(x), index(y));
            let cells = [sights.columns - 1, sights.rows - 1].map(|cells| cells as f64);
            let is_cell = column >= 0.0 && row >= 0.0 && column < cells[0] && row < cells[1];
            let (column, row) = (column as usize, row as usize);
            !is_cell || self.cells(row, column / COLUMNS) >> (column % COLUMNS) & 1 == 0
        };
        let adjacent = |a: Edge, b: Edge| geometry.are_adjacent(a, b);
        let mut found = Vec::new();
        let mut sides = Vec::new();
        for row in band * BAND..((band + 1) * BAND).min(sights.rows - 1) {
            let cells = 0..sights.columns - 1;
            let sets = cells.clone().step_by(COLUMNS);
            let with_crossings = sets
                .flat_map(|start| rays(self.cells(row, start / COLUMNS)).map(move |at| start + at));
            for column in with_crossings.filter(|column| cells.contains(column)) {
                sides.clear();
                let links = [
                    (row, column, 0),
                    (row, column + 1, 1),
                    (row + 1, column, 0),
                    (row, column, 1),
                ];
                for (of, (row, column, axis)) in links.into_iter().enumerate() {
                    let (band, crossings) = self.of_link(row, column, axis);
                    sides.extend(crossings.map(|index| Side {
                        index: (self.firsts[band] + index) as u32,
                        crossing: &self.bands[band].crossings[index],
                        of,
                    }));
                }
                let samples =
                    [(column, row), (column + 1, row), (column + 1, row + 1), (column, row + 1)];
                let is_uniform = || {
                    let [first, others @ ..] =
                        samples.map(|(column, row)| row * sights.columns + column);
                    let same = |&other: &usize| sights.have_same_path(first, other, geometry);
                    others.iter().all(same)
                };
                let cell = Cell {
                    start: sights.place(column, row),
                    length,
                    pixels: samples.map(|(column, row)| sights.pixel(column, row)),
                    is_uniform: &is_uniform,
                    size: [layout.width, layout.height],
                    adjacent: &adjacent,
                    is_quiet: &is_quiet,
                };
                cell.shares(&sides, work, &mut found);
            }
        }
        found
    }
}
