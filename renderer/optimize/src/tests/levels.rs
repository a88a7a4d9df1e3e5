//! Levels that lead elsewhere than the finest.

use super::*;

/// A parabola whose lowest point is at 0 on the finest level, and elsewhere on coarser ones.
struct Misleading {
    level: u32,
}

impl Objective for Misleading {
    fn begin(&mut self, _: u64, level: u32) {
        self.level = level;
    }

    fn evaluate(&mut self, x: &[f64]) -> Evaluation {
        let d = x[0] - 5.0 * f64::from(self.level);
        Evaluation { loss: d * d + 1.0, gradient: vec![2.0 * d] }
    }
}

/// Keeps all steps.
struct Steps(Vec<Step>);

impl Observer for Steps {
    fn step(&mut self, step: &Step) -> ControlFlow<()> {
        self.0.push(*step);
        ControlFlow::Continue(())
    }
}

fn run_misled(initial: f64, settings: &Settings) -> (Outcome, Vec<Step>) {
    let variables = [Variable::new("x", vec![initial], 0.1)];
    let mut steps = Steps(Vec::new());
    let optimization = Optimization::start(&variables, settings).unwrap();
    (optimization.run(&mut Misleading { level: 0 }, &mut steps).unwrap(), steps.0)
}

#[test]
fn the_beginning_is_kept_where_coarse_levels_lead_away_for_good() {
    let folder = tempfile::tempdir().unwrap();
    let settings = Settings { coarse_to_fine: 2, ..iterations(30) };
    for resume in [false, true] {
        let settings = in_folder(folder.path(), resume, settings.clone());
        let (Outcome { best, last, .. }, _) = run_misled(0.01, &settings);
        assert_eq!(best, Point { iteration: 0, loss: 1.0001, x: vec![0.01] });
        assert!(last.loss > best.loss, "{last:?}");
    }
    let (Outcome { best, .. }, _) = run_misled(20.0, &settings);
    assert!(best.iteration > 20 && best.x[0] < 19.0, "{best:?}");
}

#[test]
fn losses_of_different_levels_have_no_ratio() {
    let settings = Settings { coarse_to_fine: 2, ..iterations(30) };
    let (outcome, steps) = run_misled(0.01, &settings);
    assert_eq!(steps.len(), 31);
    for step in steps {
        let ratio = (step.level == 0).then(|| step.record.loss / outcome.initial_loss);
        assert_eq!(
            (step.level, step.loss_ratio()),
            (2 - step.record.iteration.min(29) as u32 / 10, ratio)
        );
    }
}
