//! Losses of which each iteration sees a part.

use super::*;

/// Half of the iterations see nothing, the other half a parabola whose lowest point is at 0.
#[derive(Default)]
struct Taking {
    iteration: u64,
}

impl Objective for Taking {
    fn begin(&mut self, iteration: u64, _: u32) {
        self.iteration = iteration;
    }

    fn evaluate(&mut self, x: &[f64]) -> Evaluation {
        let weight = if self.iteration.is_multiple_of(2) { 0.0 } else { 2.0 };
        Evaluation { loss: weight * x[0] * x[0], gradient: vec![2.0 * weight * x[0]] }
    }

    fn full_loss(&mut self, x: &[f64]) -> Option<f64> {
        Some(x[0] * x[0])
    }
}

/// A part that is perfect ends nothing, and what a run came to is said of the whole, however it was interrupted.
#[test]
fn the_whole_decides() {
    let variables = [Variable::new("x", vec![1.0], 0.1)];
    let folder = tempfile::tempdir().unwrap();
    let settings = Settings { tolerance: 1e-4, is_sampled: true, epoch: 2, ..iterations(5) };
    for iterations in [5, 6, 400] {
        let settings = Settings { iterations, ..settings.clone() };
        let settings = in_folder(folder.path(), iterations > 5, settings);
        let optimization = Optimization::start(&variables, &settings).unwrap();
        let outcome = optimization.run(&mut Taking::default(), &mut Quiet).unwrap();
        let Outcome { best, history, initial_loss, stop, .. } = outcome;
        assert_eq!((initial_loss, best.loss), (1.0, best.x[0] * best.x[0]));
        match iterations {
            400 => {
                assert_eq!(stop.reason, StopReason::Tolerance);
                let [.., before, last] = &history[..] else { panic!() };
                assert!(before.loss.midpoint(last.loss) <= 1e-4, "{before:?} {last:?}");
                assert!(best.loss < 1e-3, "{best:?}");
            }
            _ => assert_eq!(
                (stop.reason, history.len() as u64),
                (StopReason::Iterations, iterations + 1)
            ),
        }
    }
}
