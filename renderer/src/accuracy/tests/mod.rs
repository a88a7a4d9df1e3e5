//! The selection on generated scenes.

mod edges;
mod rays;

use super::*;
use crate::arithmetic::Precision;
use crate::tradeoff::{gradient_on_tapes, random_experiment, without_edges};

/// What is asked for, in turns.
const ACCURACIES: [f64; 5] = [0.1, 1e-2, 1e-3, 1e-5, 1e-9];
const SCENES: u64 = 20;

/// The true error is that against the gradient on tapes, which shares no code with the trials but
/// the kernels.
#[test]
fn picks_are_as_accurate_as_asked_and_nearly_as_cheap_as_can_be() {
    let mut within = 0;
    let mut selected = Vec::new();
    for number in 0..SCENES {
        let experiment = random_experiment(100 + number);
        let exact = without_edges().in_double_precision();
        let recovery = Recovery::new(&experiment, "a generated scene", &exact).unwrap();
        let truth = gradient_on_tapes(&recovery);
        let metric = GradientMetric::new(recovery.scene(), recovery.ids());
        let true_error = |trial: &Trial| {
            let computed = trial.setting.apply(&recovery);
            metric.error(&computed.evaluate().unwrap().gradient, &truth)
        };

        let accuracy = ACCURACIES[number as usize % ACCURACIES.len()];
        let select = select(&recovery, accuracy, Rays::Given);
        assert!(select.is_within(), "{number}: {select}");
        within += u64::from(true_error(&select.best) <= accuracy);
        let meeting = select.trials.iter().filter(|trial| true_error(trial) <= accuracy);
        let cheapest = meeting.map(|trial| trial.work).fold(f64::INFINITY, f64::min);
        assert!(select.best.work <= 1.5 * cheapest, "{number}: {cheapest} is enough: {select}");
        selected.push(select.best.setting);
    }
    assert!(20 * within >= 19 * SCENES, "{within} of {SCENES} are within");
    // The selection has something to choose.
    let precisions = [Precision::F32, Precision::F64];
    for precision in precisions {
        assert!(selected.iter().any(|setting| setting.arithmetic.precision() == precision));
    }
    assert!(selected.iter().any(|setting| setting.bounces == 0));
    assert!(selected.iter().any(|setting| setting.bounces > 1));
}

#[test]
fn what_cannot_be_met_is_said_to() {
    let experiment = random_experiment(1);
    let exact = without_edges().in_double_precision();
    let recovery = Recovery::new(&experiment, "a generated scene", &exact).unwrap();
    let select = select(&recovery, 1e-18, Rays::Given);
    assert!(!select.is_within());
    assert_eq!(select.best.setting.arithmetic, exact.arithmetic);
    assert!(select.to_string().starts_with("accuracy 1e-18 cannot be met: f64x8"), "{select}");
    assert!(select.trials.iter().all(|trial| trial.error >= select.best.error));
}
