//! How many rays through each pixel are worth it, tried on the scene.
//!
//! A pixel of a photo is an integral, and the gradient from some rays misses that of the integral by
//! noise and, where the derivative is on the rays of the radiance, by a bias. Both are measured: the
//! error of a setting is the root mean square over several seeds of how far its gradient is off a
//! reference with all mirrors, in double precision, so that what mirrors and rounding bring is in it
//! too. Settings are tried from the cheapest on.

use super::reference::IntegralGradient;
use super::work::Work;
use super::{GradientMetric, Pilot, Sampler, Setting, pilots};
use crate::integrator::{GradientSamples, Samples};
use crate::recovery::Recovery;

/// More rays in an image are not tried: a gradient would take about a second.
const MOST_IN_IMAGE: u64 = 1 << 24;

/// The rays on which mirrors and precisions are compared.
const RAYS_OF_PILOTS: u32 = 16;

/// So many seeds may tell whether a setting is within the accuracy; if they do not, so many more.
const SEEDS: [u32; 4] = [8, 16, 32, 64];
/// The accuracy is so many standard errors above what is taken, and so many below what is not. Who is
/// wrong in taking breaks a promise, and who is wrong in leaving takes the next one.
const TAKEN: f64 = 3.0;
const LEFT: f64 = 1.5;

/// What settings are worth, from the cheapest on to the first that is within the accuracy.
pub(super) fn pilots_with_rays(
    recovery: &Recovery<'_>,
    metric: &GradientMetric,
    work: &Work,
    (sampler, most): (Sampler, u32),
    accuracy: f64,
) -> Vec<Pilot> {
    let scene = recovery.scene();
    let pixels = u64::from(scene.width) * u64::from(scene.height);
    let most = most.min((MOST_IN_IMAGE / pixels.max(1)) as u32).max(1);
    let shared = sampler.sampling(RAYS_OF_PILOTS.min(most));
    let all = pilots::pilots(recovery, metric, work, shared);
    let reference =
        IntegralGradient::within(recovery, metric, sampler, work.most_bounces(), most, accuracy);
    let mut counts = sampler.counts(most);
    if reference.error > accuracy {
        // It has more rays than any setting: the most are still too few.
        counts.drain(..counts.len() - 1);
    }
    let with = |kind: &Setting, count: u32| Setting { sampling: sampler.sampling(count), ..*kind };
    let worth_trying = worth_trying(&all, accuracy);
    let mut settings = Vec::new();
    for count in counts {
        match count {
            // It is one gradient each, so there is no need to guess.
            1 => settings.extend(all.iter().map(|pilot| with(&pilot.setting, 1))),
            _ => settings.extend(worth_trying.iter().map(|kind| with(kind, count))),
        }
    }
    settings.sort_by(|a, b| work.of(a).total_cmp(&work.of(b)));
    let mut pilots = Vec::new();
    for setting in settings {
        let error = error(recovery, metric, &reference, &setting, sampler, accuracy);
        pilots.push(Pilot { setting, error, work: work.of(&setting) });
        if error <= accuracy {
            break;
        }
    }
    pilots
}

/// Which precisions and numbers of mirrors can be within the accuracy, the cheapest first; those left
/// out that come closer than cheaper ones by less than a tenth of the accuracy. The most accurate if
/// there is none.
fn worth_trying(pilots: &[Pilot], accuracy: f64) -> Vec<Setting> {
    let mut pilots = pilots.to_vec();
    pilots.sort_by(|a, b| a.work.total_cmp(&b.work));
    let mut closest = f64::INFINITY;
    let mut settings = Vec::new();
    for pilot in pilots.iter().filter(|pilot| pilot.error <= accuracy) {
        if pilot.error < closest - accuracy / 10.0 {
            closest = pilot.error;
            settings.push(pilot.setting);
        }
    }
    if settings.is_empty() {
        let most_accurate = pilots.iter().min_by(|a, b| a.error.total_cmp(&b.error));
        settings.extend(most_accurate.map(|pilot| pilot.setting));
    }
    settings
}

/// The estimated error of a setting, to which its own uncertainty is added.
fn error(
    recovery: &Recovery<'_>,
    metric: &GradientMetric,
    reference: &IntegralGradient,
    setting: &Setting,
    sampler: Sampler,
    accuracy: f64,
) -> f64 {
    let count = setting.sampling.count();
    let error = |setting: &Setting| metric.error(&setting.gradient(recovery), &reference.gradient);
    if count == 1 {
        return error(setting) + reference.error;
    }
    let mut errors = Vec::new();
    let mut estimate = f64::INFINITY;
    for seeds in SEEDS {
        errors.extend((errors.len() as u32..seeds).map(|seed| {
            let samples = Samples { count, seed, gradient: GradientSamples::Same };
            error(&Setting { sampling: sampler.random(samples), ..*setting })
        }));
        let (mean, uncertainty) = root_mean_square(&errors);
        estimate = mean + uncertainty;
        if mean + TAKEN * uncertainty <= accuracy || mean - LEFT * uncertainty > accuracy {
            break;
        }
    }
    estimate
}

/// The root of the mean of squares, and its standard error.
fn root_mean_square(numbers: &[f64]) -> (f64, f64) {
    let count = numbers.len() as f64;
    let mean = numbers.iter().map(|x| x * x).sum::<f64>() / count;
    if mean == 0.0 {
        return (0.0, 0.0);
    }
    let variance = numbers.iter().map(|x| (x * x - mean).powi(2)).sum::<f64>() / (count - 1.0);
    let root = mean.sqrt();
    // The derivative of the root brings the 2.
    (root, (variance / count).sqrt() / (2.0 * root))
}
