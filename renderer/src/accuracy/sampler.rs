//! Where in a pixel rays go, by name.

use crate::settings::{GradientSamples, Samples, Sampling};

/// Where in a pixel its rays go, if there are several.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
pub enum Sampler {
    /// A random point in each of equal parts.
    Stratified,
    /// Points of the Sobol' sequence, shifted at random.
    Sobol,
}

impl Sampler {
    /// Both samplers.
    pub const ALL: [Self; 2] = [Self::Stratified, Self::Sobol];

    /// A word for it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Stratified => "stratified",
            Self::Sobol => "Sobol'",
        }
    }

    /// The sampling of `count` rays through each pixel; a single one goes through its middle.
    pub fn sampling(self, count: u32) -> Sampling {
        match count {
            1 => Sampling::Center,
            _ => self.random(Samples { count, seed: 0, gradient: GradientSamples::Same }),
        }
    }

    /// Rays at random places, even if it is one.
    pub(crate) fn random(self, samples: Samples) -> Sampling {
        match self {
            Self::Stratified => Sampling::Stratified(samples),
            Self::Sobol => Sampling::Sobol(samples),
        }
    }

    /// The numbers of rays up to `most` that suit it, each larger than the one before by a quarter at
    /// least: powers of two, and what is half-way between them; those that cut a pixel into squares,
    /// or nearly so.
    pub(super) fn counts(self, most: u32) -> Vec<u32> {
        let suits = |count: u32| match self {
            Self::Stratified => {
                let rows = count.isqrt();
                count == rows * rows || count == rows * (rows + 1)
            }
            Self::Sobol => matches!(count >> count.trailing_zeros(), 1 | 3),
        };
        let mut counts = vec![1];
        for count in 2..=most {
            if suits(count) && 4 * count >= 5 * counts[counts.len() - 1] {
                counts.push(count);
            }
        }
        counts
    }
}

#[cfg(test)]
mod tests {
    use super::Sampler;

    #[test]
    fn counts_suit_their_sampler_and_grow_by_half_at_most() {
        let stratified = [1, 2, 4, 6, 9, 12, 16, 20, 25, 36, 49, 64];
        assert_eq!(Sampler::Stratified.counts(64), stratified);
        assert_eq!(Sampler::Sobol.counts(64), [1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64]);
        for sampler in Sampler::ALL {
            assert_eq!(sampler.counts(1), [1]);
            let counts = sampler.counts(256);
            let grows_little = |pair: &[u32]| 2 * pair[1] <= 3 * pair[0] || pair[0] <= 2;
            assert!(counts.windows(2).all(grows_little), "{counts:?}");
        }
    }
}
