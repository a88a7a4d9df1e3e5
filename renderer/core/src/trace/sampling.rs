//! Where within a pixel rays go.
//!
//! The middle of each pixel alone is the default: it is exact for what the gradients of a scene are
//! about, and has no noise. Several rays smooth edges and fine textures. Of the ways to place them,
//! two are here. Stratified ones need nothing from each other; those of the Sobol' sequence are the
//! evenest at the same cost. Turned down: Owen's scrambling of the sequence in place of a shift for
//! each pixel, which costs a hash for each ray and bit where the shift costs an addition.

use super::bvh::{PACKET_RAYS, tile_position};

use super::tile::Tile;

/// Where within a pixel rays go. The radiance of a pixel is the mean of what its rays bring.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sampling {
    /// One, through the middle.
    #[default]
    Center,
    /// The pixel is cut into this many columns and as many rows, and a ray goes through the middle of
    /// each part.
    Grid(u32),
    /// The pixel is cut into as many parts of equal size as there are rays, and each goes through a
    /// random point of its own part (Cook 1986).
    Stratified(Samples),
    /// The first two dimensions of the Sobol' sequence, shifted by a random vector for each pixel
    /// (Cranley & Patterson 1976): the evenest.
    Sobol(Samples),
}

/// How many rays go through a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Samples {
    /// Rays through each pixel; at least 1, and 2 where those of the gradient are independent.
    pub count: u32,
    /// Tells random choices apart; the same seed gives the same image.
    pub seed: u32,
    /// What a gradient is computed from.
    ///
    /// The loss is not linear in the radiance, so the noise of both factors of a derivative,
    /// `2 (radiance - target) * d radiance` for a squared difference, adds up to a bias where they
    /// share their rays; the result is then the exact gradient of the loss that was measured. Independent
    /// rays for each factor have no bias, and the gradient is no longer that of the measured loss.
    pub gradient: GradientSamples,
}

impl Samples {
    fn count(self) -> u32 {
        let least = match self.gradient {
            GradientSamples::Same => 1,
            GradientSamples::Independent => 2,
        };
        self.count.max(least)
    }

    fn seed_of_lights(self) -> Option<u32> {
        let is_independent = self.gradient == GradientSamples::Independent;
        is_independent.then(|| hash(self.seed ^ 0x27d4_eb2f))
    }

    /// Two halves with other random numbers, if the derivative is computed from others than the radiance.
    fn halves(self) -> Option<[Self; 2]> {
        let Self { seed, gradient: GradientSamples::Independent, .. } = self else { return None };
        let second = self.count() / 2;
        let half = |count, seed| Self { count, seed, gradient: GradientSamples::Same };
        Some([half(self.count() - second, seed), half(second, hash(seed ^ 0x5bd1_e995))])
    }
}

/// The rays that the derivative of the radiance is computed from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
pub enum GradientSamples {
    /// Those of the radiance.
    #[default]
    Same,
    /// Others: half of the rays have random numbers of their own, and the derivative of the radiance of each half
    /// goes with the radiance of the other one (Deng et al., "Reconstructing Translucent Objects Using Differentiable
    /// Rendering", 2022). It takes no more rays. In direct light the derivative of the second half stands for both.
    Independent,
}

/// By ray: how far to the right and downwards from the middle of its pixel it goes, in pixels, from
/// -0.5 to 0.5.
pub type Offsets = [[f32; PACKET_RAYS]; 2];

impl Sampling {
    /// How many rays go through a pixel.
    pub fn count(self) -> u32 {
        match self {
            Self::Center => 1,
            Self::Grid(side) => side.max(1).pow(2),
            Self::Stratified(samples) | Self::Sobol(samples) => samples.count(),
        }
    }

    /// What tells random choices apart.
    pub(crate) fn seed(self) -> u32 {
        match self {
            Self::Center | Self::Grid(_) => 0,
            Self::Stratified(samples) | Self::Sobol(samples) => samples.seed,
        }
    }

    /// So many rays of this batch of a sequence: the first has this seed, the others have seeds that those of other
    /// sequences, begun with other seeds, do not have. Rays that are not at random places stay.
    #[must_use]
    pub fn batch(self, count: u32, index: u32) -> Self {
        self.with(|samples| {
            let seed = if index == 0 { samples.seed } else { hash(samples.seed ^ hash(index)) };
            Samples { count, seed, ..samples }
        })
    }

    /// The same rays with other ones for the gradient. Rays that are not at random places stay.
    #[must_use]
    pub fn with_gradient(self, gradient: GradientSamples) -> Self {
        self.with(|samples| Samples { gradient, ..samples })
    }

    /// Changes those at random places.
    fn with(self, change: impl Fn(Samples) -> Samples) -> Self {
        match self {
            Self::Center | Self::Grid(_) => self,
            Self::Stratified(samples) => Self::Stratified(change(samples)),
            Self::Sobol(samples) => Self::Sobol(change(samples)),
        }
    }

    /// What lights that stand for others are drawn by, if derivatives are to be right on average.
    pub(crate) fn seed_of_lights(self) -> Option<u32> {
        match self {
            Self::Stratified(samples) | Self::Sobol(samples) => samples.seed_of_lights(),
            Self::Center | Self::Grid(_) => None,
        }
    }

    /// The regular grid with at least as many rays.
    pub(crate) fn as_grid(self) -> Self {
        Self::Grid(self.grid_side())
    }

    /// How many rays stand side by side in a pixel of the regular grid with at least as many rays.
    pub(crate) fn grid_side(self) -> u32 {
        let count = self.count();
        let side = count.isqrt();
        if side * side < count { side + 1 } else { side }
    }

    /// The rays that share their random numbers: all of them, or [two halves](GradientSamples::Independent).
    pub(crate) fn parts(self) -> impl Iterator<Item = Self> + Clone {
        let halves = match self {
            Self::Stratified(samples) | Self::Sobol(samples) => samples.halves(),
            Self::Center | Self::Grid(_) => None,
        };
        let parts = match halves {
            None => [Some(self), None],
            Some(halves) => halves.map(|half| Some(self.with(|_| half))),
        };
        parts.into_iter().flatten()
    }

    /// Where the rays of a tile go; `None` if through the middle of their pixels.
    pub(crate) fn offsets(self, tile: &Tile, sample: u32) -> Option<Offsets> {
        let mut offsets = [[0.0; PACKET_RAYS]; 2];
        match self {
            Self::Center | Self::Grid(0 | 1) => return None,
            Self::Grid(side) => {
                let place = |at: u32| (at as f32 + 0.5) / side as f32 - 0.5;
                offsets = [[place(sample % side); _], [place(sample / side); _]];
            }
            Self::Stratified(samples) => {
                let (columns, rows) = strata(samples.count.max(1));
                let (column, row) = (sample % columns, sample / columns);
                let seed = hash(samples.seed.wrapping_add(hash(sample)));
                let random = random(tile, seed);
                for (ray, random) in random.into_iter().enumerate() {
                    let place = |at: u32, random: f32, of: u32| (at as f32 + random) / of as f32;
                    offsets[0][ray] = place(column, random[0], columns) - 0.5;
                    offsets[1][ray] = place(row, random[1], rows) - 0.5;
                }
            }
            Self::Sobol(samples) => {
                let [x, y] = sobol(sample);
                let shifts = random(tile, hash(samples.seed));
                for (ray, shift) in shifts.into_iter().enumerate() {
                    // Both below 1, so the fraction is what is left of 1.
                    let wrap = |x: f32| if x < 1.0 { x } else { x - 1.0 };
                    offsets[0][ray] = wrap(x + shift[0]) - 0.5;
                    offsets[1][ray] = wrap(y + shift[1]) - 0.5;
                }
            }
        }
        Some(offsets)
    }
}

/// Columns and rows of the parts of a pixel: as close to a square as their number lets them be.
fn strata(count: u32) -> (u32, u32) {
    let most = count.isqrt();
    let rows = (1..=most).rev().find(|rows| count.is_multiple_of(*rows)).unwrap_or(1);
    (count / rows, rows)
}

/// Two numbers in [0, 1) for each pixel of a tile.
fn random(tile: &Tile, seed: u32) -> [[f32; 2]; PACKET_RAYS] {
    std::array::from_fn(|ray| {
        let (column, row) = tile_position(ray);
        let (x, y) = ((tile.left + column) as u32, (tile.top + row) as u32);
        let bits = hash(x.wrapping_mul(0x9e37_79b9) ^ hash(y.wrapping_add(seed)));
        [bits & 0xffff, bits >> 16].map(|bits| bits as f32 / 65_536.0)
    })
}

/// The first two dimensions of the Sobol' sequence: van der Corput's, and that of the polynomial
/// `x + 1` (Sobol' 1967).
fn sobol(index: u32) -> [f32; 2] {
    let mut second = 0;
    let mut direction = 1_u32 << 31;
    let mut rest = index;
    while rest != 0 {
        if rest & 1 == 1 {
            second ^= direction;
        }
        direction ^= direction >> 1;
        rest >>= 1;
    }
    // 24 bits are what an `f32` below 1 holds.
    [index.reverse_bits(), second].map(|bits: u32| (bits >> 8) as f32 / (1 << 24) as f32)
}

/// Three numbers from 0 up to, but without, 1, of a row of them that follows from a seed.
pub(crate) fn random_numbers(seed: u32, index: u32) -> [f64; 3] {
    [0, 1, 2]
        .map(|axis| f64::from(hash(seed.wrapping_add(hash(3 * index + axis)))) / 2.0_f64.powi(32))
}

/// Mixes bits (`lowbias32`, Wellons, "Prospecting for Hash Functions", 2018).
pub(crate) fn hash(mut x: u32) -> u32 {
    x = (x ^ x >> 16).wrapping_mul(0x7feb_352d);
    x = (x ^ x >> 15).wrapping_mul(0x846c_a68b);
    x ^ x >> 16
}

#[cfg(test)]
mod tests {
    use super::super::tile::Tile;
    use super::{GradientSamples, PACKET_RAYS, Samples, Sampling, sobol, strata};

    const TILE: Tile = Tile { left: 64, top: 8, columns: 8, rows: 8 };

    fn samples(count: u32) -> Samples {
        Samples { count, seed: 3, gradient: GradientSamples::Same }
    }

    /// The places of all rays of the first pixel.
    fn places(sampling: Sampling) -> Vec<[f32; 2]> {
        let offsets = (0..sampling.count()).map(|sample| sampling.offsets(&TILE, sample));
        offsets.flatten().map(|[x, y]| [x[0] + 0.5, y[0] + 0.5]).collect()
    }

    #[test]
    fn each_part_of_a_pixel_gets_one_ray() {
        for (count, columns, rows) in [(1, 1, 1), (2, 2, 1), (12, 4, 3), (16, 4, 4), (7, 7, 1)] {
            assert_eq!(strata(count), (columns, rows));
            let mut parts: Vec<_> = places(Sampling::Stratified(samples(count)))
                .into_iter()
                .map(|[x, y]| ((x * columns as f32) as u32, (y * rows as f32) as u32))
                .collect();
            parts.sort_unstable();
            let all = (0..columns).flat_map(|x| (0..rows).map(move |y| (x, y)));
            assert_eq!(parts, all.collect::<Vec<_>>());
        }
    }

    /// The property of a (0, 2)-sequence: every box of area 1/16 that halving makes holds one of 16.
    #[test]
    fn the_sobol_sequence_is_even_in_every_shape_of_box() {
        for start in [0, 16, 48] {
            for columns in [1, 2, 4, 8, 16] {
                let mut boxes: Vec<_> = (start..start + 16)
                    .map(sobol)
                    .map(|[x, y]| ((x * columns as f32) as u32, (y * (16 / columns) as f32) as u32))
                    .collect();
                boxes.sort_unstable();
                boxes.dedup();
                assert_eq!(boxes.len(), 16, "{columns} columns from {start}");
            }
        }
    }

    #[test]
    fn batches_of_other_seeds_are_others() {
        let mut seeds: Vec<u32> = Vec::new();
        for seed in 0..16 {
            let begun = Sampling::Sobol(Samples { seed, ..samples(16) });
            assert_eq!(begun.batch(16, 0), begun);
            seeds.extend((0..64).map(|index| match begun.batch(4, index) {
                Sampling::Sobol(Samples { seed, count: 4, .. }) => seed,
                other => panic!("{other:?}"),
            }));
        }
        let count = seeds.len();
        seeds.sort_unstable();
        seeds.dedup();
        assert_eq!(seeds.len(), count);
    }

    #[test]
    fn places_are_in_the_pixel_differ_between_pixels_and_average_to_the_middle() {
        for sampling in [Sampling::Stratified(samples(16)), Sampling::Sobol(samples(16))] {
            for sample in 0..16 {
                let [x, y] = sampling.offsets(&TILE, sample).unwrap();
                assert!(x.iter().chain(&y).all(|at| (-0.5..0.5).contains(at)));
                assert!((0..PACKET_RAYS).any(|ray| x[ray] != x[0]));
            }
            let all = places(sampling).into_iter().flatten();
            let mean = all.sum::<f32>() / 32.0;
            assert!((mean - 0.5).abs() < 0.1, "{sampling:?}: {mean}");
        }
    }

    #[test]
    fn independent_samples_are_two_halves_with_other_numbers() {
        let independent =
            |count| Samples { gradient: GradientSamples::Independent, ..samples(count) };
        for (sampling, counts) in [
            (Sampling::Center, &[1][..]),
            (Sampling::Grid(3), &[9]),
            (Sampling::Sobol(samples(4)), &[4]),
            (Sampling::Sobol(independent(5)), &[3, 2]),
            (Sampling::Stratified(independent(1)), &[1, 1]),
        ] {
            let parts: Vec<_> = sampling.parts().collect();
            assert_eq!(parts.iter().map(|part| part.count()).collect::<Vec<_>>(), counts);
            assert_eq!(sampling.count(), counts.iter().sum());
            if let [a, b] = parts[..] {
                assert_ne!(a.offsets(&TILE, 0), b.offsets(&TILE, 0));
            }
        }
    }
}
