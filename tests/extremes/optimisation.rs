//! Optimisations that cannot go well stop with a reason, and keep the best that they have seen.

use renderer::experiment::{Experiment, OptimizeSection, Target, TunedParameter};
use renderer::optimize::{Outcome, Quiet, Settings as OptimizeSettings, StopReason};
use renderer::recovery::Recovery;
use renderer::{ParameterId, Scene};

use crate::scenes::{set, small_scene};

fn tuned(id: ParameterId, learning_rate: Option<f64>) -> TunedParameter {
    TunedParameter { learning_rate, ..TunedParameter::new(id) }
}

fn section(
    target: Vec<(ParameterId, Vec<f64>)>,
    parameters: Vec<TunedParameter>,
) -> OptimizeSection {
    OptimizeSection {
        target: Some(Target::Values(target)),
        parameters,
        ..OptimizeSection::default()
    }
}

#[track_caller]
fn run(scene: Scene, section: OptimizeSection, iterations: u64) -> Outcome {
    let experiment = Experiment::new(scene, Some(section));
    let recovery = Recovery::new(&experiment, "scene", &crate::without_edges()).unwrap();
    let settings = OptimizeSettings { iterations, ..recovery.settings() };
    let outcome = recovery.run(&settings, &mut Quiet).unwrap();
    assert!(outcome.best.x.iter().all(|x| x.is_finite()) && outcome.best.loss.is_finite());
    assert!(outcome.history.iter().all(|record| record.loss >= outcome.best.loss));
    outcome
}

#[test]
fn a_plateau_ends_the_run() {
    // The light stands below the floor: no pixel shows it.
    let mut scene = small_scene(16);
    set(&mut scene, "light.key.position", &[0.0, -50.0, 0.0]);
    let position = scene.parameter("light.key.position").unwrap();
    let target = vec![(scene.parameter("light.sky.irradiance").unwrap(), vec![2.5])];
    let outcome = run(scene, section(target, vec![tuned(position, None)]), 50);
    assert_eq!(outcome.stop.reason, StopReason::GradientTolerance, "{:?}", outcome.stop);
    assert!(outcome.stop.detail.contains("the gradient vanished"), "{:?}", outcome.stop);
    assert_eq!(outcome.best.x, [0.0, -50.0, 0.0]);
}

/// Steps that leave every range: parameters that cannot be rendered, and losses that overflow.
#[test]
fn an_exploding_learning_rate_ends_the_run() {
    for (path, rate) in [
        ("light.key.position", 1e10),
        ("light.key.position", 1e30),
        ("light.key.radiant_intensity", 1e37),
        ("camera.look_from", 1e30),
        ("camera.look_at", 1e300),
        ("camera.up", 1e25),
        ("camera.vfov", 1e9),
        ("sphere.ball.center", 1e30),
        ("sphere.ball.radius", 1e20),
        ("mesh.tent.vertices", 1e19),
        ("material.object.exponent", 1e38),
        ("material.object.diffuse", 1e38),
    ] {
        let scene = small_scene(16);
        let id = scene.parameter(path).unwrap();
        let intensity = scene.parameter("light.key.radiant_intensity").unwrap();
        let target = vec![(intensity, vec![75.0])];
        let outcome = run(scene, section(target, vec![tuned(id, Some(rate))]), 30);
        println!("| learning rate {rate:e} of {path} | {} |", outcome.stop.detail);
        let initial = outcome.initial_loss;
        assert!(outcome.best.loss <= initial, "{path}");
    }
}

#[test]
fn leaving_the_range_names_the_parameter() {
    let scene = small_scene(16);
    let id = scene.parameter("sphere.ball.center").unwrap();
    let initial = scene.get(id).into_owned();
    let target = vec![(scene.parameter("light.key.radiant_intensity").unwrap(), vec![75.0])];
    let outcome = run(scene, section(target, vec![tuned(id, Some(1e30))]), 30);
    assert_eq!(outcome.stop.reason, StopReason::NonFiniteLoss);
    assert!(outcome.stop.detail.contains("sphere.ball.center"), "{:?}", outcome.stop);
    assert!(outcome.stop.detail.contains("beyond 1e18"), "{:?}", outcome.stop);
    assert_eq!(outcome.best.x, initial);
}

#[test]
fn parameters_stay_within_their_bounds() {
    let scene = small_scene(16);
    let id = scene.parameter("material.ground.diffuse").unwrap();
    // What is to be found lies outside of the bounds, on both sides; one starts at its bound.
    let target = vec![(id, vec![0.9, 0.1, 0.4])];
    let bounded = TunedParameter {
        min: Some(vec![0.3, 0.3, 0.4]),
        max: Some(vec![0.7, 0.7, 0.7]),
        ..tuned(id, None)
    };
    let outcome = run(scene, section(target, vec![bounded]), 200);
    for (found, expected) in outcome.best.x.iter().zip([0.7, 0.3, 0.4]) {
        assert!((found - expected).abs() <= 1e-6, "{:?}", outcome.best.x);
    }
}
