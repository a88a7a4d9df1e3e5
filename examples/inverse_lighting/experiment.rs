//! The light of a tree, from one image of it.

use glam::DVec3;
use renderer::demo::demo_experiment;
use renderer::experiment::Experiment;
use renderer::optimize::{Optimizer, Outcome, Quiet, Settings as OptimizeSettings};
use renderer::recovery::Recovery;
use renderer::{Error, Scene, Settings};

/// Camera, target and initial guess of the paper's listings, and a low-poly tree, in an image of
/// `size` by `size` pixels.
pub fn experiment(size: u32) -> Result<Experiment, Error> {
    let mut experiment = demo_experiment()?;
    (experiment.scene.width, experiment.scene.height) = (size, size);
    Ok(experiment)
}

/// Where `steps` steps lead, whatever the loss is.
pub fn run(recovery: &Recovery<'_>, optimizer: Optimizer, steps: u64) -> Result<Outcome, Error> {
    let settings = OptimizeSettings { iterations: steps, optimizer, ..recovery.settings() };
    recovery.run(&settings, &mut Quiet)
}

/// The problem, ready to run.
pub fn recovery(experiment: &Experiment) -> Result<Recovery<'_>, Error> {
    Recovery::new(experiment, "inverse lighting", &Settings::default())
}

/// The first iteration whose loss is no more than `ratio` times the initial one.
pub fn first_below(outcome: &Outcome, ratio: f64) -> Option<u64> {
    let limit = ratio * outcome.initial_loss;
    outcome.history.iter().find(|record| record.loss <= limit).map(|record| record.iteration)
}

/// How far the light of `found` is from that of `truth` where the tree stands: the direction, in
/// degrees, and the irradiance, relatively. From afar, a light twice as distant and four times as
/// strong looks the same: these two are what the image tells.
pub fn error_at_tree(found: &Scene, truth: &Scene) -> Result<(f64, f64), Error> {
    let incident = |scene: &Scene| {
        let numbers = |path: &str| scene.parameter(path).map(|id| scene.get(id));
        let position = DVec3::from_slice(&numbers("light.key.position")?);
        let to_light = position - scene.camera.look_at;
        let intensity = numbers("light.key.radiant_intensity")?[0];
        Ok::<_, Error>((to_light, intensity / to_light.length_squared()))
    };
    let (found, truth) = (incident(found)?, incident(truth)?);
    Ok((found.0.angle_between(truth.0).to_degrees(), (found.1 / truth.1 - 1.0).abs()))
}
