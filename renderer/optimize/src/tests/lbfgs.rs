//! L-BFGS: fast where the loss is smooth, within bounds, honest where it is not.

use super::*;

fn lbfgs(settings: Settings) -> Settings {
    Settings { optimizer: Optimizer::Lbfgs(Lbfgs::default()), ..settings }
}

#[test]
fn rosenbrock_takes_tens_of_iterations() {
    let variables = [Variable::new("x", vec![-1.2, 1.0], 0.01)];
    let settings = lbfgs(Settings { gradient_tolerance: 1e-9, ..iterations(100) });
    let outcome = run(&variables, &settings, rosenbrock).unwrap();
    assert_eq!(outcome.stop.reason, StopReason::GradientTolerance, "{:?}", outcome.stop);
    assert!(outcome.best.x.iter().all(|x| (x - 1.0).abs() < 1e-8), "{:?}", outcome.best.x);
    assert!(outcome.last.iteration < 60, "{:?}", outcome.last);
    let evaluations = outcome.evaluations;
    assert!(outcome.last.iteration < evaluations && evaluations < 120, "{evaluations}");
    // A step that does not lower the loss is none.
    assert!(outcome.history.is_sorted_by(|a, b| a.loss > b.loss), "{:?}", outcome.history);
    assert!(outcome.history.iter().zip(0..).all(|(record, i)| record.iteration == i));
}

#[test]
fn scale_of_the_loss_and_of_the_parameters_do_not_matter() {
    let steps = [(1.0, 1.0), (1e-12, 1.0), (1e9, 1e6), (1.0, 1e-6)].map(|(loss, unit)| {
        let variables = [Variable::new("x", vec![5.0 * unit, 3.0 * unit], 0.1 * unit)];
        let settings = lbfgs(Settings { tolerance: 1e-10 * loss, ..iterations(100) });
        let outcome = run(&variables, &settings, |x| {
            let unscaled: Vec<f64> = x.iter().map(|x| x / unit).collect();
            let Evaluation { loss: value, gradient } = quadratic(&unscaled);
            let gradient = gradient.iter().map(|g| loss * g / unit).collect();
            Evaluation { loss: loss * value, gradient }
        })
        .unwrap();
        assert_eq!(outcome.stop.reason, StopReason::Tolerance, "{loss} {unit}");
        outcome.last.iteration
    });
    assert!(steps.iter().all(|n| n.abs_diff(steps[0]) <= 1 && *n < 20), "{steps:?}");
}

#[test]
fn every_point_is_within_bounds() {
    let inf = f64::INFINITY;
    // Minimum: 1 for each. Starts inside, on a bound, and beyond which the minimum lies.
    for (start, min, max, end) in [
        (5.0, 0.0, inf, 1.0),
        (0.0, 0.0, inf, 1.0),
        (0.0, 0.0, 9.0, 1.0),
        (9.0, -3.0, 9.0, 1.0),
        (5.0, 2.0, inf, 2.0),
        (-4.0, -inf, -2.0, -2.0),
        (0.2, 0.0, 0.75, 0.75),
        (0.0, 0.0, 0.75, 0.75),
        (3.0, 3.0, 3.0, 3.0),
    ] {
        let variables = [
            Variable::new("a", vec![start], 0.1).bounded(min, max),
            Variable::new("b", vec![4.0], 0.1),
        ];
        let mut inside = true;
        let outcome = run(&variables, &lbfgs(iterations(60)), |x| {
            inside &= (min..=max).contains(&x[0]);
            quadratic(x)
        })
        .unwrap();
        let x = &outcome.best.x;
        assert!(inside, "{start} {min} {max}");
        assert!(
            (x[0] - end).abs() < 1e-6 && (x[1] - 1.0).abs() < 1e-6,
            "{start} {min} {max}: {x:?}"
        );
    }
}

#[test]
fn a_line_search_that_finds_nothing_lower_stops_the_run() {
    // The gradient points up.
    let wrong = |x: &[f64]| Evaluation { loss: x[0], gradient: vec![-1.0] };
    let variables = [Variable::new("x", vec![5.0], 0.1)];
    let outcome = run(&variables, &lbfgs(iterations(60)), wrong).unwrap();
    assert_eq!(outcome.stop.reason, StopReason::LineSearch);
    let detail = &outcome.stop.detail;
    assert_eq!(
        detail,
        "iteration 0 finds no lower loss: the line search did not end within 30 evaluations, \
         as at a minimum or where the loss jumps"
    );
    assert_eq!((outcome.best.x[0], outcome.history.len()), (5.0, 1));

    // A hole: what a line search meets beyond it cannot be used.
    let hole = |x: &[f64]| Evaluation {
        loss: if x[0] < 4.99 { f64::NAN } else { x[0] },
        gradient: vec![1.0],
    };
    let outcome = run(&variables, &lbfgs(iterations(60)), hole).unwrap();
    assert_eq!(outcome.stop.reason, StopReason::LineSearch);
    assert_eq!(
        outcome.stop.detail,
        "iteration 0 finds no lower loss: the line search met the loss NaN"
    );

    // A slope without end.
    let slope = |x: &[f64]| Evaluation { loss: x[0], gradient: vec![1.0] };
    let outcome = run(&variables, &lbfgs(iterations(60)), slope).unwrap();
    assert_eq!(outcome.stop.reason, StopReason::LineSearch);
    assert!(outcome.evaluations < 200, "{}", outcome.evaluations);
    let why = "finds no lower loss: the line search did not end within 30 evaluations";
    assert!(outcome.stop.detail.contains(why), "{}", outcome.stop.detail);
}

#[test]
fn a_run_that_a_line_search_stopped_is_finished() {
    let folder = tempfile::tempdir().unwrap();
    let settings = in_folder(folder.path(), true, lbfgs(iterations(60)));
    let variables = [Variable::new("x", vec![5.0], 0.1)];
    // Rough at 1e-3: no exact minimum can be found.
    let rough = |x: &[f64]| {
        let Evaluation { loss, gradient } = quadratic(x);
        Evaluation { loss: (1e3 * loss).round() / 1e3 + 1.0, gradient }
    };
    let expected = run(&variables, &settings, rough).unwrap();
    assert_eq!(expected.stop.reason, StopReason::LineSearch, "{:?}", expected.stop);
    assert!((expected.best.x[0] - 1.0).abs() < 0.1);
    let again = run(&variables, &settings, |_| panic!("it was evaluated")).unwrap();
    assert_eq!((&again.best, &again.stop), (&expected.best, &expected.stop));
}

#[test]
fn a_schedule_is_refused() {
    let settings =
        lbfgs(Settings { schedule: Schedule::named("cosine").unwrap(), ..iterations(9) });
    let error = run(&[Variable::new("x", vec![5.0], 0.1)], &settings, quadratic).unwrap_err();
    assert_eq!(
        error.to_string(),
        "optimize.schedule: is cosine, but lbfgs finds the lengths of its steps itself; leave it out"
    );
}

/// A parabola that is blurred on coarse levels: there nothing is below a half.
struct Blurred {
    level: u32,
    at_level: [u64; 3],
}

impl Objective for Blurred {
    fn begin(&mut self, _: u64, level: u32) {
        self.level = level;
        self.at_level[level as usize] += 1;
    }

    fn evaluate(&mut self, x: &[f64]) -> Evaluation {
        let floor = 0.5 * f64::from(self.level);
        let loss = floor + x.iter().map(|x| x * x * x * x).sum::<f64>();
        Evaluation { loss, gradient: x.iter().map(|x| 4.0 * x * x * x).collect() }
    }
}

#[test]
fn coarse_levels_end_where_steps_gain_little() {
    let optimizer = Optimizer::Lbfgs(Lbfgs::default());
    let variables = [Variable::new("x", vec![2.0, -3.0], 0.1)];
    let settings = Settings { optimizer, coarse_to_fine: 2, ..iterations(300) };
    let mut objective = Blurred { level: 2, at_level: [0; 3] };
    let optimization = Optimization::start(&variables, &settings).unwrap();
    let outcome = optimization.run(&mut objective, &mut Quiet).unwrap();
    let [finest, middle, coarsest] = objective.at_level;
    assert!((3..30).contains(&coarsest) && middle < 10 && finest > 10, "{:?}", objective.at_level);
    assert!(outcome.best.loss < 1e-9, "{:?}", outcome.best);
}
