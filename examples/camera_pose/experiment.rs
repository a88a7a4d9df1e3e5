//! Where a camera stands and where it looks, from one image.

use glam::DVec3;
use renderer::experiment::{Experiment, OptimizeSection, Target, TunedParameter};
use renderer::optimize::{Lbfgs, Optimizer, Outcome, Quiet, Settings as OptimizeSettings, Starts};
use renderer::recovery::Recovery;
use renderer::{
    Camera, DistantLight, Edges, Error, Material, Mesh, Sampling, Scene, Settings, SphereObject,
};

/// Where the camera of the target stands, and where it looks.
pub const TRUTH: [DVec3; 2] = [DVec3::new(1.2, 2.6, 5.2), DVec3::new(0.1, 0.5, 0.0)];

/// How far starts are spread along each axis: where the camera stands, and where it looks.
const SPREADS: [f64; 2] = [1.5, 0.3];

/// A tent and two balls on a floor under a distant light: all of them matt, so that a face has the same
/// radiance from everywhere, and nothing but edges tells where the camera is.
fn scene(size: u32, [look_from, look_at]: [DVec3; 2]) -> Result<Scene, Error> {
    let mut scene = Scene::new(size, size, Camera::looking(look_from, look_at));
    let mut paint = |name: &str, albedo: [f64; 3]| {
        scene.add_material(name, Material::lambertian(albedo.into()))
    };
    let [floor, tent, ball] = [
        paint("floor", [0.35, 0.4, 0.3])?,
        paint("tent", [0.8, 0.5, 0.2])?,
        paint("ball", [0.2, 0.4, 0.8])?,
    ];
    let corners = [[-3.0, -2.5], [3.0, -2.5], [3.0, 2.5], [-3.0, 2.5]];
    let corners = corners.map(|[x, z]| [x, 0.0, z]).to_vec();
    scene.add_mesh(Mesh::new("floor", corners, vec![[0, 2, 1], [0, 3, 2]]).material(floor))?;
    let corners = vec![
        [-1.1, 0.0, -0.7],
        [0.9, 0.0, -0.9],
        [1.0, 0.0, 0.8],
        [-0.9, 0.0, 0.6],
        [0.2, 1.7, 0.1],
    ];
    let faces = vec![[0, 4, 1], [1, 4, 2], [2, 4, 3], [3, 4, 0]];
    scene.add_mesh(Mesh::new("tent", corners, faces).material(tent))?;
    for (name, center, radius) in
        [("large", DVec3::new(-1.6, 0.5, 1.0), 0.5), ("small", DVec3::new(1.7, 0.3, 1.3), 0.3)]
    {
        scene.add_sphere(SphereObject::new(name, center, radius).material(ball))?;
    }
    let direction = DVec3::new(0.8, 1.6, 0.9);
    scene.add_light("sun", DistantLight { direction, color: DVec3::ONE, irradiance: 1.6 })?;
    Ok(scene)
}

/// The problem: from `start` to the true camera, with images that are halved so often to begin with, and from so
/// many starts around it.
pub fn experiment(
    size: u32,
    start: [DVec3; 2],
    coarse_to_fine: u32,
    starts: u32,
) -> Result<Experiment, Error> {
    let scene = scene(size, start)?;
    let ids = [scene.parameter("camera.look_from")?, scene.parameter("camera.look_at")?];
    let parameters = ids.into_iter().zip(SPREADS).map(|(id, spread)| {
        let spread = Some(vec![spread; 3]);
        TunedParameter { spread, ..TunedParameter::new(id) }
    });
    let truth = TRUTH.map(|point| point.to_array().to_vec());
    let section = OptimizeSection {
        parameters: parameters.collect(),
        target: Some(Target::Values(ids.into_iter().zip(truth).collect())),
        coarse_to_fine,
        starts: (starts > 1).then_some(Starts { count: starts, seed: 1 }),
        ..OptimizeSection::default()
    };
    Ok(Experiment::new(scene, Some(section)))
}

/// The problem, ready to run. Without edges pixels are means of four by four samples.
pub fn recovery(experiment: &Experiment, edges: Edges) -> Result<Recovery<'_>, Error> {
    let sampling = if edges == Edges::Off { Sampling::Grid(4) } else { Sampling::Grid(1) };
    Recovery::new(experiment, "camera", &Settings { edges, sampling, ..Settings::default() })
}

/// Where `steps` steps of L-BFGS lead.
pub fn run(recovery: &Recovery<'_>, steps: u64) -> Result<Outcome, Error> {
    let optimizer = Optimizer::Lbfgs(Lbfgs::default());
    let settings = OptimizeSettings { iterations: steps, optimizer, ..recovery.settings() };
    recovery.run(&settings, &mut Quiet)
}

/// How far the camera is from the true one, and the same for the unit vectors along which they look: how far
/// along these the point is that it looks at, no picture shows.
pub fn error(outcome: &Outcome) -> (f64, f64) {
    let x = &outcome.best.x;
    let found = [DVec3::from_slice(&x[..3]), DVec3::from_slice(&x[3..6])];
    let forward = |[from, at]: [DVec3; 2]| (at - from).normalize();
    (found[0].distance(TRUTH[0]), forward(found).distance(forward(TRUTH)))
}
