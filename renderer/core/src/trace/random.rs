//! The random numbers of paths.
//!
//! The numbers of a pixel are those of one point set in many dimensions, the Sobol' sequence with Owen's
//! scrambling (Burley, "Practical Hash-based Owen Scrambling", 2020), whose seed is its own: the error of a
//! pixel falls faster than that of independent numbers, and does not go with that of its neighbours.
//! Rays of one depth take eight dimensions, in two sets of four.

use sobol_burley::NUM_DIMENSION_SETS_4D;
use sobol_burley::parts::{owen_scramble_rev, sobol_rev, u32_to_f32_norm};

use super::bvh::PACKET_RAYS;
use super::sampling::{Sampling, hash};
use super::tile::Tile;

/// How many sets of four numbers there are for each depth.
const SETS: u32 = 2;

/// The numbers of one path through each pixel of a tile, or on each side of some edges.
#[derive(Clone)]
pub struct PathNumbers {
    /// By ray.
    pub seeds: [u32; PACKET_RAYS],
    index: u32,
}

/// What four numbers are for.
#[derive(Clone, Copy)]
pub enum Purpose {
    /// To look for an emitter.
    Emitter,
    /// To go on.
    Scatter,
}

impl PathNumbers {
    /// Those of the path `index` through the pixels.
    pub fn new(tile: &Tile, sampling: Sampling, index: u32) -> Self {
        let (seed, index) = in_sequence(sampling.seed(), index);
        let seeds = std::array::from_fn(|ray| {
            let (x, y) = tile.pixel(ray);
            hash(hash(x ^ seed).wrapping_add(y.wrapping_mul(0x9e37_79b9)))
        });
        Self { seeds, index }
    }

    /// Those of the path `index` on both sides of edges, two rays for each, the first of which has this number:
    /// the same on either side.
    pub fn on_sides(first: u32, seed: u32, index: u32) -> Self {
        Self::numbered(|ray| first + ray / 2, !seed, index)
    }

    /// Those of the path `index` of the rays of a strip, the first of which has this number.
    pub fn in_strip(first: u32, seed: u32, index: u32) -> Self {
        Self::numbered(|ray| first + ray, hash(!seed), index)
    }

    fn numbered(number: impl Fn(u32) -> u32, seed: u32, index: u32) -> Self {
        let (seed, index) = in_sequence(seed, index);
        Self { seeds: std::array::from_fn(|ray| hash(number(ray as u32) ^ seed)), index }
    }

    /// Those of a path for each ray that has this seed.
    pub fn of_seeds(seeds: [u32; PACKET_RAYS]) -> Self {
        Self { seeds, index: 0 }
    }

    /// The numbers of all rays.
    pub fn at(&self, depth: u32, purpose: Purpose) -> RayNumbers {
        let set = depth * SETS + purpose as u32;
        let (round, set) = (set / NUM_DIMENSION_SETS_4D, set % NUM_DIMENSION_SETS_4D);
        let round = hash(round);
        RayNumbers(std::array::from_fn(|axis| {
            let dimension = 4 * set + axis as u32;
            // One point serves all rays: scrambling makes each sequence another one.
            let point = sobol_rev(self.index.reverse_bits(), dimension);
            let mut numbers = [0.0; PACKET_RAYS];
            for (number, seed) in numbers.iter_mut().zip(&self.seeds) {
                let scramble = hash(seed.wrapping_add(round) ^ dimension.wrapping_mul(0x9e37_79b9));
                *number = u32_to_f32_norm(owen_scramble_rev(point, scramble).reverse_bits());
            }
            numbers
        }))
    }
}

/// The seed of the sequence that the point of an index is of, and its index there: where one ends, another one begins.
fn in_sequence(seed: u32, index: u32) -> (u32, u32) {
    (hash(seed ^ index >> 16), index & 0xffff)
}

/// Four numbers from 0 up to, but without, 1, of a path that belongs to no pixel.
pub fn path_numbers(index: u32, set: u32, seed: u32) -> [f64; 4] {
    let (seed, index) = in_sequence(seed, index);
    let numbers: [f32; 4] = sobol_burley::sample_4d(index, set, seed);
    numbers.map(f64::from)
}

/// Four numbers for each ray, from 0 up to, but without, 1.
pub struct RayNumbers([[f32; PACKET_RAYS]; 4]);

impl RayNumbers {
    /// Those of one axis, by ray.
    #[inline]
    pub fn along(&self, axis: usize) -> &[f32; PACKET_RAYS] {
        &self.0[axis]
    }

    /// Those of one ray.
    #[inline]
    pub fn of(&self, ray: usize) -> [f32; 4] {
        self.0.each_ref().map(|numbers| numbers[ray])
    }
}

#[cfg(test)]
mod tests {
    use super::{PACKET_RAYS, PathNumbers, Purpose};
    use crate::trace::sampling::{GradientSamples, Samples, Sampling};
    use crate::trace::tile::Tile;

    const TILE: Tile = Tile { left: 64, top: 8, columns: 8, rows: 8 };

    fn numbers(index: u32, seed: u32) -> PathNumbers {
        let samples = Samples { count: 64, seed, gradient: GradientSamples::Same };
        PathNumbers::new(&TILE, Sampling::Sobol(samples), index)
    }

    /// 16 points in a row have one in each of 16 parts, along every axis and at every depth, also beyond
    /// the dimensions of the sequence.
    #[test]
    fn numbers_are_even_along_every_axis() {
        for depth in [0, 3, 31, 32, 100] {
            for ray in [0, 17] {
                for axis in 0..4 {
                    let at = |i| numbers(i, 5).at(depth, Purpose::Scatter).of(ray)[axis];
                    let mut parts: Vec<_> = (0..16).map(|i| (at(i) * 16.0) as u32).collect();
                    parts.sort_unstable();
                    assert_eq!(parts, (0..16).collect::<Vec<_>>(), "{depth} {axis}");
                }
            }
        }
    }

    #[test]
    fn pixels_seeds_depths_and_purposes_have_their_own() {
        let one = numbers(3, 5);
        let first = one.at(1, Purpose::Scatter).of(0);
        assert!((1..PACKET_RAYS).all(|ray| one.at(1, Purpose::Scatter).of(ray) != first));
        assert_ne!(first, one.at(2, Purpose::Scatter).of(0));
        assert_ne!(first, one.at(33, Purpose::Scatter).of(0));
        assert_ne!(first, one.at(1, Purpose::Emitter).of(0));
        assert_ne!(first, numbers(3, 6).at(1, Purpose::Scatter).of(0));
        assert_ne!(first, numbers(3 + (1 << 16), 5).at(1, Purpose::Scatter).of(0));
        assert_eq!(first, numbers(3, 5).at(1, Purpose::Scatter).of(0));
    }
}
