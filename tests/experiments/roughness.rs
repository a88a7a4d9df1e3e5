#[path = "../../examples/roughness/experiment.rs"]
mod experiment;

use renderer::Settings;
use renderer::optimize::{Quiet, Settings as OptimizeSettings};
use renderer::recovery::Recovery;

/// Three small views are enough for most of a texture of roughness.
#[test]
fn a_texture_of_roughness_is_found() {
    let truth = experiment::scene(48).unwrap();
    let problem = experiment::experiment(&truth).unwrap();
    let recovery = Recovery::new(&problem, "roughness", &Settings::default()).unwrap();
    let settings = OptimizeSettings { iterations: 120, ..recovery.settings() };
    let outcome = recovery.run(&settings, &mut Quiet).unwrap();
    let found = recovery.scene_at(&outcome.best.x);
    let before = experiment::error(&problem.scene, &truth).unwrap();
    let after = experiment::error(&found, &truth).unwrap();
    assert!(after < 0.25 * before, "{before} before, {after} after");
}
