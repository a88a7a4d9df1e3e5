//! The colours of a tree, from one image of it.

use renderer::Error;
use renderer::arithmetic::Arithmetic;
use renderer::demo::demo_experiment;
use renderer::experiment::{Experiment, OptimizeSection, Target, TunedParameter};
use renderer::kernels::light::PointLight;
use renderer::loss::LossKind;
use renderer::optimize::{Optimizer, Outcome, Quiet, Settings};
use renderer::recovery::Recovery;
use renderer::scene::{Light, ParameterId, Scene};

use glam::{DVec3, dvec3};

/// The learning rate of the paper.
const LEARNING_RATE: f64 = 0.05;
/// The guess of every material, which the paper does not state: a dark grey.
const GUESS: [f64; 3] = [0.15; 3];

/// Camera and light of the paper's listing before a low-poly tree, in an image of `width` by
/// `height` pixels.
pub fn scene(width: u32, height: u32) -> Result<Scene, Error> {
    let mut scene = demo_experiment()?.scene;
    (scene.width, scene.height) = (width, height);
    scene.parameters.lights[0] = Light::Point(PointLight {
        position: dvec3(0.15, 0.5, -10.5),
        color: DVec3::ONE,
        intensity: 1_000_000.0,
    });
    let camera = &mut scene.parameters.camera;
    camera.look_from = dvec3(-2.0, 2.0, -5.0);
    camera.look_at = dvec3(0.0, 1.7, 0.0);
    camera.focus = 1.0;
    Ok(scene)
}

/// The problem: the diffuse colours of all materials, from a guess, kept between 0 and 1. The target
/// is the image of `scene` as it is.
pub fn experiment(mut scene: Scene) -> Experiment {
    let ids = (0..scene.materials.len()).map(ParameterId::Diffuse);
    let truth = ids.clone().map(|id| (id, scene.parameters.get(id).to_vec())).collect();
    for id in ids.clone() {
        scene.parameters.get_mut(id).copy_from_slice(&GUESS);
    }
    let parameters = ids.map(|id| TunedParameter {
        id,
        learning_rate: None,
        min: Some(vec![0.0; 3]),
        max: Some(vec![1.0; 3]),
    });
    let optimize = OptimizeSection {
        target: Some(Target::Values(truth)),
        parameters: parameters.collect(),
        loss: Some(LossKind::SumSquared),
        learning_rate: Some(LEARNING_RATE),
        ..OptimizeSection::default()
    };
    Experiment::new(scene, Some(optimize))
}

/// The problem, ready to run.
pub fn recovery(experiment: &Experiment) -> Result<Recovery<'_>, Error> {
    Recovery::new(experiment, "material colour", Arithmetic::default())
}

/// Where `steps` steps lead.
pub fn run(recovery: &Recovery<'_>, optimizer: Optimizer, steps: u64) -> Result<Outcome, Error> {
    recovery.run(&Settings { iterations: steps, optimizer, ..recovery.settings() }, &mut Quiet)
}
