//! Steps in the logarithms of numbers.

use super::resume::assert_same;
use super::*;

const TRUTH: [f64; 2] = [300.0, 0.02];

fn variables(scale: Scale) -> [Variable; 1] {
    let variable = Variable::new("intensity", vec![3.0, 2.0], 0.1).bounded(0.0, f64::INFINITY);
    [Variable { scale, ..variable }]
}

/// The squared logarithms of ratios to the truth.
fn relative(x: &[f64]) -> Evaluation {
    let off = |i: usize| (x[i] / TRUTH[i]).ln();
    Evaluation {
        loss: off(0).powi(2) + off(1).powi(2),
        gradient: (0..2).map(|i| 2.0 * off(i) / x[i]).collect(),
    }
}

/// The same loss as a function of logarithms, by the chain rule.
fn of_logarithms(u: &[f64]) -> Evaluation {
    let x: Vec<f64> = u.iter().map(|u| u.exp()).collect();
    let Evaluation { loss, gradient } = relative(&x);
    Evaluation { loss, gradient: gradient.iter().zip(&x).map(|(g, x)| g * x).collect() }
}

#[test]
fn methods_take_the_steps_that_they_take_in_logarithms() {
    for optimizer in methods() {
        let settings = Settings { optimizer, ..iterations(25) };
        let logarithms = variables(Scale::Log)[0].initial.iter().map(|x| x.ln()).collect();
        let expected =
            run(&[Variable::new("logarithm", logarithms, 0.1)], &settings, of_logarithms).unwrap();
        let found = run(&variables(Scale::Log), &settings, relative).unwrap();
        for (x, u) in found.last.x.iter().zip(&expected.last.x) {
            assert!((x.ln() - u).abs() < 1e-9 * u.abs(), "{optimizer:?}: {x} {}", u.exp());
        }
        assert!(found.last.loss < found.initial_loss, "{optimizer:?}");
    }
}

#[test]
fn what_is_off_by_a_hundred_is_found_and_stays_above_zero() {
    let settings = Settings { iterations: 300, ..Settings::default() };
    let mut least = f64::INFINITY;
    let found = run(&variables(Scale::Log), &settings, |x| {
        least = x.iter().copied().fold(least, f64::min);
        relative(x)
    })
    .unwrap();
    assert!(least > 0.0 && found.best.loss < 1e-6, "{least} {:?}", found.best);
    let linear = run(&variables(Scale::Linear), &settings, relative).unwrap();
    assert!(linear.best.loss > 0.1, "{:?}", linear.best);
}

#[test]
fn steps_of_any_length_stay_above_zero_and_finite() {
    for optimizer in methods().filter(|optimizer| !optimizer.finds_step_lengths()) {
        let mut variables = variables(Scale::Log);
        variables[0].learning_rate = vec![1e4; 2];
        let mut positive = true;
        let settings = Settings { optimizer, ..iterations(5) };
        run(&variables, &settings, |x| {
            positive &= x.iter().all(|x| *x > 0.0 && x.is_finite());
            Evaluation { loss: 1.0 / (1.0 + x[0]), gradient: vec![1.0, -1.0] }
        })
        .unwrap();
        assert!(positive, "{optimizer:?}");
    }
}

#[test]
fn starts_differ_by_factors() {
    let mut variables = variables(Scale::Log);
    variables[0].spread = vec![5.0; 2];
    let starts = Some(Starts { count: 60, seed: 1 });
    let mut seen = Vec::new();
    run(&variables, &Settings { starts, ..iterations(0) }, |x| {
        seen.push(x[0]);
        Evaluation { loss: 1.0, gradient: vec![0.0; 2] }
    })
    .unwrap();
    let count = |range: std::ops::Range<f64>| seen.iter().filter(|x| range.contains(x)).count();
    let factor = 5.0_f64.exp();
    assert_eq!(count(3.0 / factor..3.0 * factor), seen.len());
    assert!(count(0.0..0.3) > 100 && count(30.0..1e9) > 100, "{seen:?}");
}

#[test]
fn interrupted_runs_continue_bit_for_bit() {
    for optimizer in methods() {
        let settings = Settings { optimizer, ..iterations(20) };
        let expected = run(&variables(Scale::Log), &settings, relative).unwrap();
        let folder = tempfile::tempdir().unwrap();
        let settings = in_folder(folder.path(), true, settings);
        let variables = variables(Scale::Log);
        let optimization = Optimization::start(&variables, &settings).unwrap();
        optimization.run(&mut relative, &mut InterruptAt(7)).unwrap();
        let other = [Variable { scale: Scale::Linear, ..variables[0].clone() }];
        let error = run(&other, &settings, relative).unwrap_err();
        assert!(error.problem.contains("other parameters"), "{error}");
        assert_same(&run(&variables, &settings, relative).unwrap(), &expected);
    }
}
