//! The image of a scene with the edges in it.

use glam::DVec3;
use rayon::prelude::*;

use super::cell::{Cell, Share, Side, Workspace};
use super::code::MOST_LIGHTS;
use super::crossing::{Crossing, Link, Path, Search};
use super::geometry::{Edge, Geometry};
use super::sight::{Sights, depths};
use crate::image::Image;
use crate::loss::PixelLoss;
use crate::number::Plain;
use crate::primal::image::by_rows;
use crate::primal::integrator::Integrator;
use crate::primal::known::{KnownHit, KnownPaths};
use crate::primal::lanes::vectors_of_lanes;
use crate::primal::path;
use crate::primal::wavefront::{Source, samples};
use crate::trace::bvh::PACKET_RAYS;
use crate::trace::tile::fill_strips;

/// How many crossings make a packet of paths, two each.
pub const PACKET_CROSSINGS: usize = PACKET_RAYS / 2;

/// An image, and the edges in it.
pub struct View {
    /// The radiance of the pixels, row by row: areas count on both sides of edges.
    pub pixels: Vec<DVec3>,
    pub crossings: Vec<Crossing>,
    pub shares: Vec<Share>,
    /// By crossing: the radiance on both sides.
    pub radiance: Vec<[DVec3; 2]>,
    hits: Vec<KnownHit>,
}

/// The crossings of the links that start in a row of samples.
struct Row {
    /// The links to the right and those downwards that have crossings: column and crossings.
    links: [Vec<(u32, u32, u32)>; 2],
    crossings: Vec<Crossing>,
    hits: Vec<KnownHit>,
}

impl Row {
    fn crossings(&self, axis: usize, column: usize) -> std::ops::Range<usize> {
        let links = &self.links[axis];
        match links.binary_search_by_key(&(column as u32), |link| link.0) {
            Ok(found) => links[found].1 as usize..links[found].2 as usize,
            Err(_) => 0..0,
        }
    }
}

impl View {
    /// The view of a scene, by a regular grid of rays.
    pub fn new<L: Plain>(integrator: Integrator<'_, L>) -> Self {
        let layout = integrator.layout;
        let side = layout.sampling.as_grid().count().isqrt() as usize;
        let has_lights = !layout.lights.is_empty();
        let depths = depths(&integrator);
        let sights = Sights::new(layout.width, layout.height, side, depths, has_lights);
        let geometry = Geometry::new(integrator);
        let mut pixels = trace(integrator, &sights);
        sights.keep_border(&geometry);

        let rows = (0..sights.rows).into_par_iter().map(|row| find(geometry, &sights, row));
        let rows: Vec<Row> = rows.collect();
        let mut starts = vec![0];
        for row in &rows {
            starts.push(starts[starts.len() - 1] + row.crossings.len());
        }
        let shares =
            (0..sights.rows - 1).into_par_iter().map_init(Workspace::default, |work, row| {
                shares(geometry, &sights, (&rows, &starts), row, work)
            });
        let shares: Vec<Vec<Share>> = shares.collect();
        let shares = shares.concat();
        let (mut crossings, mut hits) = (Vec::new(), Vec::new());
        for row in rows {
            let offset = hits.len() as u32;
            let moved = row.crossings.into_iter().map(|crossing| Crossing {
                sides: crossing.sides.map(|path| path.after(offset)),
                ..crossing
            });
            crossings.extend(moved);
            hits.extend(row.hits);
        }
        let mut view = Self { pixels: Vec::new(), crossings, shares, radiance: Vec::new(), hits };
        view.radiance = view.sides(integrator);
        for Share { crossing, pixel, areas, .. } in &view.shares {
            let [a, b] = view.radiance[*crossing as usize];
            pixels[*pixel as usize] += a * areas[0] + b * areas[1];
        }
        view.pixels = pixels;
        view
    }

    /// Writes the pixels over an image. Where areas are estimated from single crossings they may be a
    /// little too large; what falls below zero by that is black.
    ///
    /// # Panics
    ///
    /// If the image has another size.
    pub fn fill(&self, image: &mut Image) {
        assert_eq!(image.pixels.len(), self.pixels.len(), "the image has the size of the scene's");
        let pixels = image.pixels.iter_mut().zip(&self.pixels);
        pixels.for_each(|(to, &pixel)| {
            let pixel = DVec3::select(pixel.cmplt(DVec3::ZERO), DVec3::ZERO, pixel);
            *to = pixel.as_vec3().to_array();
        });
    }

    /// A loss of the pixels, which stand in rows of `width`.
    pub fn loss(&self, width: u32, loss: &dyn PixelLoss) -> f64 {
        let value = |(index, &radiance): (usize, &DVec3)| {
            let (x, y) = (index as u32 % width, index as u32 / width);
            loss.evaluate(x, y, radiance).0
        };
        self.pixels.iter().enumerate().map(value).sum()
    }

    /// The paths on both sides of crossings, the first ones and their others in turns.
    pub fn paths<L: Plain>(
        &self,
        geometry: &Geometry<'_, L>,
        crossings: &[Crossing],
        paths: &mut KnownPaths,
    ) {
        paths.clear();
        let lights = geometry.integrator.layout.lights.len().min(MOST_LIGHTS);
        for crossing in crossings {
            for side in crossing.sides {
                paths.push(geometry.film(crossing.place), side.of(&self.hits), lights);
            }
        }
    }

    /// The radiance on both sides of each crossing.
    fn sides<L: Plain>(&self, integrator: Integrator<'_, L>) -> Vec<[DVec3; 2]> {
        let geometry = Geometry::new(integrator);
        let start = || (KnownPaths::default(), path::Path::default());
        let packets =
            self.crossings.par_chunks(PACKET_CROSSINGS).map_init(start, |state, chunk| {
                let (known, path) = state;
                self.paths(&geometry, chunk, known);
                let mut radiance = vec![[DVec3::ZERO; 2]; chunk.len()];
                integrator.trace_path(Source::Known(known), path);
                let wavefronts = path.wavefronts();
                for group in &wavefronts[0].groups {
                    let vertex = integrator.vertex(group, &wavefronts[0], wavefronts.get(1));
                    let of_lanes = vectors_of_lanes::<L>(vertex.radiance());
                    for (lane, ray) in group.rays() {
                        radiance[ray / 2][ray % 2] = of_lanes[lane];
                    }
                }
                radiance
            });
        let packets: Vec<Vec<[DVec3; 2]>> = packets.collect();
        packets.concat()
    }
}

/// The mean radiance of the samples of each pixel; what they see is kept.
fn trace<L: Plain>(integrator: Integrator<'_, L>, sights: &Sights) -> Vec<DVec3> {
    let layout = integrator.layout;
    let grid = layout.sampling.as_grid();
    let mut pixels = vec![DVec3::ZERO; layout.width as usize * layout.height as usize];
    fill_strips(layout.width, &mut pixels, path::Path::default, |path, strip, rows| {
        for tile in strip.tiles() {
            let mut total = [DVec3::ZERO; PACKET_RAYS];
            for (index, sample) in samples(&tile, grid).enumerate() {
                integrator.trace_path(sample, path);
                let wavefronts = path.wavefronts();
                sights.keep(&tile, index as u32, wavefronts);
                for group in &wavefronts[0].groups {
                    let vertex = integrator.vertex(group, &wavefronts[0], wavefronts.get(1));
                    let of_lanes = vectors_of_lanes::<L>(vertex.radiance());
                    group.rays().for_each(|(lane, ray)| total[ray] += of_lanes[lane]);
                }
            }
            let pixels = by_rows(|ray| total[ray] / f64::from(grid.count()));
            for (row, pixels) in rows.iter_mut().zip(&pixels) {
                row[strip.columns(&tile)].copy_from_slice(&pixels[..tile.columns]);
            }
        }
    });
    pixels
}

/// The crossings of the links that start in a row of samples.
fn find<L: Plain>(geometry: Geometry<'_, L>, sights: &Sights, row: usize) -> Row {
    let mut search = Search::new(geometry);
    let mut links = [Vec::new(), Vec::new()];
    let length = 1.0 / sights.side as f64;
    for column in 0..sights.columns {
        let at = row * sights.columns + column;
        let mut first: Option<Path> = None;
        let others = [
            (column + 1 < sights.columns).then_some(at + 1),
            (row + 1 < sights.rows).then_some(at + sights.columns),
        ];
        for (axis, other) in others.into_iter().enumerate() {
            let Some(other) = other.filter(|&other| !sights.are_same(at, other)) else { continue };
            let first = *first.get_or_insert_with(|| search.path(|hits| sights.path(at, hits)));
            let last = search.path(|hits| sights.path(other, hits));
            let start = search.crossings.len() as u32;
            search.link(&Link { start: sights.place(column, row), axis, length }, first, last);
            let end = search.crossings.len() as u32;
            if end > start {
                links[axis].push((column as u32, start, end));
            }
        }
    }
    Row { links, crossings: search.crossings, hits: search.hits }
}

/// What the cells below a row of samples give to pixels.
fn shares<'a, L: Plain>(
    geometry: Geometry<'_, L>,
    sights: &Sights,
    (rows, starts): (&'a [Row], &[usize]),
    row: usize,
    work: &mut Workspace<'a>,
) -> Vec<Share> {
    let layout = geometry.integrator.layout;
    let length = 1.0 / sights.side as f64;
    let crossings_of = |row: usize, axis: usize, column: usize| {
        let found = rows.get(row).map_or(0..0, |row| row.crossings(axis, column));
        (found, row)
    };
    let sides_of = |row: usize, column: usize| {
        [
            crossings_of(row, 0, column),
            crossings_of(row, 1, column + 1),
            crossings_of(row + 1, 0, column),
            crossings_of(row, 1, column),
        ]
    };
    let is_quiet = |[x, y]: [f64; 2]| {
        let index = |along: f64| (along / length + 0.5).floor();
        let (column, row) = (index(x), index(y));
        column < 0.0
            || row < 0.0
            || sides_of(row as usize, column as usize).iter().all(|(found, _)| found.is_empty())
    };
    let adjacent = |a: Edge, b: Edge| match (a, b) {
        (Edge::Segment(a), Edge::Segment(b)) => {
            let same = |&(a, b): &(u32, u32)| a == b || geometry.vertex(a) == geometry.vertex(b);
            let pairs = [(a[0], b[0]), (a[0], b[1]), (a[1], b[0]), (a[1], b[1])];
            pairs.iter().filter(|pair| same(pair)).count() == 1
        }
        _ => false,
    };
    let continuous = |a: u32, b: u32| geometry.are_continuous(a, b);
    let columns_of = |links: &[(u32, u32, u32)]| -> Vec<usize> {
        links.iter().map(|link| link.0 as usize).collect()
    };
    let mut columns = columns_of(&rows[row].links[0]);
    columns.extend(columns_of(&rows[row + 1].links[0]));
    for column in columns_of(&rows[row].links[1]) {
        columns.extend([column, column.wrapping_sub(1)]);
    }
    columns.retain(|&column| column < sights.columns - 1);
    columns.sort_unstable();
    columns.dedup();

    let (mut found, mut sides) = (Vec::new(), Vec::new());
    for column in columns {
        sides.clear();
        for (of, (range, row)) in sides_of(row, column).into_iter().enumerate() {
            sides.extend(range.map(|index| Side {
                index: (starts[row] + index) as u32,
                crossing: &rows[row].crossings[index],
                of,
            }));
        }
        let samples = [(column, row), (column + 1, row), (column + 1, row + 1), (column, row + 1)];
        let at = |(column, row): (usize, usize)| row * sights.columns + column;
        let cell = Cell {
            start: sights.place(column, row),
            length,
            pixels: samples.map(|(column, row)| sights.pixel(column, row)),
            is_uniform: samples[1..]
                .iter()
                .all(|&sample| sights.have_same_path(at(samples[0]), at(sample), continuous)),
            size: [layout.width, layout.height],
            adjacent: &adjacent,
            is_quiet: &is_quiet,
        };
        cell.shares(&sides, work, &mut found);
    }
    found
}
