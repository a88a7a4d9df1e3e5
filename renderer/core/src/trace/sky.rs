//! The directions around a scene in cells, one of which is chosen.

use std::f64::consts::{PI, TAU};

/// The directions around a scene, in cells between meridians and parallels. Within a cell directions are
/// chosen evenly by solid angle, so that the density is piecewise constant, also at the poles.
///
/// Cells stand still while a map of the radiance turns over them, and their powers change in steps alone: so
/// chosen directions do not move with what the map is made of.
#[derive(Debug)]
pub struct Sky {
    columns: u32,
    rows: u32,
    /// The bits of the numbers of columns and of rows.
    bits: [u32; 2],
    /// One minus the cosines of the angles from a pole at which rows begin, and the last one ends.
    versines: Vec<f64>,
}

impl Sky {
    pub fn new(columns: u32, rows: u32) -> Self {
        let versines = (0..=rows).map(|row| {
            let sine = (0.5 * PI * f64::from(row) / f64::from(rows)).sin();
            2.0 * sine * sine
        });
        let bits = [columns, rows].map(|count| count.next_power_of_two().trailing_zeros());
        Self { columns, rows, bits, versines: versines.collect() }
    }

    /// How many ranks there are, more than cells where their numbers are no powers of two.
    pub fn ranks(&self) -> u32 {
        1 << (self.bits[0] + self.bits[1])
    }

    /// The column and the row of the cell of a rank, in the order in which cells are chosen from: neighbours
    /// stand close together (Morton 1966), so that even numbers choose cells that are even in both directions.
    #[inline]
    pub fn cell(&self, rank: u32) -> (u32, u32) {
        let [columns, rows] = self.bits;
        let shared = columns.min(rows);
        let (low, high) = (rank & ((1 << (2 * shared)) - 1), rank >> (2 * shared) << shared);
        let (column, row) = (compact(low), compact(low >> 1));
        if columns > rows { (column | high, row) } else { (column, row | high) }
    }

    /// The cell of a rank, if there is one.
    pub fn cell_at(&self, rank: u32) -> Option<(u32, u32)> {
        Some(self.cell(rank)).filter(|&(column, row)| column < self.columns && row < self.rows)
    }

    /// The rank of a cell.
    #[inline]
    fn rank(&self, (column, row): (u32, u32)) -> u32 {
        let shared = self.bits[0].min(self.bits[1]);
        let low = (1 << shared) - 1;
        let high = (column | row) >> shared << (2 * shared);
        spread(column & low) | spread(row & low) << 1 | high
    }

    /// The rank of the cell at a place on the map, from 0 to 1 to the right and upwards, and its row.
    #[inline]
    pub fn rank_at(&self, [u, v]: [f64; 2]) -> (u32, u32) {
        let index = |part: f64, count: u32| ((part * f64::from(count)) as u32).min(count - 1);
        let (column, row) = (index(u, self.columns), index(1.0 - v, self.rows));
        (self.rank((column, row)), row)
    }

    /// The solid angle of the cells of a row.
    pub fn solid_angle(&self, row: u32) -> f64 {
        let (_, [inner, outer]) = self.versines(row);
        TAU / f64::from(self.columns) * (outer - inner)
    }

    /// The [direction](crate::transport::environment::direction_of()) in a cell that two numbers from 0 to 1
    /// choose.
    #[inline]
    pub fn place(&self, (column, row): (u32, u32), [u, v]: [f64; 2]) -> [f64; 3] {
        let (pole, [inner, outer]) = self.versines(row);
        let turns = (f64::from(column) + u) / f64::from(self.columns) - 0.5;
        [turns, inner + (outer - inner) * v, pole]
    }

    /// The nearer pole of a row, 1 for +y, and one minus the cosines of the angles from there at which it
    /// begins and ends: cosines lose small angles to rounding.
    fn versines(&self, row: u32) -> (f64, [f64; 2]) {
        let (pole, row) = match row < self.rows / 2 {
            true => (1.0, row),
            false => (-1.0, self.rows - 1 - row),
        };
        (pole, [self.versines[row as usize], self.versines[row as usize + 1]])
    }
}

/// The bits of a number below 65,536, with room between them.
#[inline]
fn spread(x: u32) -> u32 {
    [(8, 0x00ff_00ff), (4, 0x0f0f_0f0f), (2, 0x3333_3333), (1, 0x5555_5555)]
        .iter()
        .fold(x, |x, &(shift, mask)| (x | x << shift) & mask)
}

/// Every second bit of a number, without the room between them.
#[inline]
fn compact(x: u32) -> u32 {
    [(1, 0x3333_3333), (2, 0x0f0f_0f0f), (4, 0x00ff_00ff), (8, 0x0000_ffff)]
        .iter()
        .fold(x & 0x5555_5555, |x, &(shift, mask)| (x | x >> shift) & mask)
}

/// Which texels of a row of a map, the first of which begins `shift` texels before the first cell, shine into
/// a cell, and how much: the integral of their bilinear weights over it.
pub fn shares(cell: u32, shift: f64) -> [(i64, f64); 3] {
    // A texel reaches a whole texel to both sides of its middle.
    let begin = f64::from(cell) + shift;
    let first = (begin - 1.5).floor() as i64 + 1;
    // The integral of a tent up to a place relative to its middle.
    let up_to = |place: f64| match place.clamp(-1.0, 1.0) {
        place if place < 0.0 => 0.5 * (1.0 + place) * (1.0 + place),
        place => 1.0 - 0.5 * (1.0 - place) * (1.0 - place),
    };
    [0, 1, 2].map(|next| {
        let texel = first + next;
        let middle = texel as f64 + 0.5;
        (texel, up_to(begin + 1.0 - middle) - up_to(begin - middle))
    })
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::{Sky, TAU, shares};
    use crate::trace::emitters::Emitters;
    use crate::trace::sampling::hash;
    use crate::transport::environment::{direction_of, map_coordinates};
    use crate::transport::texture::Uv;

    fn rank_of(sky: &Sky, direction: DVec3) -> u32 {
        let Uv { u, v } = map_coordinates::<f64>(0.0, direction);
        sky.rank_at([u, v]).0
    }

    #[test]
    fn cells_fill_the_sphere_and_hold_the_directions_chosen_in_them() {
        for (columns, rows) in [(1, 1), (2, 1), (1, 2), (7, 5), (64, 32), (3, 200)] {
            let sky = Sky::new(columns, rows);
            let cells = (0..sky.ranks()).filter_map(|rank| Some((rank, sky.cell_at(rank)?)));
            let cells: Vec<_> = cells.collect();
            assert_eq!(cells.len() as u32, columns * rows);
            let total: f64 = cells.iter().map(|(_, cell)| sky.solid_angle(cell.1)).sum();
            assert!((total / (2.0 * TAU) - 1.0).abs() < 1e-12, "{columns} x {rows}: {total}");
            for (rank, cell) in cells {
                for at in [[0.5, 0.5], [0.01, 0.99], [0.9, 0.2]] {
                    let direction: DVec3 = direction_of::<f64>(sky.place(cell, at));
                    assert!((direction.length() - 1.0).abs() < 1e-12);
                    assert_eq!(rank_of(&sky, 3.0 * direction), rank, "{cell:?} {at:?}");
                }
            }
        }
    }

    /// Directions chosen evenly in the one cell of a sky are even on the sphere.
    #[test]
    fn directions_are_even_within_a_cell() {
        let sky = Sky::new(1, 1);
        let (mut mean, mut second) = (DVec3::ZERO, DVec3::ZERO);
        let side = 256;
        for i in 0..side * side {
            let at = [i % side, i / side].map(|i| (f64::from(i) + 0.5) / f64::from(side));
            let direction = direction_of::<f64>(sky.place((0, 0), at));
            mean += direction / f64::from(side * side);
            second += direction * direction / f64::from(side * side);
        }
        assert!(mean.length() < 1e-9 && (3.0 * second - DVec3::ONE).length() < 1e-4);
    }

    /// Directions fall into cells as often as their powers say (chi-square), and what they count for adds up
    /// to the solid angle of all cells that have any.
    #[test]
    fn directions_are_chosen_with_the_density_that_is_said() {
        let sky = Sky::new(12, 7);
        let solid_angle_of = |rank| sky.cell_at(rank).map_or(0.0, |cell| sky.solid_angle(cell.1));
        let power = |rank: u32| f64::from(rank * rank % 5) * solid_angle_of(rank);
        let ranks = sky.ranks();
        let emitters = Emitters::new([].into_iter(), 0, (0..ranks).map(power));
        let count = 1 << 18;
        let mut found = vec![0.0; ranks as usize];
        let mut solid_angle = 0.0;
        for i in 0..count {
            let number = |stream: u32| f64::from(hash(4 * i + stream)) / f64::from(u32::MAX);
            let (rank, choices) = emitters.choose(number(0));
            let direction = direction_of::<f64>(sky.place(sky.cell(rank), [number(1), number(2)]));
            assert_eq!(rank_of(&sky, direction), rank);
            found[rank as usize] += 1.0;
            solid_angle += choices * solid_angle_of(rank) / f64::from(count);
        }
        let (mut chi_square, mut freedom, mut expected_angle) = (0.0, -1.0, 0.0);
        for rank in 0..ranks {
            let expected = f64::from(count) / emitters.choices(rank);
            if expected > 0.0 {
                chi_square += (found[rank as usize] - expected).powi(2) / expected;
                freedom += 1.0;
                expected_angle += solid_angle_of(rank);
            } else {
                assert_eq!(found[rank as usize], 0.0);
            }
        }
        assert!((chi_square - freedom) < 4.0 * f64::sqrt(2.0 * freedom), "{chi_square} {freedom}");
        assert!((solid_angle / expected_angle - 1.0).abs() < 5e-3, "{solid_angle}");
    }

    #[test]
    fn texels_share_cells_as_bilinear_weights_do() {
        for shift in [0.0, 0.25, 0.5, -7.3] {
            let shares = shares(4, shift);
            assert!((shares.iter().map(|(_, share)| share).sum::<f64>() - 1.0).abs() < 1e-12);
            // The integral by the sum of many places.
            for (texel, share) in shares {
                let places = (0..1000).map(|i| 4.0 + shift + (f64::from(i) + 0.5) / 1000.0);
                let weight = |place: f64| (1.0 - (place - texel as f64 - 0.5).abs()).max(0.0);
                let sum: f64 = places.map(weight).sum();
                assert!((sum / 1000.0 - share).abs() < 1e-5, "{texel} {shift}");
            }
        }
        assert_eq!(shares(2, 0.0).map(|share| share.0), [1, 2, 3]);
    }
}
