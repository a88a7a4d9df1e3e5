//! Which emitter a surface looks for.

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
    /// Of the primitives, then of all cells.
    weights: Vec<f64>,
    /// The sum of the weights up to each, itself included.
    sums: Vec<f64>,
    /// Where to look for numbers, of as many even parts: the first whose sum is above the part's beginning
    /// (Chen & Asau, "On Generating Random Variates from an Empirical Distribution", 1974).
    guide: Vec<u32>,
}

/// A point of a triangle or sphere that shines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShiningPoint {
    pub primitive: u32,
    /// Where it is: see [`sight_of()`](crate::transport::emitter::sight_of()).
    pub at: [f64; 3],
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
        let shines = |power: f64| power > 0.0 && power.is_finite();
        let weight = |power: f64| (BIAS * power).log2().round().exp2();
        for (primitive, power) in powers.filter(|&(_, power)| shines(power)) {
            emitters.primitives.push(primitive);
            emitters.weights.push(weight(power));
        }
        let cells = cells.map(|power| if shines(power) { weight(power) } else { 0.0 });
        emitters.weights.extend(cells);
        let mut sum = 0.0;
        emitters.sums.extend(emitters.weights.iter().map(|weight| {
            sum += weight;
            sum
        }));
        if sum == 0.0 {
            return Self::default();
        }
        let parts = emitters.sums.len();
        let mut index = 0;
        emitters.guide.extend((0..parts).map(|part| {
            while emitters.sums[index] <= sum * (part as f64 / parts as f64) {
                index += 1;
            }
            index as u32
        }));
        emitters
    }

    /// Whether nothing shines.
    pub fn is_empty(&self) -> bool {
        self.sums.is_empty()
    }

    /// The emitter that a number from 0 to 1 chooses, which there has to be, and one over its probability.
    pub fn choose(&self, number: f64) -> (u32, f64) {
        let (count, last) = (self.sums.len(), self.sums[self.sums.len() - 1]);
        let part = ((number * count as f64) as usize).min(count - 1);
        // A part begins and ends with rounding: one to each side is looked at, too.
        let at = |part: usize| self.guide.get(part).map_or(count, |&index| index as usize + 1);
        let (first, end) = (at(part.max(1) - 1) - 1, at(part + 2).min(count));
        let among = &self.sums[first..end];
        let index = first + among.partition_point(|&sum| sum <= number * last);
        let index = self.shining(index.min(count - 1));
        let primitive = match index.checked_sub(self.primitives.len()) {
            None => self.primitives[index],
            Some(cell) => self.first_cell + cell as u32,
        };
        (primitive, last / self.weights[index])
    }

    /// The last one that shines up to an index: the number 1 chooses that.
    fn shining(&self, index: usize) -> usize {
        (0..=index).rev().find(|&index| self.weights[index] > 0.0).unwrap_or(index)
    }

    /// So many emitters, spread evenly over the power, each with numbers from 0 to 1 that choose a point of it and
    /// with what the point counts for, among all points of all emitters.
    pub fn spread(&self, count: u32) -> impl Iterator<Item = (u32, [f64; 2], f64)> {
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
            let (primitive, one_of) = self.choose((f64::from(index) + 0.5) / f64::from(count));
            let numbers = [2, 3].map(|base| radical_inverse(index + 1, base));
            (primitive, numbers, one_of / f64::from(count))
        })
    }

    /// One over the probability of a primitive; infinite for one that is not chosen.
    pub fn choices(&self, primitive: u32) -> f64 {
        let index = match primitive.checked_sub(self.first_cell) {
            Some(cell) => Some(self.primitives.len() + cell as usize),
            None => self.primitives.binary_search(&primitive).ok(),
        };
        match index.and_then(|index| self.weights.get(index)) {
            Some(weight) => self.sums[self.sums.len() - 1] / weight,
            None => f64::INFINITY,
        }
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
        assert!(emitters.choices(7) > 1e29 && emitters.choices(7).is_finite());
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
