//! Images that take samples until their noise is low enough, or time is up.
//!
//! Where light takes all paths, an image is the mean of random ones, and how far these lie apart says how far
//! their mean is off. So samples are taken in batches that know nothing of each other, each with a seed of its
//! own. Turned down: one Sobol' sequence over all samples, whose noise is lower at the same count, but whose
//! error a single run does not tell.

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use crate::Image;
use crate::render::Renderer;
use crate::settings::Sampling;

/// When an image is good enough. Without an error and without a time it never is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Until {
    /// The [error](Progress::error) at most.
    pub error: Option<f64>,
    /// The time after which no batch begins that would likely end later. The first batch is of one sample, and
    /// each other of as many as likely take half of the time that is left, up to those of the sampling. Two
    /// batches are always taken.
    pub time: Option<Duration>,
}

/// How far an image has come.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// How many samples each pixel has.
    pub samples: u64,
    /// The root mean square, over pixels and channels, of the standard errors, over the mean radiance. It is an
    /// estimate, 0 for a black image, and infinite after the first batch, which says nothing of it.
    pub error: f64,
    /// The time that it took.
    pub elapsed: Duration,
}

/// An image and how far it is off.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// The mean of all samples.
    pub image: Image,
    /// The standard error of each number of the image; infinite after a single batch.
    pub standard_error: Image,
    /// Of the last batch.
    pub progress: Progress,
}

/// Renders batches of this sampling, the first with its seed and each other with one of its own, until one of the
/// limits is reached or `observe`, which sees the progress after each, breaks. The renderer keeps this sampling,
/// with the seed of the last batch.
///
/// For a number of batches, the image is the same bit for bit on any number of threads; how many there are
/// depends on the machine if the time is limited. Batches of a sampling without a seed are equal.
pub fn render_until(
    renderer: &mut Renderer,
    sampling: Sampling,
    until: Until,
    mut observe: impl FnMut(&Progress) -> ControlFlow<()>,
) -> Estimate {
    let start = Instant::now();
    let mut batches = Batches::default();
    let mut samples = 0;
    let mut count = if until.time.is_some() { 1 } else { sampling.count() };
    loop {
        let begun = start.elapsed();
        let batch = sampling.batch(count, batches.count);
        renderer.resample(batch);
        let image = renderer.render();
        let size = [image.width, image.height];
        let part = f64::from(batch.count()) / f64::from(sampling.count());
        batches.add(image.pixels.as_flattened(), part);
        samples += u64::from(batch.count());
        let elapsed = start.elapsed();
        let progress = Progress { samples, error: batches.error(), elapsed };
        let left = until.time.map(|time| time.saturating_sub(elapsed));
        let of_one = (elapsed - begun) / batch.count();
        let is_over = left.is_some_and(|left| left < of_one)
            || until.error.is_some_and(|error| progress.error <= error)
            || batches.count == u32::MAX;
        let is_known = batches.count > 1;
        if observe(&progress).is_break() || is_known && is_over {
            renderer.resample(sampling.batch(sampling.count(), batches.count - 1));
            return batches.estimate(size, progress);
        }
        if let Some(left) = left {
            count = ((left / 2).div_duration_f64(of_one) as u32).clamp(1, sampling.count());
        }
    }
}

/// The mean of batches by their samples, and how they spread about it (West, "Updating Mean and Variance
/// Estimates: An Improved Method", 1979).
#[derive(Default)]
struct Batches {
    count: u32,
    /// The samples of all, over those of a whole batch.
    weight: f64,
    mean: Vec<f64>,
    /// The sums of the squared differences from the mean, by samples.
    squares: Vec<f64>,
}

impl Batches {
    /// Adds a batch, and which part of the samples of a whole one it has.
    fn add(&mut self, numbers: &[f32], part: f64) {
        self.mean.resize(numbers.len(), 0.0);
        self.squares.resize(numbers.len(), 0.0);
        self.count += 1;
        self.weight += part;
        for ((mean, squares), &number) in self.mean.iter_mut().zip(&mut self.squares).zip(numbers) {
            let before = f64::from(number) - *mean;
            // Exactly 1 for the first batch, whose mean is exact then, and no square is negative.
            *mean += before / (self.weight / part);
            *squares += part * before * (f64::from(number) - *mean);
        }
    }

    /// The squared standard errors of the means.
    fn variances(&self) -> impl Iterator<Item = f64> {
        let others = f64::from(self.count) - 1.0;
        self.squares.iter().map(move |squares| match self.count {
            1 => f64::INFINITY,
            _ => squares / (self.weight * others),
        })
    }

    fn error(&self) -> f64 {
        let count = self.mean.len() as f64;
        let mean = self.mean.iter().map(|mean| mean.abs()).sum::<f64>() / count;
        let variance = self.variances().sum::<f64>() / count;
        if mean == 0.0 { 0.0 } else { variance.sqrt() / mean }
    }

    fn estimate(&self, [width, height]: [u32; 2], progress: Progress) -> Estimate {
        let image = |numbers: Vec<f32>| {
            let (pixels, _) = numbers.as_chunks();
            Image { width, height, pixels: pixels.to_vec() }
        };
        Estimate {
            image: image(self.mean.iter().map(|&mean| mean as f32).collect()),
            standard_error: image(self.variances().map(|of| of.sqrt() as f32).collect()),
            progress,
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::{DVec3, dvec3};

    use super::*;
    use crate::scene::{Integrator, PathTracing};
    use crate::settings::{GradientSamples, Samples, Settings};
    use crate::{Camera, Material, Mesh, Scene};

    /// A floor below a lamp.
    fn scene(samples: u32) -> Scene {
        let mut scene = Scene::new(16, 16, Camera::looking(dvec3(0.0, 3.0, 4.0), DVec3::ZERO));
        let path_tracing = PathTracing { max_depth: 3, samples, seed: 0 };
        scene.integrator = Integrator::Path(path_tracing);
        scene.add_material("grey", Material::lambertian(DVec3::splat(0.5))).unwrap();
        let lamp = Material { emission: DVec3::splat(4.0), ..Material::lambertian(DVec3::ZERO) };
        scene.add_material("lamp", lamp).unwrap();
        let quad = |name: &str, side: f64, height: f64| {
            let corners = [[-side, -side], [side, -side], [side, side], [-side, side]];
            let corners = corners.map(|[x, z]| [x, height, z]).to_vec();
            Mesh::new(name, corners, vec![[0, 1, 2], [0, 2, 3]])
        };
        scene.add_mesh(quad("floor", 3.0, 0.0)).unwrap();
        scene.add_mesh(quad("lamp", 0.5, 2.0).material(1)).unwrap();
        scene
    }

    fn rendered(until: Until, batches: u64) -> (Estimate, Vec<f64>) {
        let mut renderer = Renderer::new(&scene(4), &Settings::default()).unwrap();
        let samples = Samples { count: 4, seed: 9, gradient: GradientSamples::Same };
        let sampling = Sampling::Sobol(samples);
        let mut errors = Vec::new();
        let estimate = render_until(&mut renderer, sampling, until, |progress| {
            errors.push(progress.error);
            match progress.samples < 4 * batches {
                true => ControlFlow::Continue(()),
                false => ControlFlow::Break(()),
            }
        });
        (estimate, errors)
    }

    /// The error that is said is the one there is, for each pixel and altogether.
    #[test]
    fn errors_are_those_against_a_converged_image() {
        let (estimate, errors) = rendered(Until::default(), 64);
        let truth = crate::render(&scene(1 << 14), &Settings::default()).unwrap();
        let both = estimate.image.pixels.as_flattened().iter().zip(truth.pixels.as_flattened());
        let squares = both.map(|(found, truth)| f64::from(found - truth).powi(2));
        let numbers = truth.pixels.as_flattened();
        let mean = numbers.iter().map(|&x| f64::from(x)).sum::<f64>() / numbers.len() as f64;
        let off = (squares.sum::<f64>() / numbers.len() as f64).sqrt() / mean;
        let said = estimate.progress.error;
        assert!((0.7..1.4).contains(&(off / said)), "{off}, said to be {said}");
        assert_eq!(estimate.progress.samples, 256);
        assert_eq!(errors[0], f64::INFINITY);
        assert!(errors[63] < 0.4 * errors[7], "{errors:?}");
    }

    /// The first batch tells how long one takes; while there is time, all others are whole.
    #[test]
    fn batches_are_as_long_as_there_is_time() {
        let until = Until { error: None, time: Some(Duration::from_secs(1 << 30)) };
        let (estimate, errors) = rendered(until, 3);
        assert_eq!((estimate.progress.samples, errors.len()), (13, 4));
        assert!(estimate.standard_error.is_finite());
    }

    /// A batch of three samples counts as three of one do.
    #[test]
    fn batches_count_by_their_samples() {
        for whole in 1..100 {
            let mut equal = Batches::default();
            for part in [1.0 / f64::from(whole), 1.0, 0.5] {
                equal.add(&[0.1, 0.7, 1.3], part);
            }
            assert_eq!(equal.variances().collect::<Vec<_>>(), [0.0; 3], "{whole}");
        }
        let mut batches = Batches::default();
        for (number, part) in [(1.0, 0.25), (4.0, 0.75), (2.0, 0.5)] {
            batches.add(&[number], part);
        }
        let mean = (0.25 * 1.0 + 0.75 * 4.0 + 0.5 * 2.0) / 1.5;
        let squares: f64 = [(1.0, 0.25), (4.0, 0.75), (2.0, 0.5)]
            .map(|(number, part): (f64, f64)| part * (number - mean).powi(2))
            .iter()
            .sum();
        let expected = squares / (2.0 * 1.5);
        let found = batches.variances().next().unwrap();
        assert!((batches.mean[0] - mean).abs() < 1e-12 && (found - expected).abs() < 1e-12);
    }

    #[test]
    fn it_ends_when_the_error_or_the_time_is_reached() {
        let (estimate, errors) = rendered(Until { error: Some(0.02), time: None }, u64::MAX / 4);
        assert!(estimate.progress.error <= 0.02 && errors[errors.len() - 2] > 0.02);
        let until = Until { error: None, time: Some(Duration::ZERO) };
        let (estimate, errors) = rendered(until, u64::MAX / 4);
        assert_eq!((estimate.progress.samples, errors.len()), (2, 2));
        let (estimate, _) = rendered(Until::default(), 1);
        assert!(estimate.standard_error.pixels.iter().all(|pixel| *pixel == [f32::INFINITY; 3]));
    }
}
