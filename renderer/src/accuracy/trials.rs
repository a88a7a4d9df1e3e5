//! What precision and mirrors are worth, tried on the scene.

use super::work::Work;
use super::{Evaluator, GradientMetric, Kind, Setting, Trial};
use crate::arithmetic::{Arithmetic, Precision};
use crate::settings::Sampling;

/// How much less double precision rounds than single, with some room for sums that cancel.
const ROUNDING: f64 = 16.0 * f64::EPSILON / f32::EPSILON as f64;

/// Each precision with every number of mirrors up to the scene's.
pub(super) fn kinds(work: &Work) -> Vec<Kind> {
    let precisions = [Precision::F32, Precision::F64].into_iter();
    let bounces = move |arithmetic| (0..=work.most_bounces()).map(move |count| (arithmetic, count));
    precisions.map(Arithmetic::fastest).flat_map(bounces).collect()
}

/// Tries all [`kinds`] on the same rays.
pub(super) fn trials(
    evaluator: &mut Evaluator<'_>,
    metric: &GradientMetric,
    work: &Work,
    sampling: Sampling,
) -> Vec<Trial> {
    let setting = |(arithmetic, bounces)| Setting { arithmetic, bounces, sampling };
    let settings: Vec<Setting> = kinds(work).into_iter().map(setting).collect();
    let gradients: Vec<_> = settings.iter().map(|setting| evaluator.gradient(setting)).collect();
    // With most bounces those of a precision end.
    let [single, reference] =
        [&gradients[work.most_bounces() as usize], &gradients[gradients.len() - 1]];
    // What single precision is off by is rounding; double precision has less by the ratio of theirs.
    let rounding = ROUNDING * metric.error(single, reference);
    let trial = |(setting, gradient): (Setting, &Vec<f64>)| {
        let error = metric.error(gradient, reference).max(rounding);
        Trial { setting, error, work: work.of(&setting) }
    };
    settings.into_iter().zip(&gradients).map(trial).collect()
}
