//! How many rays go through a pixel, as the command line says it.

use clap::ValueEnum;

use crate::integrator::{GradientSamples, Samples, Sampling};

#[derive(clap::Args)]
pub(super) struct SamplingArguments {
    /// Rays through each pixel; one goes through its middle
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=MOST))]
    samples: u32,

    /// Where in the pixel they go, if there are several
    #[arg(long, value_enum, default_value_t = Sampler::Sobol)]
    sampler: Sampler,
}

/// More would take longer than anybody waits, and lose the precision of their numbers.
const MOST: i64 = 1 << 16;

#[derive(Clone, Copy, ValueEnum)]
enum Sampler {
    /// A random point in each of equal parts
    Stratified,
    /// Points of the Sobol' sequence, shifted at random
    Sobol,
}

impl SamplingArguments {
    pub fn sampling(&self) -> Sampling {
        let samples =
            Samples { count: self.samples, seed: 0, gradient: GradientSamples::default() };
        match self.sampler {
            _ if self.samples == 1 => Sampling::Center,
            Sampler::Stratified => Sampling::Stratified(samples),
            Sampler::Sobol => Sampling::Sobol(samples),
        }
    }
}
