//! The dial on generated scenes.

mod edges;
mod rays;

use super::*;
use crate::arithmetic::Precision;
use crate::tradeoff::{gradient_on_tapes, random_experiment, without_edges};

/// What is asked for, in turns.
const ACCURACIES: [f64; 5] = [0.1, 1e-2, 1e-3, 1e-5, 1e-9];
const SCENES: u64 = 20;

/// The true error is that against the gradient on tapes, which shares no code with the pilots but
/// the kernels.
#[test]
fn picks_are_as_accurate_as_asked_and_nearly_as_cheap_as_can_be() {
    let mut within = 0;
    let mut picked = Vec::new();
    for number in 0..SCENES {
        let experiment = random_experiment(100 + number);
        let exact = without_edges().in_double_precision();
        let recovery = Recovery::new(&experiment, "a generated scene", &exact).unwrap();
        let truth = gradient_on_tapes(&recovery);
        let metric = GradientMetric::new(recovery.scene(), recovery.ids());
        let true_error = |pilot: &Pilot| {
            let computed = pilot.setting.apply(&recovery);
            metric.error(&computed.evaluate().unwrap().gradient, &truth)
        };

        let accuracy = ACCURACIES[number as usize % ACCURACIES.len()];
        let pick = pick(&recovery, accuracy, Rays::Given);
        assert!(pick.is_within(), "{number}: {pick}");
        within += u64::from(true_error(&pick.best) <= accuracy);
        let meeting = pick.pilots.iter().filter(|pilot| true_error(pilot) <= accuracy);
        let cheapest = meeting.map(|pilot| pilot.work).fold(f64::INFINITY, f64::min);
        assert!(pick.best.work <= 1.5 * cheapest, "{number}: {cheapest} is enough: {pick}");
        picked.push(pick.best.setting);
    }
    assert!(20 * within >= 19 * SCENES, "{within} of {SCENES} are within");
    // The dial has something to choose.
    let precisions = [Precision::F32, Precision::F64];
    for precision in precisions {
        assert!(picked.iter().any(|setting| setting.arithmetic.precision() == precision));
    }
    assert!(picked.iter().any(|setting| setting.bounces == 0));
    assert!(picked.iter().any(|setting| setting.bounces > 1));
}

#[test]
fn what_cannot_be_met_is_said_to() {
    let experiment = random_experiment(1);
    let exact = without_edges().in_double_precision();
    let recovery = Recovery::new(&experiment, "a generated scene", &exact).unwrap();
    let pick = pick(&recovery, 1e-18, Rays::Given);
    assert!(!pick.is_within());
    assert_eq!(pick.best.setting.arithmetic, exact.arithmetic);
    assert!(pick.to_string().starts_with("accuracy 1e-18 cannot be met: f64x8"), "{pick}");
    assert!(pick.pilots.iter().all(|pilot| pilot.error >= pick.best.error));
}
