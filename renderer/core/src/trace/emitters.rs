//! Which emitter a surface looks for.

use wide::f64x8;

/// Powers are rounded away from those that squares and cubes have.
const BIAS: f64 = 1.07;

/// The primitives that shine, and the cells of the environment, chosen with probabilities that follow their
/// power.
///
/// A power is rounded to a power of two. So a probability does not depend on radiances and areas but in
/// steps, and the derivative of an image by these, random numbers kept, is that of its estimate. It costs
/// little: no emitter is chosen less than half as often or more than twice as often as without.
#[derive(Debug, Default, PartialEq)]
pub struct Emitters {
    /// Those that shine, in their order.
    primitives: Vec<u32>,
    /// What the first cell counts as.
    first_cell: u32,
    /// The sums of the weights up to each, itself included, of the primitives, then of all cells, by eights; then the
    /// last of each eight, level by level, until one eight is left: few of a million sums are read to find one.
    /// Infinite beyond the last.
    levels: Vec<Vec<f64x8>>,
    /// The sum of all weights.
    total: f64,
    /// The last one that shines.
    last: usize,
}

/// A point of a triangle or sphere that shines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShiningPoint {
    pub primitive: u32,
    /// Where it is: see [`sight_of()`](crate::transport::emitter::sight_of()), or, on a sphere that does not shine
    /// evenly, [`sight_on_sphere()`](crate::transport::emitter::sight_on_sphere()).
    pub at: [f64; 3],
    pub is_even: bool,
    /// One over the probability with which the primitive is chosen, by the number of points.
    pub choices: f64,
}

impl Emitters {
    /// Primitives in their order, with their powers, and the powers of all cells, which count as primitives
    /// from `first_cell` on.
    pub fn new(
        powers: impl Iterator<Item = (u32, f64)>,
        first_cell: u32,
        cells: impl Iterator<Item = f64>,
    ) -> Self {
        let mut emitters = Self { first_cell, ..Self::default() };
        let weight = |power: f64| match power > 0.0 && power.is_finite() {
            true => (BIAS * power).log2().round().exp2(),
            false => 0.0,
        };
        let weighted = powers.map(|(primitive, power)| (primitive, weight(power)));
        let (primitives, mut sums): (Vec<_>, Vec<_>) =
            weighted.filter(|&(_, weight)| weight > 0.0).unzip();
        emitters.primitives = primitives;
        sums.extend(cells.map(weight));
        emitters.last = sums.iter().rposition(|&weight| weight > 0.0).unwrap_or(0);
        for sum in &mut sums {
            emitters.total += *sum;
            *sum = emitters.total;
        }
        if emitters.total == 0.0 {
            return Self::default();
        }
        loop {
            let eights = sums.chunks(8).map(|chunk| {
                let mut eight = [f64::INFINITY; 8];
                eight[..chunk.len()].copy_from_slice(chunk);
                eight
            });
            let eights: Vec<_> = eights.collect();
            sums = eights.iter().map(|eight| eight[7]).collect();
            emitters.levels.push(eights.into_iter().map(f64x8::new).collect());
            if sums.len() == 1 {
                return emitters;
            }
        }
    }

    /// Whether nothing shines.
    pub fn is_empty(&self) -> bool {
        self.levels.is_empty()
    }

    /// The emitter that a number from 0 to 1 chooses, which there has to be, and one over its probability.
    #[inline]
    pub fn choose(&self, number: f64) -> (u32, f64) {
        let wanted = f64x8::splat(number * self.total);
        let index = self.levels.iter().rev().fold(0, |index, level| {
            8 * index + level[index].simd_le(wanted).to_bitmask().count_ones() as usize
        });
        let index = index.min(self.last);
        let primitive = match index.checked_sub(self.primitives.len()) {
            None => self.primitives[index],
            Some(cell) => self.first_cell + cell as u32,
        };
        (primitive, self.choices_of(index))
    }

    /// So many emitters, spread evenly over the power, each with numbers from 0 to 1 that choose a point of it and
    /// with what the point counts for, among all points of all emitters. A shift by random numbers makes what they bring
    /// right on average (Cranley & Patterson 1976).
    pub fn spread(
        &self,
        count: u32,
        shift: [f64; 3],
    ) -> impl Iterator<Item = (u32, [f64; 2], f64)> {
        let radical_inverse = |mut index: u32, base: u32| {
            let (mut digit, mut value) = (1.0, 0.0);
            while index > 0 {
                digit /= f64::from(base);
                value += digit * f64::from(index % base);
                index /= base;
            }
            value
        };
        (0..count).map(move |index| {
            let [along, u, v] = shift;
            let (primitive, one_of) = self.choose((f64::from(index) + along) / f64::from(count));
            let number = |base, shift: f64| (radical_inverse(index + 1, base) + shift).fract();
            (primitive, [number(2, u), number(3, v)], one_of / f64::from(count))
        })
    }

    /// One over the probability of a primitive; infinite for one that is not chosen, as those are that are too
    /// dark beside others for double precision.
    pub fn choices(&self, primitive: u32) -> f64 {
        let index = match primitive.checked_sub(self.first_cell) {
            _ if self.is_empty() => None,
            Some(cell) => Some(self.primitives.len() + cell as usize),
            None => self.primitives.binary_search(&primitive).ok(),
        };
        index.map_or(f64::INFINITY, |index| self.choices_of(index))
    }

    /// One over the probability of the emitter of an index.
    #[inline]
    fn choices_of(&self, index: usize) -> f64 {
        let sum = |index: usize| self.levels[0][index / 8].as_array()[index % 8];
        let before = index.checked_sub(1).map_or(0.0, sum);
        self.total / (sum(index) - before)
    }
}

#[cfg(test)]
mod tests {
    use super::Emitters;

    #[test]
    fn emitters_are_chosen_as_often_as_their_power_says() {
        let powers = [(3, 1.0), (5, 0.0), (7, 1e-30), (9, 4.2), (11, 3.9), (12, f64::NAN)];
        let emitters = Emitters::new(powers.into_iter(), 20, [].into_iter());
        let count = 9 << 10;
        let mut chosen = [0; 16];
        for index in 0..count {
            let (primitive, choices) = emitters.choose((index as f64 + 0.5) / f64::from(count));
            assert_eq!(choices, emitters.choices(primitive));
            chosen[primitive as usize] += 1;
        }
        assert_eq!(chosen[3], 1 << 10);
        assert_eq!((chosen[9], chosen[11]), (4 << 10, 4 << 10));
        assert_eq!(emitters.choose(0.0).0, 3);
        assert_eq!(emitters.choose(1.0).0, 11);
        assert_eq!(emitters.choices(5), f64::INFINITY);
        // Beside the others it makes no difference to the sum.
        assert_eq!(emitters.choices(7), f64::INFINITY);
        assert!(Emitters::new([(0, 0.0)].into_iter(), 1, [0.0].into_iter()).is_empty());
    }

    /// Primitives and cells of very different powers, many of them dark, each by as many numbers as its
    /// power says, and exactly those that lie between the sums.
    #[test]
    fn every_number_chooses_what_the_sums_say() {
        let power = |i: u32| match i % 7 {
            0 | 3 => 0.0,
            k => f64::powi(2.0, (i * k % 23) as i32 - 11),
        };
        let emitters =
            Emitters::new((0..10).map(|i| (3 * i, power(i))), 40, (0..500).map(|i| power(i + 5)));
        let of_all = (0..40).chain(40..540).map(|i| (i, 1.0 / emitters.choices(i)));
        let shining: Vec<_> = of_all.filter(|(_, part)| *part > 0.0).collect();
        assert!((shining.iter().map(|(_, part)| part).sum::<f64>() - 1.0).abs() < 1e-12);
        let mut from = 0.0;
        for &(primitive, part) in &shining {
            for within in [0.01, 0.5, 0.99] {
                let (chosen, choices) = emitters.choose(from + within * part);
                assert_eq!((chosen, choices), (primitive, emitters.choices(primitive)));
            }
            from += part;
        }
        assert_eq!(emitters.choose(1.0).0, shining.last().unwrap().0);
        assert_eq!(emitters.choose(0.0).0, shining[0].0);
    }
}
