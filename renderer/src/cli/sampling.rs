//! How many rays go through a pixel, as the command line says it.

use crate::accuracy::Sampler;
use crate::scene::{Integrator, PathTracing, Scene};
use crate::settings::{GradientSamples, Samples, Sampling};

#[derive(clap::Args)]
pub(super) struct SamplingArguments {
    /// Rays through each pixel; one goes through its middle [default: 1; where light takes all paths,
    /// the samples of the scene, at random places even if it is one]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=MOST))]
    samples: Option<u32>,

    /// Where in the pixel they go, if there are several
    #[arg(long, value_enum, default_value_t = Sampler::Sobol)]
    pub sampler: Sampler,
}

/// More would take longer than anybody waits, and lose the precision of their numbers.
const MOST: i64 = 1 << 16;

impl SamplingArguments {
    pub fn sampling(&self, scene: &Scene) -> Sampling {
        match scene.integrator {
            Integrator::Direct => self.sampler.sampling(self.samples.unwrap_or(1)),
            Integrator::Path(PathTracing { samples, seed, .. }) => {
                let count = self.samples.unwrap_or(samples);
                self.sampler.random(Samples { count, seed, gradient: GradientSamples::Same })
            }
        }
    }

    /// Returns `true` if the number of rays through each pixel was left open.
    pub fn is_open(&self) -> bool {
        self.samples.is_none()
    }
}
