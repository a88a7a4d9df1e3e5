//! Rotation and translation of an object, from one image of it.

use glam::{DQuat, DVec3, IVec3, ivec3};
use renderer::experiment::{Experiment, OptimizeSection, Target, TunedParameter};
use renderer::optimize::{
    Optimizer, Outcome, Quiet, Schedule, Settings as OptimizeSettings, Starts,
};
use renderer::recovery::Recovery;
use renderer::{
    Camera, DistantLight, Edges, Error, Material, Mesh, PointLight, Sampling, Scene, Settings,
    Transform,
};

/// The cubes that the object is made of: no rotation and no mirror brings it onto itself.
const CUBES: [IVec3; 5] =
    [ivec3(0, 0, 0), ivec3(1, 0, 0), ivec3(2, 0, 0), ivec3(0, 1, 0), ivec3(2, 0, 1)];
/// The side of a cube.
const SIDE: f64 = 0.5;

/// Where the object is.
#[derive(Clone, Copy, Debug)]
pub struct Pose {
    pub rotation: DQuat,
    pub translation: DVec3,
}

/// What is to be found.
pub struct Task {
    /// The object.
    pub mesh: Mesh,
    /// Whether it stands above a floor that its shadow falls on.
    pub has_floor: bool,
    /// The side of the image in pixels.
    pub size: u32,
    /// Where it is in the target.
    pub truth: Pose,
}

impl Task {
    /// An object of cubes above a floor.
    pub fn cubes(size: u32) -> Self {
        let rotation = DQuat::from_scaled_axis(DVec3::new(0.3, -0.6, 0.2));
        let truth = Pose { rotation, translation: DVec3::new(0.1, 1.0, 0.0) };
        Self { mesh: object(), has_floor: true, size, truth }
    }
}

impl Pose {
    /// Turned about an axis through the middle of the object, and moved.
    pub fn displaced(self, axis: DVec3, degrees: f64, by: DVec3) -> Self {
        let turn = DQuat::from_axis_angle(axis.normalize(), degrees.to_radians());
        Self { rotation: turn * self.rotation, translation: self.translation + by }
    }

    /// The angle to another in degrees, and the distance.
    pub fn error(&self, other: &Self) -> (f64, f64) {
        let turn = self.rotation * other.rotation.inverse();
        // The sine tells small angles apart, which the cosine does not.
        let half = turn.xyz().length().atan2(turn.w.abs());
        (2.0 * half.to_degrees(), self.translation.distance(other.translation))
    }

    /// The rotation vector in degrees and the translation: what varies.
    fn numbers(&self) -> [Vec<f64>; 2] {
        let rotation = self.rotation.to_scaled_axis().map(f64::to_degrees);
        [rotation, self.translation].map(|vector| vector.to_array().to_vec())
    }

    /// Of the numbers that vary.
    pub fn found(x: &[f64]) -> Self {
        let rotation = DVec3::from_slice(&x[..3]).map(f64::to_radians);
        Self {
            rotation: DQuat::from_scaled_axis(rotation),
            translation: DVec3::from_slice(&x[3..6]),
        }
    }
}

/// The surface of the cubes, about the mean of their middles.
fn object() -> Mesh {
    let middle = CUBES.map(|cube| cube.as_dvec3()).iter().sum::<DVec3>() / CUBES.len() as f64;
    let (mut corners, mut triangles) = (Vec::new(), Vec::new());
    let mut index = |corner: IVec3| {
        let known = corners.iter().position(|&other| other == corner);
        known.unwrap_or_else(|| {
            corners.push(corner);
            corners.len() - 1
        }) as u32
    };
    for cube in CUBES {
        for axis in 0..3 {
            for side in [-1, 1] {
                let unit = |axis: usize| IVec3::AXES[axis % 3];
                if CUBES.contains(&(cube + side * unit(axis))) {
                    continue;
                }
                let first = cube + side.max(0) * unit(axis);
                let (mut u, mut v) = (unit(axis + 1), unit(axis + 2));
                if side < 0 {
                    (u, v) = (v, u);
                }
                let [a, b, c, d] = [first, first + u, first + u + v, first + v].map(&mut index);
                triangles.extend([[a, b, c], [a, c, d]]);
            }
        }
    }
    let vertex = |corner: &IVec3| (SIDE * (corner.as_dvec3() - 0.5 - middle)).to_array();
    Mesh::new("object", corners.iter().map(vertex).collect(), triangles)
}

/// The object at a pose.
fn scene(task: &Task, pose: &Pose) -> Result<Scene, Error> {
    let [rotation, translation] = pose.numbers().map(|numbers| DVec3::from_slice(&numbers));
    let transform = Transform { rotation, translation, ..Transform::IDENTITY };
    if !task.has_floor {
        let camera = Camera { vfov: 60.0, ..Camera::looking(DVec3::Z * 2.0, DVec3::ZERO) };
        let mut scene = Scene::new(task.size, task.size, camera);
        let paint = Material::lambertian(DVec3::new(0.3, 0.5, 0.75));
        let paint = scene.add_material("paint", paint)?;
        scene.add_mesh(task.mesh.clone().material(paint).transform(transform))?;
        let position = DVec3::new(2.5, 2.5, 7.0);
        let lamp = PointLight { position, color: DVec3::ONE, radiant_intensity: 190.0 };
        scene.add_light("lamp", lamp)?;
        return Ok(scene);
    }
    let camera = Camera::looking(DVec3::new(0.6, 2.4, 4.6), DVec3::new(0.0, 0.8, 0.0));
    let mut scene = Scene::new(task.size, task.size, camera);
    let grey = scene.add_material("grey", Material::lambertian(DVec3::new(0.5, 0.5, 0.55)))?;
    let paint = scene.add_material("paint", Material::lambertian(DVec3::new(0.8, 0.4, 0.15)))?;
    let corners = [[-6.0, -6.0], [6.0, -6.0], [6.0, 6.0], [-6.0, 6.0]];
    let corners = corners.map(|[x, z]| [x, 0.0, z]).to_vec();
    let floor = Mesh::new("floor", corners, vec![[0, 2, 1], [0, 3, 2]]);
    scene.add_mesh(floor.material(grey))?;
    scene.add_mesh(task.mesh.clone().material(paint).transform(transform))?;
    let position = DVec3::new(2.0, 4.5, 2.5);
    let lamp = PointLight { position, color: DVec3::ONE, radiant_intensity: 60.0 };
    scene.add_light("lamp", lamp)?;
    let direction = DVec3::new(-1.0, 0.8, 1.2);
    let sky = DistantLight { direction, color: DVec3::ONE, irradiance: 0.8 };
    scene.add_light("sky", sky)?;
    Ok(scene)
}

/// How far starts are spread: in degrees, and in lengths, along each axis.
const SPREADS: [f64; 2] = [40.0, 0.3];

/// The problem: from `start` to the true pose, with images that are halved so often to begin with, and from so
/// many starts around it.
pub fn experiment(
    task: &Task,
    start: &Pose,
    coarse_to_fine: u32,
    starts: u32,
) -> Result<Experiment, Error> {
    let scene = scene(task, start)?;
    let ids =
        [scene.parameter("mesh.object.rotation")?, scene.parameter("mesh.object.translation")?];
    // Degrees, and lengths.
    let rates = [2.0, 0.04];
    let parameters = ids.into_iter().zip(rates).zip(SPREADS).map(|((id, rate), spread)| {
        let (learning_rate, spread) = (Some(rate), Some(vec![spread; 3]));
        TunedParameter { learning_rate, spread, ..TunedParameter::new(id) }
    });
    let section = OptimizeSection {
        parameters: parameters.collect(),
        target: Some(Target::Values(ids.into_iter().zip(task.truth.numbers()).collect())),
        coarse_to_fine,
        starts: (starts > 1).then_some(Starts { count: starts, seed: 1 }),
        ..OptimizeSection::default()
    };
    Ok(Experiment::new(scene, Some(section)))
}

/// The problem, ready to run. Without edges pixels are means of four by four samples, with edges of two by two:
/// triangles of a mesh are smaller than pixels.
pub fn recovery<'a>(experiment: &'a Experiment, edges: Edges) -> Result<Recovery<'a>, Error> {
    let side = if edges == Edges::Off { 4 } else { 2 };
    let sampling = Sampling::Grid(side);
    Recovery::new(experiment, "pose", &Settings { edges, sampling, ..Settings::default() })
}

/// Where `steps` steps lead. The learning rates of Adam fall to a hundredth.
pub fn run(recovery: &Recovery<'_>, optimizer: Optimizer, steps: u64) -> Result<Outcome, Error> {
    let schedule = match optimizer.finds_step_lengths() {
        true => Schedule::Constant,
        false => Schedule::Exponential(Default::default()),
    };
    let settings =
        OptimizeSettings { iterations: steps, optimizer, schedule, ..recovery.settings() };
    recovery.run(&settings, &mut Quiet)
}

/// Whether an error is none to speak of: an angle in degrees, and a distance.
pub fn is_found((degrees, distance): (f64, f64)) -> bool {
    degrees < 1.0 && distance < 0.02
}
