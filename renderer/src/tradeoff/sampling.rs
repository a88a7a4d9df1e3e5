//! Rays per pixel: bias and spread of gradients against time.

use std::time::Instant;

use ad::lanes::{f32x16, f64x8};

use super::engine::{Adjoint, Engine, Question};
use super::measurement::Reference;
use crate::accuracy::{GradientMetric, image_error};
use crate::integrator::{GradientSamples, RenderSettings, Samples, Sampling};
use crate::recovery::Recovery;

/// So many rays per pixel through so many seeds.
#[derive(Clone, Debug, PartialEq)]
pub struct SamplingRun {
    /// Where rays go within pixels.
    pub sampler: &'static str,
    /// Whether the derivative of the radiance has rays of its own.
    pub gradient: GradientSamples,
    /// Rays for each pixel.
    pub count: u32,
    /// Seconds of a gradient: the median over the seeds.
    pub seconds: f64,
    /// The relative error of the image with the first seed.
    pub image_error: f64,
    /// How far the mean of the gradients over the seeds is off.
    pub bias: f64,
    /// The root mean square of how far single gradients are from that mean.
    pub spread: f64,
    /// The root mean square of how far single gradients are off.
    pub error: f64,
}

/// The rays per pixel that are compared.
const COUNTS: [u32; 5] = [1, 4, 16, 64, 256];
/// And those of the reference.
const REFERENCE_COUNT: u32 = 1024;
/// Gradients of each setting, each with a seed of its own.
const SEEDS: u32 = 8;
/// Settings of more rays in an image are left out, and the reference has so many at most.
const MOST_RAYS: u64 = 1 << 23;

/// A way to place rays.
type Sampler = fn(Samples) -> Sampling;

/// Gradients with several rays for each pixel, against one in double precision with many more.
pub fn measure_sampling(recovery: &Recovery<'_>) -> Vec<SamplingRun> {
    let scene = recovery.scene();
    let pixels = u64::from(scene.width) * u64::from(scene.height);
    let possible = |count: u32| u64::from(count) * pixels <= MOST_RAYS;
    let settings = |sampling| RenderSettings { sampling, ..*recovery.render_settings() };
    let reference = {
        let count = (1..=10).map(|k| 1 << k).take_while(|&count| possible(count)).last();
        let count = count.unwrap_or(1).min(REFERENCE_COUNT);
        let samples = Samples { count, seed: u32::MAX, gradient: GradientSamples::Same };
        let question = Question { recovery, settings: settings(Sampling::Sobol(samples)) };
        let mut exact = Adjoint::<f64x8>::new(question, false);
        Reference {
            metric: GradientMetric::new(scene, recovery.ids()),
            gradient: exact.gradient(),
            image: exact.image().expect("the adjoint has an image"),
        }
    };
    let samplers: [(&str, Sampler); 2] =
        [("stratified", Sampling::Stratified), ("Sobol'", Sampling::Sobol)];
    let mut runs = Vec::new();
    for (sampler, sampling) in samplers {
        for gradient in [GradientSamples::Same, GradientSamples::Independent] {
            for count in COUNTS.into_iter().filter(|&count| possible(4 * count)) {
                let of_seed = |seed| settings(sampling(Samples { count, seed, gradient }));
                let engines = (0..SEEDS).map(|seed| {
                    let question = Question { recovery, settings: of_seed(seed) };
                    Adjoint::<f32x16>::new(question, false)
                });
                runs.push(run(sampler, gradient, count, engines, &reference));
            }
        }
    }
    runs
}

fn run<'a>(
    sampler: &'static str,
    gradient: GradientSamples,
    count: u32,
    engines: impl Iterator<Item = Adjoint<'a, f32x16>>,
    reference: &Reference,
) -> SamplingRun {
    let Reference { metric, gradient: truth, image } = reference;
    let (mut gradients, mut times, mut image_off) = (Vec::new(), Vec::new(), None);
    for mut engine in engines {
        engine.leave();
        let clock = Instant::now();
        gradients.push(engine.gradient());
        times.push(clock.elapsed().as_secs_f64());
        image_off.get_or_insert_with(|| {
            engine.image().map_or(0.0, |rendered| image_error(&rendered, image))
        });
    }
    times.sort_by(f64::total_cmp);
    let number = gradients.len() as f64;
    let mean: Vec<f64> = (0..truth.len())
        .map(|i| gradients.iter().map(|gradient| gradient[i]).sum::<f64>() / number)
        .collect();
    let root_mean_square = |f: &dyn Fn(&[f64]) -> f64| {
        (gradients.iter().map(|gradient| f(gradient).powi(2)).sum::<f64>() / number).sqrt()
    };
    let off = |i: usize, gradient: &[f64]| truth[i] + gradient[i] - mean[i];
    SamplingRun {
        sampler,
        gradient,
        count,
        seconds: times[times.len() / 2],
        image_error: image_off.unwrap_or(0.0),
        bias: metric.error(&mean, truth),
        // The distance from the mean, relative to the truth.
        spread: root_mean_square(&|gradient| {
            let shifted: Vec<f64> = (0..truth.len()).map(|i| off(i, gradient)).collect();
            metric.error(&shifted, truth)
        }),
        error: root_mean_square(&|gradient| metric.error(gradient, truth)),
    }
}

/// A table for people.
pub fn sampling_table(runs: &[SamplingRun]) -> String {
    let mut lines = vec![format!(
        "{:<12} {:<12} {:>5} {:>12} {:>10} {:>10} {:>10} {:>10}",
        "rays", "derivative's", "count", "gradient, ms", "image off", "bias", "spread", "off"
    )];
    lines.extend(runs.iter().map(|run| {
        let SamplingRun { sampler, gradient, count, seconds, image_error, bias, spread, error } = run;
        let own = match gradient {
            GradientSamples::Same => "the same",
            GradientSamples::Independent => "its own",
        };
        format!(
            "{sampler:<12} {own:<12} {count:>5} {:>12.3} {image_error:>10.1e} {bias:>10.1e} {spread:>10.1e} {error:>10.1e}",
            1e3 * seconds
        )
    }));
    lines.join("\n")
}
