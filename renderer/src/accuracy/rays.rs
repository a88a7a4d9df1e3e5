//! How many rays through each pixel are worth it, tried on the scene.
//!
//! A pixel of a photo is an integral, and the gradient from some rays misses that of the integral by
//! noise and, where the derivative is on the rays of the radiance, by a bias. Both are measured: the
//! error of a setting is the root mean square over several seeds of how far its gradient is off a
//! reference with all mirrors, in double precision, so that what mirrors and rounding bring is in it
//! too. Settings are tried from the cheapest on, but for those that cannot be enough by what is known of
//! fewer rays; and with as few seeds as tell that they are within the accuracy or not.
//!
//! Gradients that see edges have regular grids and no seeds. Their reference is a grid so fine that the
//! next coarser one gives nearly the same.

use super::reference::{IntegralGradient, grids};
use super::work::Work;
use super::{Evaluator, GradientMetric, Kind, Sampler, Setting, Trial, most_accurate, trials};
use crate::scene::Integrator;
use crate::settings::{GradientSamples, Samples, Sampling};

/// More rays in an image are not tried: a gradient would take about a second.
const MOST_IN_IMAGE: u64 = 1 << 24;

/// The rays on which mirrors and precisions are compared.
const RAYS_OF_TRIALS: u32 = 4;

/// So many seeds may tell whether a setting is within the accuracy; if they do not, so many more.
const SEEDS: [u32; 4] = [8, 16, 32, 64];
/// The accuracy is so many standard errors above what is taken, and so many below what is not. Who is
/// wrong in taking breaks a promise, and who is wrong in leaving takes the next one.
const TAKEN: f64 = 3.0;
const LEFT: f64 = 1.5;

/// What settings are worth, from the cheapest on to the first that is within the accuracy.
pub(super) fn trials_with_rays(
    evaluator: &mut Evaluator<'_>,
    metric: &GradientMetric,
    work: &Work,
    (sampler, most): (Sampler, u32),
    accuracy: f64,
) -> Vec<Trial> {
    let scene = evaluator.recovery().scene();
    let [width, height] = scene.size();
    let pixels = u64::from(width) * u64::from(height);
    let most = most.min((MOST_IN_IMAGE / pixels.max(1)) as u32).max(1);
    let bounces = work.most_bounces();
    let (reference, mut samplings): (_, Vec<Sampling>) = match evaluator.has_edges() {
        true => {
            let reference = IntegralGradient::of_grids(evaluator, metric, bounces, most, accuracy);
            (reference, grids(most).collect())
        }
        false => {
            let reference =
                IntegralGradient::within(evaluator, metric, sampler, bounces, most, accuracy);
            let samplings = |count| match scene.integrator {
                Integrator::Direct => sampler.sampling(count),
                // One path is as random as many.
                Integrator::Path(_) => {
                    sampler.random(Samples { count, seed: 0, gradient: GradientSamples::Same })
                }
            };
            (reference, sampler.counts(most).into_iter().map(samplings).collect())
        }
    };
    if reference.error > accuracy {
        // It has more rays than any setting: the most are still too few.
        samplings.drain(..samplings.len() - 1);
    }
    let kinds = trials::kinds(work);
    let mut settings: Vec<Setting> = samplings
        .into_iter()
        .flat_map(|sampling| kinds.iter().map(move |kind| (kind, sampling)))
        .map(|(&(arithmetic, bounces), sampling)| Setting { arithmetic, bounces, sampling })
        .collect();
    settings.sort_by(|a, b| work.of(a).total_cmp(&work.of(b)));
    let mut worth = None;
    let mut trials = Vec::new();
    let mut tried = Vec::new();
    for setting in settings {
        // A ray through the middle is one gradient, so there is no need to guess.
        if !is_middle(setting.sampling) {
            let worth = worth.get_or_insert_with(|| {
                let shared = match setting.sampling {
                    grid @ Sampling::Grid(_) => grid,
                    _ => sampler.sampling(RAYS_OF_TRIALS.min(most)),
                };
                worth_trying(trials::trials(evaluator, metric, work, shared), accuracy)
            });
            if !worth.contains(&setting.kind())
                || tried.iter().any(|tried| rules_out(tried, &setting, accuracy))
            {
                continue;
            }
        }
        let estimate = estimate(evaluator, metric, &reference, &setting, sampler, accuracy);
        trials.push(Trial { setting, error: estimate.error, work: work.of(&setting) });
        if estimate.error <= accuracy {
            break;
        }
        tried.push((setting, estimate));
    }
    trials
}

/// Whether the only ray goes through the middle of a pixel.
fn is_middle(sampling: Sampling) -> bool {
    matches!(sampling, Sampling::Center | Sampling::Grid(1))
}

/// Whether a setting that was tried tells that another one, which differs in the number of rays alone,
/// is not within the accuracy: bias falls with that number, and noise hardly faster.
fn rules_out((tried, estimate): &(Setting, Estimate), other: &Setting, accuracy: f64) -> bool {
    let count = |setting: &Setting| f64::from(setting.sampling.count());
    // The middle of a pixel says nothing of other places.
    tried.kind() == other.kind()
        && !is_middle(tried.sampling)
        && estimate.at_least * count(tried) / count(other) > accuracy
}

/// Which precisions and numbers of mirrors can be within the accuracy, the cheapest first; those left
/// out that come closer than cheaper ones by less than a tenth of the accuracy. The most accurate if
/// there is none.
fn worth_trying(mut trials: Vec<Trial>, accuracy: f64) -> Vec<Kind> {
    trials.sort_by(|a, b| a.work.total_cmp(&b.work));
    let mut closest = f64::INFINITY;
    let mut kinds = Vec::new();
    for trial in trials.iter().filter(|trial| trial.error <= accuracy) {
        if trial.error < closest - accuracy / 10.0 {
            closest = trial.error;
            kinds.push(trial.setting.kind());
        }
    }
    if kinds.is_empty() {
        kinds.extend(most_accurate(&trials).map(|trial| trial.setting.kind()));
    }
    kinds
}

/// What is known of the error of a setting.
struct Estimate {
    /// The error, to which its own uncertainty is added.
    error: f64,
    /// It is hardly less than this.
    at_least: f64,
}

fn estimate(
    evaluator: &mut Evaluator<'_>,
    metric: &GradientMetric,
    reference: &IntegralGradient,
    setting: &Setting,
    sampler: Sampler,
    accuracy: f64,
) -> Estimate {
    let count = setting.sampling.count();
    let mut error =
        |setting: &Setting| metric.error(&evaluator.gradient(setting), &reference.gradient);
    if matches!(setting.sampling, Sampling::Center | Sampling::Grid(_)) {
        let error = error(setting);
        return Estimate { error: error.hypot(reference.error), at_least: 0.0 };
    }
    let mut errors = Vec::new();
    let mut estimate = Estimate { error: f64::INFINITY, at_least: 0.0 };
    for seeds in SEEDS {
        errors.extend((errors.len() as u32..seeds).map(|seed| {
            let samples = Samples { count, seed, gradient: GradientSamples::Same };
            error(&Setting { sampling: sampler.random(samples), ..*setting })
        }));
        let (mean, uncertainty) = root_mean_square(&errors);
        estimate = Estimate { error: mean + uncertainty, at_least: mean - LEFT * uncertainty };
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
