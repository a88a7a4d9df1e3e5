//! The light of a tree, from one image of it.

use renderer::Error;
use renderer::arithmetic::Arithmetic;
use renderer::demo::demo_experiment;
use renderer::experiment::Experiment;
use renderer::optimize::{Optimizer, Outcome, Quiet, Settings};
use renderer::recovery::Recovery;
use renderer::scene::{Light, Scene};

/// Camera, target and initial guess of the paper's listings, and a low-poly tree, in an image of
/// `size` by `size` pixels.
pub fn experiment(size: u32) -> Result<Experiment, Error> {
    let mut experiment = demo_experiment()?;
    (experiment.scene.width, experiment.scene.height) = (size, size);
    Ok(experiment)
}

/// Where `steps` steps lead, whatever the loss is.
pub fn run(recovery: &Recovery<'_>, optimizer: Optimizer, steps: u64) -> Result<Outcome, Error> {
    recovery.run(&Settings { iterations: steps, optimizer, ..recovery.settings() }, &mut Quiet)
}

/// The problem, ready to run.
pub fn recovery(experiment: &Experiment) -> Result<Recovery<'_>, Error> {
    Recovery::new(experiment, "inverse lighting", Arithmetic::default())
}

/// The first iteration whose loss is no more than `ratio` times the initial one.
pub fn first_below(outcome: &Outcome, ratio: f64) -> Option<u64> {
    let limit = ratio * outcome.initial_loss();
    outcome.history.iter().find(|record| record.loss <= limit).map(|record| record.iteration)
}

/// How far the light of `found` is from that of `truth` where the tree stands: the direction, in
/// degrees, and the irradiance, relatively. From afar, a light twice as distant and four times as
/// strong looks the same: these two are what the image tells.
pub fn error_at_tree(found: &Scene, truth: &Scene) -> (f64, f64) {
    let incident = |scene: &Scene| {
        let Light::Point(light) = &scene.parameters.lights[0] else {
            panic!("the light is a point light");
        };
        let to_light = light.position - scene.parameters.camera.look_at;
        (to_light, light.intensity / to_light.length_squared())
    };
    let (found, truth) = (incident(found), incident(truth));
    (found.0.angle_between(truth.0).to_degrees(), (found.1 / truth.1 - 1.0).abs())
}
