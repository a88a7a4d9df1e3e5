//! Which emitter a surface looks for.

/// Powers are rounded away from those that squares and cubes have.
const BIAS: f64 = 1.07;

/// The primitives that shine, chosen with probabilities that follow their power.
///
/// A power is rounded to a power of two. So a probability does not depend on radiances and areas but in
/// steps, and the derivative of an image by these, random numbers kept, is that of its estimate. It costs
/// little: no emitter is chosen less than half as often or more than twice as often as without.
#[derive(Debug, Default, PartialEq)]
pub struct Emitters {
    /// In their order.
    primitives: Vec<u32>,
    weights: Vec<f64>,
    /// The sum of the weights up to each, itself included.
    sums: Vec<f64>,
}

impl Emitters {
    /// Primitives in their order, with their powers; those without any are left out.
    pub fn new(powers: impl Iterator<Item = (u32, f64)>) -> Self {
        let mut emitters = Self::default();
        let mut sum = 0.0;
        for (primitive, power) in powers.filter(|(_, power)| *power > 0.0 && power.is_finite()) {
            let weight = (BIAS * power).log2().round().exp2();
            sum += weight;
            emitters.primitives.push(primitive);
            emitters.weights.push(weight);
            emitters.sums.push(sum);
        }
        emitters
    }

    /// Whether nothing shines.
    pub fn is_empty(&self) -> bool {
        self.primitives.is_empty()
    }

    /// The emitter that a number from 0 to 1 chooses, which there has to be, and one over its probability.
    pub fn choose(&self, number: f64) -> (u32, f64) {
        let last = self.sums.len() - 1;
        let index = self.sums.partition_point(|&sum| sum <= number * self.sums[last]).min(last);
        (self.primitives[index], self.sums[last] / self.weights[index])
    }

    /// One over the probability of a primitive; infinite for one that is not chosen.
    pub fn choices(&self, primitive: u32) -> f64 {
        match self.primitives.binary_search(&primitive) {
            Ok(index) => self.sums[self.sums.len() - 1] / self.weights[index],
            Err(_) => f64::INFINITY,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Emitters;

    #[test]
    fn emitters_are_chosen_as_often_as_their_power_says() {
        let powers = [(3, 1.0), (5, 0.0), (7, 1e-30), (9, 4.2), (11, 3.9), (12, f64::NAN)];
        let emitters = Emitters::new(powers.into_iter());
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
        assert!(Emitters::new([(0, 0.0)].into_iter()).is_empty());
    }
}
