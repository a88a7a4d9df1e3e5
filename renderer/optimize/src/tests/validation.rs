//! Input that is refused before anything runs.

use super::*;

fn refusal(variables: &[Variable], settings: &Settings) -> String {
    run(variables, settings, |_| panic!("it was evaluated")).unwrap_err().to_string()
}

/// A message, and the change that leads to it.
type Case<T> = (&'static str, fn(&mut T));

#[test]
fn unusable_variables() {
    let good = Variable::new("light.position", vec![0.5, 0.5, 0.5], 0.1);
    let cases: [Case<Variable>; 11] = [
        ("light.position[1]: the initial value is 0; on a logarithmic scale", |v| {
            v.scale = Scale::Log;
            v.initial[1] = 0.0;
        }),
        ("light.position: has coordinates of its own; leave them out, or the", |v| {
            v.scale = Scale::Log;
            v.preconditioner = Some(Preconditioner::new("none", |_| ()));
        }),
        ("light.position[1]: the initial value is NaN", |v| v.initial[1] = f64::NAN),
        ("light.position[2]: the learning rate is 0", |v| v.learning_rate[2] = 0.0),
        ("light.position[0]: the learning rate is inf", |v| v.learning_rate[0] = f64::INFINITY),
        ("light.position[0]: the bounds 2 to 1 hold no number", |v| {
            (v.min[0], v.max[0]) = (2.0, 1.0);
        }),
        ("light.position[0]: the bounds NaN to inf hold no number", |v| v.min[0] = f64::NAN),
        ("light.position[0]: the initial value 0.5 is below its minimum 0.6", |v| v.min[0] = 0.6),
        ("light.position[0]: the initial value 0.5 is above its maximum 0.4", |v| v.max[0] = 0.4),
        ("light.position: learning_rate has 2 numbers, but the parameter has 3", |v| {
            v.learning_rate.pop();
        }),
        ("light.position: target has 1 numbers, but the parameter has 3", |v| {
            v.target = Some(vec![1.0]);
        }),
    ];
    for (message, change) in cases {
        let mut variable = good.clone();
        change(&mut variable);
        let refused = refusal(&[variable], &Settings::default());
        assert!(refused.starts_with(message), "{refused}");
    }
    let scalar = Variable::new("camera.vfov", vec![f64::INFINITY], 0.1);
    let refused = refusal(&[scalar], &Settings::default());
    assert!(refused.starts_with("camera.vfov: the initial value is inf"), "{refused}");
    let refused = refusal(&[good.clone(), good], &Settings::default());
    assert_eq!(refused, "light.position: the parameter is listed twice");
    assert!(refusal(&[], &Settings::default()).starts_with("optimize: there is no parameter"));
}

#[test]
fn unusable_settings() {
    let variables = [Variable::new("x", vec![0.0], 0.1)];
    let cases: [Case<Settings>; 9] = [
        ("optimize.tolerance: is NaN; it must be a number", |s| s.tolerance = f64::NAN),
        ("optimize.gradient_tolerance: is -1; it must be 0 or more", |s| {
            s.gradient_tolerance = -1.0
        }),
        ("optimize.optimizer.beta1: is 1; it must be at least 0 and below 1", |s| {
            s.optimizer = Optimizer::Adam(Adam { beta1: 1.0, ..Adam::default() });
        }),
        ("optimize.optimizer.beta2: is NaN; it must be at least 0 and below 1", |s| {
            s.optimizer = Optimizer::AdamW(AdamW { beta2: f64::NAN, ..AdamW::default() });
        }),
        ("optimize.optimizer.epsilon: is 0; it must be a positive number", |s| {
            s.optimizer = Optimizer::RmsProp(RmsProp { epsilon: 0.0, ..RmsProp::default() });
        }),
        ("optimize.optimizer.momentum: is -0.1; it must be at least 0 and below 1", |s| {
            s.optimizer = Optimizer::Sgd(Sgd { momentum: -0.1 });
        }),
        ("optimize.schedule.end: is 0; it must be above 0 and at most 1", |s| {
            s.schedule = Schedule::Exponential(schedule::Exponential { end: 0.0 });
        }),
        ("optimize.schedule.stages: is 0; it must be at least 1", |s| {
            s.schedule = Schedule::Step(schedule::Step { stages: 0, decay: 0.5 });
        }),
        ("optimize.schedule.end: is NaN; it must be from 0 to 1", |s| {
            s.schedule = Schedule::Cosine(schedule::Cosine { end: f64::NAN });
        }),
    ];
    for (message, change) in cases {
        let mut settings = Settings::default();
        change(&mut settings);
        assert_eq!(refusal(&variables, &settings), message);
    }
}

#[test]
fn non_finite_start_is_an_error_that_leaves_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let settings = in_folder(&out, false, Settings::default());
    let variables = [Variable::new("light.position", vec![0.0, 1.0], 0.1)];
    let nan = |_: &[f64]| Evaluation { loss: 1.0, gradient: vec![0.0, f64::NAN] };
    let error = run(&variables, &settings, nan).unwrap_err();
    assert_eq!(
        error.to_string(),
        "optimize: the gradient of light.position[1] is NaN at iteration 0"
    );
    assert!(!out.exists());
}

#[test]
fn more_numbers_than_a_method_solves_for() {
    let variables = [Variable::new("x", vec![0.0; 257], 0.1)];
    let settings = Settings { optimizer: Optimizer::Lm(Lm::default()), ..Settings::default() };
    let expected = "optimize.optimizer: lm solves for up to 256 numbers; these are 257";
    assert_eq!(refusal(&variables, &settings), expected);
}
