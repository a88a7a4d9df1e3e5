#[path = "../../examples/camera_calibration/experiment.rs"]
mod experiment;

#[test]
fn the_camera_is_found_as_far_as_the_image_tells() {
    let problem = experiment::experiment(80, 60).unwrap();
    let recovery = experiment::recovery(&problem).unwrap();
    let outcome = experiment::run(&problem, 0.1, &recovery.settings()).unwrap();
    let reached = experiment::first_below(&outcome, experiment::PAPER_RATIO);
    assert!(reached.is_some_and(|iteration| iteration < 150), "{reached:?}");
    let camera = recovery.scene_at(&outcome.best.x).camera;
    assert!((experiment::magnification(&camera) - 30.0).abs() < 0.01, "{camera:?}");
    assert!(camera.look_from.x.abs() < 0.01 && camera.look_from.y.abs() < 0.01, "{camera:?}");
}
