//! The sky in parts, each of which lights surfaces as a distant light does.
//!
//! Direct light of an environment is that of so many distant lights, the same for all that is lit, each with
//! hard shadows whose edges are known: so images have no noise, and gradients hold with respect to everything
//! that moves a shadow, as with the points of [lights with an area](crate::transport::area_light). A part has
//! the power of its texels, and shines from its middle; cuts make the distance of the power from these middles
//! small (after Viriyothai & Debevec, "Variance Minimization Light Probe Sampling", 2009). Parts stay as they were
//! cut when the scene was prepared, while texels vary and the map turns. Where light takes all paths and gradients are to
//! be right on average, parts shine from points drawn at random. Turned down: directions drawn anew for
//! every point, whose shadows have no edges that anybody could follow; and the middle of the power of a part,
//! which moves with every texel, and its shadow with it.

use std::f64::consts::{PI, TAU};
use std::ops::Range;

use glam::DVec3;

use super::sampling::random_numbers;
use crate::scene::Texture;
use crate::transport::environment::direction_of;

/// What black texels count for beside the mean, so that they have parts of their own.
const SMALLEST: f64 = 1e-2;

/// Directions that are lit as if all of their light came from one.
#[derive(Clone, Debug, PartialEq)]
pub struct SkyPart {
    /// Where it is seen while the map is not turned; a unit vector.
    pub direction: DVec3,
    /// What it brings to a surface that faces it, where the radiance of the environment is 1.
    pub integral: DVec3,
    /// The mean cosine of the angles between its directions and that one, as often as the part counts; or one over
    /// the probability with which a cell was drawn.
    cosine: f64,
    cells: Cells,
    grid: Grid,
}

impl SkyPart {
    /// Takes over the texels of the map, if there is one.
    pub fn update(&mut self, map: Option<&Texture>) {
        let radiance = |texel: usize| map.map_or(DVec3::ONE, |map| map.texels.at(texel).into());
        self.integral = self.texels().map(|(texel, irradiance)| radiance(texel) * irradiance).sum();
    }

    /// The same part, which counts so often.
    pub fn times(self, count: f64) -> Self {
        Self { cosine: count * self.cosine, ..self }
    }

    /// Its texels, each with the irradiance that its radiance 1 brings to a surface that faces the part; some
    /// are told several times. A sky without a map has one texel.
    pub fn texels(&self) -> impl Iterator<Item = (usize, f64)> {
        let Self { cells: Cells { columns, rows }, grid, .. } = self;
        rows.clone().flat_map(move |row| {
            let irradiance = grid.solid_angle(row) * self.cosine;
            columns.clone().map(move |column| (grid.texel(column, row), irradiance))
        })
    }
}

/// Cells between meridians and parallels, so many to a texel.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Grid {
    /// Texels from left to right.
    width: u32,
    columns: u32,
    rows: u32,
    /// Columns and rows of cells to a texel.
    of_texel: [u32; 2],
}

impl Grid {
    /// At least eight times as many cells as parts, that none be without.
    fn new([width, height]: [u32; 2], parts: u32) -> Self {
        let side = 2 * (f64::from(parts).sqrt().ceil() as u32);
        let of_texel = [(2 * side).div_ceil(width), side.div_ceil(height)];
        let [across, down] = of_texel;
        Self { width, columns: width * across, rows: height * down, of_texel }
    }

    fn texel(&self, column: u32, row: u32) -> usize {
        let [across, down] = self.of_texel;
        (row / down) as usize * self.width as usize + (column / across) as usize
    }

    /// The angle of the middle of a row from +y.
    fn polar_angle(&self, row: u32) -> f64 {
        PI * (f64::from(row) + 0.5) / f64::from(self.rows)
    }

    /// The solid angle of the cells of a row: between the cosines of the angles at which it begins and ends.
    fn solid_angle(&self, row: u32) -> f64 {
        let half = 0.5 * PI / f64::from(self.rows);
        TAU / f64::from(self.columns) * 2.0 * self.polar_angle(row).sin() * half.sin()
    }
}

/// A rectangle of cells.
#[derive(Clone, Debug, PartialEq)]
struct Cells {
    columns: Range<u32>,
    rows: Range<u32>,
}

/// What cells come to together.
#[derive(Clone, Copy, Default)]
struct Moments {
    solid_angle: f64,
    /// The sum of the directions weighted by solid angles: it points to the middle.
    middle: DVec3,
    power: f64,
    /// The same weighted by powers.
    towards: DVec3,
}

impl Moments {
    /// The power times half of the mean squared distance of the directions from their middle, on the unit
    /// sphere.
    fn spread(&self) -> f64 {
        self.power - self.towards.dot(self.middle.normalize_or_zero())
    }

    fn plus(self, other: Self, times: f64) -> Self {
        Self {
            solid_angle: self.solid_angle + times * other.solid_angle,
            middle: self.middle + times * other.middle,
            power: self.power + times * other.power,
            towards: self.towards + times * other.towards,
        }
    }
}

/// A grid of cells with their powers.
struct Sky {
    grid: Grid,
    /// The power of each texel over its solid angle.
    texels: Vec<f64>,
    /// The sine and the cosine of the longitude of each column.
    columns: Vec<(f64, f64)>,
}

impl Sky {
    fn new(map: Option<&Texture>, parts: u32) -> Self {
        let size = map.map_or([1, 1], |map| [map.width, map.height]);
        let grid = Grid::new(size, parts);
        let mut texels: Vec<f64> = map
            .map_or(vec![1.0], |map| map.texels.iter().map(|texel| texel.iter().sum()).collect());
        let of_row = |row: u32| -> f64 {
            (0..grid.columns).map(|column| texels[grid.texel(column, row)]).sum()
        };
        let powers = (0..grid.rows).map(|row| of_row(row) * grid.solid_angle(row));
        let mean = powers.sum::<f64>() / (2.0 * TAU);
        let least = if mean > 0.0 { SMALLEST * mean } else { 1.0 };
        texels.iter_mut().for_each(|power| *power += least);
        let longitude =
            |column: u32| TAU * ((f64::from(column) + 0.5) / f64::from(grid.columns) - 0.5);
        let columns = (0..grid.columns).map(|column| longitude(column).sin_cos()).collect();
        Self { grid, texels, columns }
    }

    fn moments(&self, Cells { columns, rows }: &Cells) -> Moments {
        let mut sum = Moments::default();
        for row in rows.clone() {
            let (across, up) = self.grid.polar_angle(row).sin_cos();
            let solid_angle = self.grid.solid_angle(row);
            for column in columns.clone() {
                let (sine, cosine) = self.columns[column as usize];
                let middle = solid_angle * DVec3::new(across * sine, up, -across * cosine);
                let power = self.texels[self.grid.texel(column, row)];
                let (power, towards) = (power * solid_angle, power * middle);
                sum = sum.plus(Moments { solid_angle, middle, power, towards }, 1.0);
            }
        }
        sum
    }

    /// Cells as one light. Its direction is their middle, whatever their texels: it does not move with these.
    fn part(&self, Moments { solid_angle, middle, .. }: Moments, cells: Cells) -> SkyPart {
        let cosine = middle.length() / solid_angle;
        // All directions together have no middle; what faces a side sees a quarter of them, as it were.
        let direction = if cosine > 1e-6 { middle.normalize() } else { DVec3::Y };
        let (integral, grid) = (DVec3::ZERO, self.grid);
        SkyPart { direction, integral, cosine: cosine.max(0.25), cells, grid }
    }

    /// One of some cells of this power as a light for all of them, from a point of it: numbers from 0 to 1 choose both.
    fn drawn_part(&self, power: f64, cells: &Cells, [number, u, v]: [f64; 3]) -> SkyPart {
        let places =
            cells.rows.clone().flat_map(|row| cells.columns.clone().map(move |at| (at, row)));
        let mut left = number * power;
        let (mut chosen, mut probability) = ((cells.columns.start, cells.rows.start), 1.0);
        for (column, row) in places {
            let of_cell = self.texels[self.grid.texel(column, row)] * self.grid.solid_angle(row);
            (chosen, probability) = ((column, row), of_cell / power);
            left -= of_cell;
            if left <= 0.0 {
                break;
            }
        }
        let ((column, row), grid) = (chosen, self.grid);
        let turns = (f64::from(column) + u) / f64::from(grid.columns) - 0.5;
        let [inner, outer] =
            [row, row + 1].map(|at| 1.0 - (PI * f64::from(at) / f64::from(grid.rows)).cos());
        let direction = direction_of::<f64>([turns, inner + (outer - inner) * v, 1.0]);
        let cells = Cells { columns: column..column + 1, rows: row..row + 1 };
        SkyPart { direction, integral: DVec3::ZERO, cosine: probability.recip(), cells, grid }
    }

    /// Cuts cells, which come to `total`, in two, between columns or between rows, where the two are spread least;
    /// one cell cannot be cut.
    fn cut(&self, cells: &Cells, total: Moments) -> Option<[Cells; 2]> {
        let of_columns = |columns: Range<u32>| Cells { columns, rows: cells.rows.clone() };
        let of_rows = |rows: Range<u32>| Cells { columns: cells.columns.clone(), rows };
        let by_columns = self.cut_along(&cells.columns, total, of_columns);
        let by_rows = self.cut_along(&cells.rows, total, of_rows);
        let cuts = by_columns.into_iter().chain(by_rows);
        cuts.min_by(|(a, _), (b, _)| a.total_cmp(b)).map(|(_, cut)| cut)
    }

    /// The best cut between lines along a side, and how far the two are spread then; `part` are the cells of some
    /// of the lines.
    fn cut_along(
        &self,
        side: &Range<u32>,
        total: Moments,
        part: impl Fn(Range<u32>) -> Cells,
    ) -> Option<(f64, [Cells; 2])> {
        let mut before = Moments::default();
        let cuts = (side.start + 1..side.end).map(|at| {
            before = before.plus(self.moments(&part(at - 1..at)), 1.0);
            (before.spread() + total.plus(before, -1.0).spread(), at)
        });
        let (spread, at) = cuts.min_by(|(a, _), (b, _)| a.total_cmp(b))?;
        Some((spread, [part(side.start..at), part(at..side.end)]))
    }
}

/// The sky in so many parts: of a map, or of one that is the same everywhere. Their integrals are to be
/// [updated](SkyPart::update). Each shines from its middle, or, with a seed, from one of its points at random, about as
/// likely as it is bright: what parts bring is right on average then.
pub fn parts(map: Option<&Texture>, count: u32, seed: Option<u32>) -> Vec<SkyPart> {
    let sky = Sky::new(map, count);
    let measured = |cells: Cells| (sky.moments(&cells), cells);
    // A single cell is not spread, whatever rounding says.
    let spread = |(moments, cells): &(Moments, Cells)| match cells.columns.len() * cells.rows.len()
    {
        1 => f64::NEG_INFINITY,
        _ => moments.spread(),
    };
    let mut parts = vec![measured(Cells { columns: 0..sky.grid.columns, rows: 0..sky.grid.rows })];
    while parts.len() < count as usize {
        let by_spread = |&a: &usize, &b: &usize| spread(&parts[a]).total_cmp(&spread(&parts[b]));
        let widest = (0..parts.len()).max_by(by_spread).unwrap_or(0);
        let (moments, cells) = &parts[widest];
        let Some([first, second]) = sky.cut(cells, *moments) else { break };
        parts[widest] = measured(first);
        parts.push(measured(second));
    }
    let part = |(index, (moments, cells)): (u32, (Moments, Cells))| match seed {
        None => sky.part(moments, cells),
        Some(seed) => sky.drawn_part(moments.power, &cells, random_numbers(seed, index)),
    };
    (0..).zip(parts).map(part).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Wrap;

    fn map(width: u32, height: u32, radiance: impl Fn(u32, u32) -> f64) -> Texture {
        let texels = (0..height).flat_map(|row| (0..width).map(move |column| (column, row)));
        let texels: Vec<[f64; 3]> = texels.map(|(x, y)| [radiance(x, y); 3]).collect();
        Texture { name: String::new(), width, height, wrap: Wrap::Repeat, texels: texels.into() }
    }

    /// All of the sky is in the parts, once; each has a direction.
    #[test]
    fn parts_fill_the_sky() {
        let uneven = map(7, 5, |x, y| f64::from(x * x % 5 * y));
        let black = map(3, 1, |_, _| 0.0);
        for map in [None, Some(&uneven), Some(&black)] {
            for count in [1, 2, 3, 16, 64, 1000] {
                let parts = parts(map, count, None);
                assert_eq!(parts.len(), count as usize);
                let solid_angle =
                    |part: &SkyPart| part.texels().map(|(_, e)| e).sum::<f64>() / part.cosine;
                let total: f64 = parts.iter().map(solid_angle).sum();
                assert!((total / (2.0 * TAU) - 1.0).abs() < 1e-12, "{count}: {total}");
                assert!(parts.iter().all(|part| (part.direction.length() - 1.0).abs() < 1e-12));
            }
        }
    }

    /// The irradiance of an even sky on a plane that looks to any side is pi times the radiance.
    #[test]
    fn an_even_sky_lights_all_sides_alike() {
        let parts = parts(None, 64, None);
        for normal in [DVec3::X, DVec3::Y, DVec3::NEG_Z, DVec3::new(0.6, -0.64, 0.48)] {
            let irradiance = |part: &SkyPart| {
                let facing: f64 = part.texels().map(|(_, irradiance)| irradiance).sum();
                facing * part.direction.dot(normal).max(0.0)
            };
            let sum: f64 = parts.iter().map(irradiance).sum();
            assert!((sum / PI - 1.0).abs() < 0.03, "{normal}: {}", sum / PI);
        }
    }

    /// What points of parts bring is what the sky does, on average.
    #[test]
    fn points_of_parts_are_right_on_average() {
        let uneven = map(7, 5, |x, y| f64::from(x * x % 5 * y));
        let normal = DVec3::new(0.6, 0.64, 0.48);
        for map in [None, Some(&uneven)] {
            let irradiance = |mut part: SkyPart| {
                part.update(map);
                part.integral.x * part.direction.dot(normal).max(0.0)
            };
            let of = |count, seed| parts(map, count, seed).into_iter().map(irradiance).sum::<f64>();
            let (expected, seeds) = (of(4000, None), 4000);
            let mean = (0..seeds).map(|seed| of(5, Some(seed))).sum::<f64>() / f64::from(seeds);
            assert!((mean / expected - 1.0).abs() < 0.02, "{mean} {expected}");
            assert_ne!(of(5, Some(0)), of(5, Some(1)));
        }
    }

    /// A sun in a dark sky has most parts, and these look at it.
    #[test]
    fn parts_go_where_the_light_is() {
        let sun = map(64, 32, |x, y| if (x, y) == (48, 8) { 1e4 } else { 1e-3 });
        let parts = parts(Some(&sun), 16, None);
        // The middle of the texel.
        let (longitude, polar) = (TAU * (48.5 / 64.0 - 0.5), PI * 8.5 / 32.0);
        let towards =
            DVec3::new(polar.sin() * longitude.sin(), polar.cos(), -polar.sin() * longitude.cos());
        let holds_it = |part: &&SkyPart| part.texels().any(|(texel, _)| texel == 8 * 64 + 48);
        let directions = parts.iter().filter(holds_it).map(|part| part.direction.dot(towards));
        assert!(directions.clone().count() >= 1);
        assert!(
            directions.clone().all(|cosine| cosine > 0.998),
            "{:?}",
            directions.collect::<Vec<_>>()
        );
    }
}
