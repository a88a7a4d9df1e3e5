//! Rays per pixel: bias and spread of gradients against time.

use std::time::Instant;

use super::engine::{Adjoint, Engine, Question};
use super::measurement::Reference;
use super::plot::Curve;
use crate::accuracy::{Evaluator, GradientMetric, IntegralGradient, Sampler, image_error};
use crate::arithmetic::Arithmetic;
use crate::recovery::Recovery;
use crate::settings::{GradientSamples, Samples, Sampling, Settings};

/// So many rays per pixel through so many seeds.
#[derive(Clone, Debug, PartialEq)]
pub struct SamplingRun {
    /// Where rays go within pixels.
    pub rays: RayPlaces,
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

/// Where rays go within pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RayPlaces {
    /// One through the middle.
    Middle,
    /// Several; whether the derivative of the radiance has rays of its own.
    Random(Sampler, GradientSamples),
}

impl RayPlaces {
    /// The middle, and both samplers with either rays for the derivative.
    pub fn all() -> impl Iterator<Item = Self> {
        let random = Sampler::ALL.into_iter().flat_map(|sampler| {
            let derivatives = [GradientSamples::Same, GradientSamples::Independent];
            derivatives.map(|gradient| Self::Random(sampler, gradient))
        });
        std::iter::once(Self::Middle).chain(random)
    }

    /// Words for tables and legends.
    pub fn name(self) -> String {
        match self {
            Self::Middle => "the middle".into(),
            Self::Random(sampler, GradientSamples::Same) => sampler.name().into(),
            Self::Random(sampler, GradientSamples::Independent) => {
                format!("{}, derivative's own", sampler.name())
            }
        }
    }

    fn sampling(self, count: u32, seed: u32) -> Sampling {
        match self {
            Self::Middle => Sampling::Center,
            Self::Random(sampler, gradient) => sampler.random(Samples { count, seed, gradient }),
        }
    }
}

/// What came out for rays.
#[derive(Clone, Debug, PartialEq)]
pub struct SamplingRuns {
    /// The runs, by where rays go, then by their count.
    pub runs: Vec<SamplingRun>,
    /// The relative standard error of the gradient that they are measured against.
    pub reference_error: f64,
}

/// The rays per pixel that are compared.
const COUNTS: [u32; 5] = [1, 4, 16, 64, 256];
/// And those of the reference's image. Its gradient is the mean of as many as are compared, eight
/// times.
const REFERENCE_COUNT: u32 = 1024;
/// Gradients of each setting, each with a seed of its own.
const SEEDS: u32 = 8;
/// Settings of more rays in an image are left out.
const MOST_RAYS: u64 = 1 << 21;

/// Gradients with several rays for each pixel, against the one of pixels that are integrals. Both are interior terms:
/// rays that are no grid see no edges.
pub fn measure_sampling(recovery: &Recovery<'_>) -> SamplingRuns {
    let scene = recovery.scene();
    let pixels = u64::from(scene.width) * u64::from(scene.height);
    let most_of = |rays: u64, limit: u32| (rays / pixels.max(1)).clamp(1, limit.into()) as u32;
    let most = most_of(MOST_RAYS, COUNTS[COUNTS.len() - 1]);
    let question = |sampling| {
        let arithmetic = Arithmetic::default();
        let settings = Settings { sampling, arithmetic, ..*recovery.render_settings() };
        Question { recovery, settings }
    };
    let metric = GradientMetric::new(scene, recovery.ids());
    let sampler = Sampler::Sobol;
    let evaluator = &mut Evaluator::new(recovery);
    let integral = IntegralGradient::new(evaluator, &metric, sampler, scene.bounces, most);
    let image = {
        let count = most_of(4 * MOST_RAYS, REFERENCE_COUNT);
        let samples = Samples { count, seed: u32::MAX, gradient: GradientSamples::Same };
        let question = question(sampler.random(samples));
        let settings = question.settings.in_double_precision();
        let exact = Adjoint::new(Question { settings, ..question });
        exact.image().expect("the adjoint has an image")
    };
    let reference = Reference { metric, gradient: integral.gradient, image };
    let mut engine = Adjoint::new(question(Sampling::Center));
    let mut runs = Vec::new();
    for rays in RayPlaces::all() {
        let (counts, seeds) = match rays {
            RayPlaces::Middle => (&COUNTS[..1], 1),
            RayPlaces::Random(..) => (&COUNTS[..], SEEDS),
        };
        for &count in counts.iter().filter(|&&count| count <= most) {
            runs.push(run(rays, count, seeds, &mut engine, &reference));
        }
    }
    SamplingRuns { runs, reference_error: integral.error }
}

fn run(
    rays: RayPlaces,
    count: u32,
    seeds: u32,
    engine: &mut Adjoint<'_>,
    reference: &Reference,
) -> SamplingRun {
    let Reference { metric, gradient: truth, image } = reference;
    let (mut gradients, mut times, mut image_off) = (Vec::new(), Vec::new(), None);
    for seed in 0..seeds {
        engine.set_sampling(rays.sampling(count, seed));
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
        rays,
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
pub fn sampling_table(SamplingRuns { runs, reference_error }: &SamplingRuns) -> String {
    let mut lines = vec![format!(
        "{:<28} {:>5} {:>12} {:>10} {:>10} {:>10} {:>10}",
        "rays", "count", "gradient, ms", "image off", "bias", "spread", "off"
    )];
    lines.extend(runs.iter().map(|run| {
        let SamplingRun { rays, count, seconds, image_error, bias, spread, error } = run;
        format!(
            "{:<28} {count:>5} {:>12.3} {image_error:>10.1e} {bias:>10.1e} {spread:>10.1e} {error:>10.1e}",
            rays.name(),
            1e3 * seconds
        )
    }));
    lines.push(format!(
        "Interior terms, without edges that move, against those of pixels that are integrals, known to \
         {reference_error:.0e}. Bias: the mean over {SEEDS} seeds; spread: single ones about that mean; off: both. \
         A bias below a third of the spread is noise. Rays of the derivative's own are as many again."
    ));
    lines.join("\n")
}

/// The runs as comma-separated values.
pub fn sampling_csv(SamplingRuns { runs, .. }: &SamplingRuns) -> String {
    let mut text = "rays,count,seconds,image_error,bias,spread,error\n".to_owned();
    for run in runs {
        let SamplingRun { rays, count, seconds, image_error, bias, spread, error } = run;
        text += &format!(
            "\"{}\",{count},{seconds:e},{image_error:e},{bias:e},{spread:e},{error:e}\n",
            rays.name()
        );
    }
    text
}

/// Bias and spread over rays per pixel.
pub fn sampling_curves(SamplingRuns { runs, .. }: &SamplingRuns) -> Vec<Curve> {
    let random = RayPlaces::all().filter(|&rays| rays != RayPlaces::Middle);
    let curves = random.enumerate().flat_map(|(color, rays)| {
        let curve = |what: &str, is_dashed, of: fn(&SamplingRun) -> f64| {
            let points = runs.iter().filter(|run| run.rays == rays);
            let points = points.map(|run| (f64::from(run.count), of(run))).collect();
            Curve { label: format!("{what}, {}", rays.name()), points, color, is_dashed }
        };
        [curve("spread", false, |run| run.spread), curve("bias", true, |run| run.bias)]
    });
    curves.collect()
}
