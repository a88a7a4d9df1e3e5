//! The gradient of pixels that are integrals.

use super::{Evaluator, GradientMetric, Sampler, Setting};
use crate::arithmetic::{Arithmetic, Precision};
use crate::settings::{GradientSamples, Samples};

/// Gradients whose mean the reference is.
const SEEDS: u32 = 8;
/// Where pixels show edges, the noise of even samples falls with this power of their number.
const RATE: f64 = 0.75;

/// The gradient of pixels that are integrals, as well as it is known: the mean over several seeds,
/// with rays for the derivative of the radiance that are not those of the radiance. So it has no
/// bias if the loss is a square, and less than any number of rays that is measured if it is not.
pub(crate) struct IntegralGradient {
    pub gradient: Vec<f64>,
    /// The relative standard error of the gradient.
    pub error: f64,
}

impl IntegralGradient {
    /// With about as many rays as it takes to be off by a quarter of the accuracy, but no more than
    /// `most_rays` through each pixel for a seed.
    pub fn within(
        evaluator: &mut Evaluator<'_>,
        metric: &GradientMetric,
        sampler: Sampler,
        bounces: u32,
        most_rays: u32,
        accuracy: f64,
    ) -> Self {
        let counts = sampler.counts(most_rays);
        let mut index = 0;
        loop {
            let count = counts[index];
            let reference = Self::new(evaluator, metric, sampler, bounces, count);
            let excess = 4.0 * reference.error / accuracy;
            if excess <= 1.0 || index + 1 == counts.len() {
                return reference;
            }
            let enough = f64::from(count) * excess.powf(RATE.recip());
            let next = counts.partition_point(|&count| f64::from(count) < enough);
            index = next.clamp(index + 1, counts.len() - 1);
        }
    }

    /// A reference with so many rays through each pixel for each seed.
    pub fn new(
        evaluator: &mut Evaluator<'_>,
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
                evaluator.gradient(&setting)
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
