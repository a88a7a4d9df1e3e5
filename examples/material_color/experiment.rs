//! The colours of a tree, from one image of it.

use glam::dvec3;
use renderer::demo::demo_experiment;
use renderer::experiment::{Experiment, OptimizeSection, Target, TunedParameter};
use renderer::optimize::{Optimizer, Outcome, Quiet, Settings as OptimizeSettings};
use renderer::recovery::Recovery;
use renderer::{Error, LossKind, ParameterId, Scene, Settings};

/// The learning rate of the paper.
const LEARNING_RATE: f64 = 0.05;
/// The guess of every material, which the paper does not state: a dark grey.
const GUESS: [f64; 3] = [0.15; 3];

/// Camera and light of the paper's listing before a low-poly tree, in an image of `width` by
/// `height` pixels.
pub fn scene(width: u32, height: u32) -> Result<Scene, Error> {
    let mut scene = demo_experiment()?.scene;
    (scene.width, scene.height) = (width, height);
    for (path, numbers) in [
        ("light.key.position", &[0.15, 0.5, -10.5][..]),
        ("light.key.radiant_intensity", &[250_000.0]),
    ] {
        scene.set(scene.parameter(path)?, numbers)?;
    }
    let camera = &mut scene.camera;
    camera.look_from = dvec3(-2.0, 2.0, -5.0);
    camera.look_at = dvec3(0.0, 1.7, 0.0);
    camera.film_scale = 1.0;
    Ok(scene)
}

/// The problem: the diffuse colours of all materials, from a guess, kept between 0 and 1. The target
/// is the image of `scene` as it is.
pub fn experiment(mut scene: Scene) -> Result<Experiment, Error> {
    let mut ids: Vec<ParameterId> = scene.parameters();
    ids.retain(|id| id.field == "diffuse");
    let truth = ids.iter().map(|&id| (id, scene.get(id).into_owned())).collect();
    for &id in &ids {
        scene.set(id, &GUESS)?;
    }
    let parameters = ids.into_iter().map(|id| TunedParameter {
        min: Some(vec![0.0; 3]),
        max: Some(vec![1.0; 3]),
        ..TunedParameter::new(id)
    });
    let optimize = OptimizeSection {
        target: Some(Target::Values(truth)),
        parameters: parameters.collect(),
        loss: Some(LossKind::SumSquared),
        learning_rate: Some(LEARNING_RATE),
        ..OptimizeSection::default()
    };
    Ok(Experiment::new(scene, Some(optimize)))
}

/// The problem, ready to run.
pub fn recovery(experiment: &Experiment) -> Result<Recovery<'_>, Error> {
    Recovery::new(experiment, "material colour", &Settings::default())
}

/// Where `steps` steps lead.
pub fn run(recovery: &Recovery<'_>, optimizer: Optimizer, steps: u64) -> Result<Outcome, Error> {
    let settings = OptimizeSettings { iterations: steps, optimizer, ..recovery.settings() };
    recovery.run(&settings, &mut Quiet)
}
