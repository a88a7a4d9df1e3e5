//! The gradient of pixels that are integrals.

use super::{GradientMetric, Sampler, Setting};
use crate::arithmetic::{Arithmetic, Precision};
use crate::integrator::{GradientSamples, Samples};
use crate::recovery::Recovery;

/// Gradients whose mean the reference is.
const SEEDS: u32 = 8;

/// The gradient of pixels that are integrals, as well as it is known: the mean over several seeds,
/// with rays for the derivative of the radiance that are not those of the radiance. So it has no
/// bias if the loss is a square, and less than any number of rays that is measured if it is not.
pub(crate) struct IntegralGradient {
    pub gradient: Vec<f64>,
    /// Its relative standard error.
    pub error: f64,
}

impl IntegralGradient {
    /// With as many rays as it takes to be off by a quarter of the accuracy, but no more than
    /// `most_rays` through each pixel for a seed.
    pub fn within(
        recovery: &Recovery<'_>,
        metric: &GradientMetric,
        sampler: Sampler,
        bounces: u32,
        most_rays: u32,
        accuracy: f64,
    ) -> Self {
        let with = |count| Self::new(recovery, metric, sampler, bounces, count);
        let mut count = most_rays.min(4);
        let mut reference = with(count);
        while reference.error > accuracy / 4.0 && 2 * count <= most_rays {
            count *= 2;
            reference = with(count);
        }
        reference
    }

    /// With so many rays through each pixel for a seed.
    pub fn new(
        recovery: &Recovery<'_>,
        metric: &GradientMetric,
        sampler: Sampler,
        bounces: u32,
        count: u32,
    ) -> Self {
        let gradients: Vec<Vec<f64>> = (0..SEEDS)
            .map(|seed| {
                // Not the seeds of what is measured.
                let seed = u32::MAX - seed;
                let samples = Samples { count, seed, gradient: GradientSamples::Independent };
                let arithmetic = Arithmetic::fastest(Precision::F64);
                let setting = Setting { arithmetic, bounces, sampling: sampler.random(samples) };
                setting.gradient(recovery)
            })
            .collect();
        let seeds = f64::from(SEEDS);
        let mean = |i: usize| gradients.iter().map(|gradient| gradient[i]).sum::<f64>() / seeds;
        let gradient: Vec<f64> = (0..metric.count()).map(mean).collect();
        let squares = gradients.iter().map(|other| metric.error(other, &gradient).powi(2));
        let error = (squares.sum::<f64>() / (seeds - 1.0) / seeds).sqrt();
        Self { gradient, error }
    }
}
