//! The gradient of pixels that are integrals.

use super::{Evaluator, GradientMetric, Sampler, Setting};
use crate::arithmetic::{Arithmetic, Precision};
use crate::settings::{GradientSamples, Samples, Sampling};

/// The regular grids that are tried where gradients see edges: how many rays stand side by side.
const SIDES: [u32; 8] = [1, 2, 3, 4, 6, 8, 12, 16];

/// Gradients whose mean the reference is.
const SEEDS: u32 = 8;
/// Where pixels show edges, the noise of even samples falls with this power of their number.
const RATE: f64 = 0.75;

/// The gradient of pixels that are integrals, as well as it is known.
///
/// Without edges it is the mean over several seeds, with rays for the derivative of the radiance that
/// are not those of the radiance, as many for each of both. So it has no bias if the loss is a square, and less than any number of
/// rays that is measured if it is not. With edges it is that of a fine regular grid.
pub(crate) struct IntegralGradient {
    pub gradient: Vec<f64>,
    /// Its relative standard error; of a grid: how far it is from that of the next coarser grid, and
    /// infinite if there is none.
    pub error: f64,
}

/// The regular grids of at most so many rays.
pub(crate) fn grids(most_rays: u32) -> impl Iterator<Item = Sampling> {
    SIDES.into_iter().filter(move |side| side.pow(2) <= most_rays).map(Sampling::Grid)
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

    /// Of edges, too: from regular grids, each finer than the one before, until two differ by a quarter of
    /// the accuracy or the next one has more than `most_rays` through a pixel.
    pub fn of_grids(
        evaluator: &mut Evaluator<'_>,
        metric: &GradientMetric,
        bounces: u32,
        most_rays: u32,
        accuracy: f64,
    ) -> Self {
        let arithmetic = Arithmetic::fastest(Precision::F64);
        let mut finest = Self { gradient: vec![0.0; metric.count()], error: f64::INFINITY };
        for (index, sampling) in grids(most_rays).enumerate() {
            let gradient = evaluator.gradient(&Setting { arithmetic, bounces, sampling });
            let moved = metric.error(&finest.gradient, &gradient);
            finest = Self { gradient, error: if index == 0 { f64::INFINITY } else { moved } };
            if 4.0 * finest.error <= accuracy {
                break;
            }
        }
        finest
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
                let gradient = GradientSamples::Independent;
                let samples = Samples { count: 2 * count, seed, gradient };
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
