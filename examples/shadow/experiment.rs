//! The position of a light, from the shadow of an object that the picture does not show.

use glam::DVec3;
use renderer::experiment::{Experiment, OptimizeSection, Target, TunedParameter};
use renderer::optimize::{Lbfgs, Optimizer, Outcome, Quiet, Settings as OptimizeSettings};
use renderer::recovery::Recovery;
use renderer::{
    Camera, DistantLight, Edges, Error, Material, Mesh, PointLight, Sampling, Scene, Settings,
};

/// Where the light of the target is.
pub const TRUTH: DVec3 = DVec3::new(-1.6, 4.2, 0.9);

/// A floor, by a camera that looks straight down from below an arrow, in an image of `size` by `size`
/// pixels.
pub fn scene(size: u32, light: DVec3) -> Result<Scene, Error> {
    let camera = Camera {
        up: DVec3::NEG_Z,
        vfov: 90.0,
        ..Camera::looking(DVec3::new(0.5, 1.5, -0.2), DVec3::new(0.5, 0.0, -0.2))
    };
    let mut scene = Scene::new(size, size, camera);
    let grey = scene.add_material("grey", Material::lambertian(DVec3::new(0.6, 0.6, 0.55)))?;
    let square = [[-6.0, -6.0], [6.0, -6.0], [6.0, 6.0], [-6.0, 6.0]];
    let floor = square.map(|[x, z]| [x, 0.0, z]).to_vec();
    let floor = Mesh::new("floor", floor, vec![[0, 2, 1], [0, 3, 2]]);
    scene.add_mesh(floor.material(grey))?;
    // A head and a shaft, above the camera.
    let arrow = [
        [-0.5, 1.7, -0.3],
        [0.0, 1.7, -0.9],
        [0.5, 1.7, -0.3],
        [-0.15, 1.7, -0.3],
        [0.15, 1.7, -0.3],
        [0.15, 1.7, 0.5],
        [-0.15, 1.7, 0.5],
    ];
    let faces = vec![[0, 2, 1], [3, 5, 4], [3, 6, 5]];
    scene.add_mesh(Mesh::new("arrow", arrow.to_vec(), faces).material(grey))?;
    let lamp = PointLight { position: light, color: DVec3::ONE, radiant_intensity: 60.0 };
    scene.add_light("lamp", lamp)?;
    // From below the height of the arrow, whose other shadow the picture does not show.
    let direction = DVec3::new(0.3, 0.15, 1.0);
    let sky = DistantLight { direction, color: DVec3::ONE, irradiance: 4.0 };
    scene.add_light("sky", sky)?;
    Ok(scene)
}

/// The problem: from a light at `start` to the true one.
pub fn experiment(size: u32, start: DVec3) -> Result<Experiment, Error> {
    let scene = scene(size, start)?;
    let id = scene.parameter("light.lamp.position")?;
    let parameter = TunedParameter { learning_rate: Some(0.1), ..TunedParameter::new(id) };
    let section = OptimizeSection {
        parameters: vec![parameter],
        target: Some(Target::Values(vec![(id, TRUTH.to_array().to_vec())])),
        ..OptimizeSection::default()
    };
    Ok(Experiment::new(scene, Some(section)))
}

/// The problem, ready to run. Without edges pixels are means of four by four samples.
pub fn recovery(experiment: &Experiment, edges: Edges) -> Result<Recovery<'_>, Error> {
    let sampling = if edges == Edges::Off { Sampling::Grid(4) } else { Sampling::Grid(1) };
    Recovery::new(experiment, "shadow", &Settings { edges, sampling, ..Settings::default() })
}

/// Where `steps` steps of L-BFGS lead.
pub fn run(recovery: &Recovery<'_>, steps: u64) -> Result<Outcome, Error> {
    let optimizer = Optimizer::Lbfgs(Lbfgs::default());
    let settings = OptimizeSettings { iterations: steps, optimizer, ..recovery.settings() };
    recovery.run(&settings, &mut Quiet)
}

/// How far the light found is from the true one.
pub fn error(outcome: &Outcome) -> f64 {
    DVec3::from_slice(&outcome.best.x).distance(TRUTH)
}
