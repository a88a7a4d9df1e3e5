//! What precision and mirrors are worth, tried on the scene.

use super::work::Work;
use super::{GradientMetric, Pilot, Setting};
use crate::arithmetic::{Arithmetic, Precision};
use crate::integrator::Sampling;
use crate::recovery::Recovery;

/// Tries each precision with every number of mirrors up to the scene's, all on the same rays.
pub(super) fn pilots(
    recovery: &Recovery<'_>,
    metric: &GradientMetric,
    work: &Work,
    sampling: Sampling,
) -> Vec<Pilot> {
    let bounces = 0..=work.most_bounces();
    let exact = |arithmetic| Setting { arithmetic, bounces: *bounces.end(), sampling };
    let reference = exact(Arithmetic::F64x8).gradient(recovery);
    // Single numbers go through other functions than lanes: what they differ by is rounding.
    let rounding = metric.error(&exact(Arithmetic::F64).gradient(recovery), &reference);
    let mut pilots = Vec::new();
    for precision in [Precision::F32, Precision::F64] {
        let arithmetic = Arithmetic::fastest(precision);
        for bounces in bounces.clone() {
            let setting = Setting { arithmetic, bounces, sampling };
            let error = metric.error(&setting.gradient(recovery), &reference).max(rounding);
            pilots.push(Pilot { setting, error, work: work.of(&setting) });
        }
    }
    pilots
}
