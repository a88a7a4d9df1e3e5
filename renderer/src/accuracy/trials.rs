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
    let exact = |arithmetic| Setting { arithmetic, bounces: work.most_bounces(), sampling };
    let reference = evaluator.gradient(&exact(Arithmetic::F64x8));
    // What single precision is off by is rounding; double precision has less by the ratio of theirs.
    let single = metric.error(&evaluator.gradient(&exact(Arithmetic::F32x16)), &reference);
    let rounding = ROUNDING * single;
    let trial = |(arithmetic, bounces)| {
        let setting = Setting { arithmetic, bounces, sampling };
        let error = metric.error(&evaluator.gradient(&setting), &reference).max(rounding);
        Trial { setting, error, work: work.of(&setting) }
    };
    kinds(work).into_iter().map(trial).collect()
}
