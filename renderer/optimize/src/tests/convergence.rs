//! Where an optimisation ends, and why.

use super::*;

#[test]
fn quadratic_reaches_the_tolerance() {
    let variables = [Variable::new("a", vec![5.0], 0.1), Variable::new("b", vec![-3.0, 0.0], 0.05)];
    for epoch in [0, 1] {
        let settings = Settings { tolerance: 1e-12, epoch, ..iterations(10_000) };
        let outcome = run(&variables, &settings, quadratic).unwrap();
        assert_eq!(outcome.stop.reason, StopReason::Tolerance);
        assert!(outcome.best.loss <= 1e-12);
        assert!(outcome.best.x.iter().all(|x| (x - 1.0).abs() < 1e-6), "{:?}", outcome.best.x);
    }
}

#[test]
fn quadratic_reaches_the_tolerance_at_any_scale_of_the_loss() {
    let variables = [Variable::new("a", vec![5.0], 0.1)];
    let steps = [1.0, 1e-24, 1e24].map(|scale: f64| {
        let settings = Settings { tolerance: 1e-12 * scale, ..iterations(10_000) };
        let scaled = |x: &[f64]| {
            let Evaluation { loss, gradient } = quadratic(x);
            Evaluation {
                loss: scale * loss,
                gradient: gradient.iter().map(|g| scale * g).collect(),
            }
        };
        let outcome = run(&variables, &settings, scaled).unwrap();
        assert_eq!(outcome.stop.reason, StopReason::Tolerance, "{scale}");
        outcome.last.iteration
    });
    assert!(steps.iter().all(|n| n.abs_diff(steps[0]) <= 2), "{steps:?}");
}

#[test]
fn rosenbrock_reaches_the_gradient_tolerance() {
    let variables = [Variable::new("x", vec![-1.2, 1.0], 0.01)];
    let settings = Settings { gradient_tolerance: 1e-6, ..iterations(50_000) };
    let outcome = run(&variables, &settings, rosenbrock).unwrap();
    assert_eq!(outcome.stop.reason, StopReason::GradientTolerance, "{:?}", outcome.stop);
    assert!(outcome.best.x.iter().all(|x| (x - 1.0).abs() < 1e-5), "{:?}", outcome.best.x);
}

#[test]
fn every_method_and_schedule_finds_the_minimum() {
    let variables = [
        Variable::new("a", vec![5.0], 0.1).bounded(-10.0, 10.0),
        Variable::new("b", vec![0.9], 0.1),
    ];
    for optimizer in methods() {
        for schedule in schedules(&optimizer) {
            let settings = Settings { optimizer, schedule, ..iterations(400) };
            let outcome = run(&variables, &settings, quadratic).unwrap();
            // Weight decay holds the minimum of Adam's direction off by a little, and RMSProp at
            // a constant rate goes to and fro across it.
            let off = match (optimizer, schedule) {
                (Optimizer::AdamW(_), _) => 0.05,
                (Optimizer::RmsProp(_), Schedule::Constant) => 0.06,
                _ => 0.02,
            };
            let x = &outcome.best.x;
            assert!(x.iter().all(|x| (x - 1.0).abs() < off), "{optimizer:?} {schedule:?}: {x:?}");
        }
    }
}

#[test]
fn iterations_count_steps() {
    let variables = [Variable::new("x", vec![5.0], 0.1)];
    for n in [0, 1, 7] {
        let mut evaluations = 0;
        let outcome = run(&variables, &iterations(n), |x| {
            evaluations += 1;
            quadratic(x)
        })
        .unwrap();
        assert_eq!(outcome.stop.reason, StopReason::Iterations);
        assert_eq!(evaluations, n + 1);
        assert_eq!(outcome.last.iteration, n);
        let iterations: Vec<u64> = outcome.history.iter().map(|r| r.iteration).collect();
        assert_eq!(iterations, (0..=n).collect::<Vec<_>>());
        // The final loss belongs to the final parameters.
        assert_eq!(quadratic(&outcome.last.x).loss, outcome.last.loss);
        assert_eq!(outcome.history.last().unwrap().loss, outcome.last.loss);
    }
}

#[test]
fn best_is_kept_when_the_loss_rises() {
    // Steps of 2 from 1.5 jump over the minimum at 1.
    let variables = [Variable::new("x", vec![1.5], 2.0)];
    let outcome = run(&variables, &iterations(1), quadratic).unwrap();
    assert_eq!((outcome.best.iteration, outcome.best.x[0]), (0, 1.5));
    assert_eq!(outcome.last.iteration, 1);
    assert!((outcome.last.x[0] + 0.5).abs() < 1e-9 && outcome.last.loss > outcome.best.loss);
}

#[test]
fn minimum_on_a_bound_is_reached_and_recognised() {
    let variables = [Variable::new("x", vec![0.2], 0.1).bounded(0.0, 0.75)];
    let mut inside = true;
    let outcome = run(&variables, &iterations(1000), |x| {
        inside &= (0.0..=0.75).contains(&x[0]);
        quadratic(x)
    })
    .unwrap();
    assert!(inside);
    assert_eq!(outcome.best.x, [0.75]);
    // The gradient is -0.5 there; what the bound holds back does not count.
    assert_eq!(outcome.stop.reason, StopReason::GradientTolerance);
    assert_eq!(outcome.history.last().unwrap().gradient_norm, 0.0);
}

#[test]
fn plateau_stops() {
    let variables = [Variable::new("x", vec![5.0], 0.1)];
    let flat = |_: &[f64]| Evaluation { loss: 0.5, gradient: vec![0.0] };
    let outcome = run(&variables, &iterations(100), flat).unwrap();
    assert_eq!(outcome.stop.reason, StopReason::GradientTolerance);
    assert!(outcome.stop.detail.contains("vanished"), "{}", outcome.stop.detail);
    assert_eq!((outcome.last.iteration, outcome.best.x[0]), (0, 5.0));
}

#[test]
fn non_finite_evaluation_stops_and_keeps_the_best() {
    let variables =
        [Variable::new("light.position", vec![5.0, 4.0], 0.1), Variable::new("n", vec![3.0], 0.1)];
    for (reason, detail) in [
        (StopReason::NonFiniteLoss, "the loss is NaN at iteration 6"),
        (StopReason::NonFiniteGradient, "the gradient of light.position[1] is inf at iteration 6"),
    ] {
        let mut count = 0;
        let outcome = run(&variables, &iterations(100), |x| {
            let mut evaluation = quadratic(x);
            if count == 6 {
                match reason {
                    StopReason::NonFiniteLoss => evaluation.loss = f64::NAN,
                    _ => evaluation.gradient[1] = f64::INFINITY,
                }
            }
            count += 1;
            evaluation
        })
        .unwrap();
        assert_eq!((outcome.stop.reason, outcome.stop.detail.as_str()), (reason, detail));
        assert_eq!((outcome.best.iteration, outcome.last.iteration), (5, 5));
        assert_eq!(quadratic(&outcome.best.x).loss, outcome.best.loss);
        assert_eq!(outcome.history.len(), 6);
    }
}

#[test]
fn interruption_returns_what_there_is() {
    let variables = [Variable::new("x", vec![5.0], 0.1)];
    let settings = iterations(100);
    let outcome = Optimization::start(&variables, &settings)
        .unwrap()
        .run(&mut quadratic, &mut InterruptAt(3))
        .unwrap();
    assert_eq!(outcome.stop.reason, StopReason::Interrupted);
    assert_eq!((outcome.last.iteration, outcome.history.len()), (3, 4));
}

#[test]
fn stop_reasons_are_snake_case() {
    let names = [
        (StopReason::Tolerance, "tolerance"),
        (StopReason::GradientTolerance, "gradient_tolerance"),
        (StopReason::Iterations, "iterations"),
        (StopReason::LineSearch, "line_search"),
        (StopReason::NonFiniteLoss, "non_finite_loss"),
        (StopReason::NonFiniteGradient, "non_finite_gradient"),
        (StopReason::Interrupted, "interrupted"),
    ];
    for (reason, name) in names {
        assert_eq!(serde_json::to_value(reason).unwrap(), name);
    }
}
