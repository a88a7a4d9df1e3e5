//! A Cornell box, one wall of which is seen only by the light that it sends to the others.

use std::path::Path;

use glam::{DVec3, dvec3};
use renderer::experiment::{Experiment, OptimizeSection, Target, TunedParameter};
use renderer::files::save_exr;
use renderer::scene::{Integrator, PathTracing};
use renderer::{
    Camera, Error, Image, Material, Mesh, ParameterId, Pass, Scene, Settings, Transform, render,
};

/// The walls whose colours are looked for: the first is behind the edge of the image.
pub const WALLS: [&str; 2] = ["red", "green"];
/// The guess of both: grey.
const GUESS: [f64; 3] = [0.5; 3];

/// The box as Mitsuba has it (`mi.cornell_box`), from -1 to 1, open to the front, seen from there.
pub fn cornell(size: u32, path_tracing: PathTracing) -> Result<Scene, Error> {
    let camera =
        Camera { vfov: 39.3077, ..Camera::looking(dvec3(0.0, 0.0, 3.9), dvec3(0.0, 0.0, 0.0)) };
    let mut scene = Scene::new(size, size, camera);
    scene.integrator = Integrator::Path(path_tracing);
    let colors = [
        ("white", dvec3(0.885809, 0.698859, 0.666422)),
        ("red", dvec3(0.570068, 0.0430135, 0.0443706)),
        ("green", dvec3(0.105421, 0.37798, 0.076425)),
        ("black", DVec3::ZERO),
    ];
    for (name, color) in colors {
        scene.add_material(name, Material::lambertian(color))?;
    }
    let emission = dvec3(18.387, 13.9873, 6.75357);
    let lamp = Material { emission, ..Material::lambertian(colors[0].1) };
    let lamp = scene.add_material("lamp", lamp)?;
    let walls = [
        ("floor", 0, [[-1.0, -1.0, 1.0], [1.0, -1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, -1.0, -1.0]]),
        ("ceiling", 0, [[-1.0, 1.0, -1.0], [1.0, 1.0, -1.0], [1.0, 1.0, 1.0], [-1.0, 1.0, 1.0]]),
        ("back", 0, [[-1.0, -1.0, -1.0], [1.0, -1.0, -1.0], [1.0, 1.0, -1.0], [-1.0, 1.0, -1.0]]),
        ("left", 1, [[-1.0, -1.0, 1.0], [-1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, 1.0, 1.0]]),
        ("right", 2, [[1.0, -1.0, -1.0], [1.0, -1.0, 1.0], [1.0, 1.0, 1.0], [1.0, 1.0, -1.0]]),
        ("panel", lamp, panel(0.99)),
        // Surfaces shine to both sides.
        ("fitting", 3, panel(0.9901)),
    ];
    for (name, material, corners) in walls {
        let mesh = Mesh::new(name, corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]]);
        scene.add_mesh(mesh.material(material))?;
    }
    for (name, translation, turn, scale) in [
        ("low", dvec3(0.335, -0.7, 0.38), -17.0, DVec3::splat(0.3)),
        ("high", dvec3(-0.33, -0.4, -0.28), 18.25, dvec3(0.3, 0.61, 0.3)),
    ] {
        let rotation = dvec3(0.0, turn, 0.0);
        let mut cube = cube(name);
        cube.transform = Transform { translation, rotation, scale };
        scene.add_mesh(cube)?;
    }
    Ok(scene)
}

fn panel(y: f64) -> [[f64; 3]; 4] {
    [[-0.23, y, -0.18], [0.23, y, -0.18], [0.23, y, 0.2], [-0.23, y, 0.2]]
}

/// A cube from -1 to 1.
fn cube(name: &str) -> Mesh {
    let corner = |i: u32| [0, 1, 2].map(|axis| if i >> axis & 1 == 1 { 1.0 } else { -1.0 });
    let sides: [[u32; 4]; 6] =
        [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    let halves = sides.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]);
    Mesh::new(name, (0..8).map(corner).collect(), halves.collect())
}

/// The box from inside, so that the left wall stands beside the image.
pub fn scene(size: u32, path_tracing: PathTracing) -> Result<Scene, Error> {
    let mut scene = cornell(size, path_tracing)?;
    scene.camera.look_from = dvec3(-0.6, 0.1, 1.8);
    scene.camera.look_at = dvec3(0.45, -0.2, -1.0);
    scene.camera.vfov = 36.0;
    Ok(scene)
}

/// Whether a pixel of the image shows a material.
pub fn is_seen(scene: &Scene, material: &str) -> Result<bool, Error> {
    let diffuse = scene.get(scene.parameter(&format!("material.{material}.diffuse"))?);
    let shown = Settings { pass: Pass::Albedo, ..Settings::default() };
    let is_it = |pixel: &[f32; 3]| pixel.iter().zip(&*diffuse).all(|(a, &b)| *a == b as f32);
    Ok(render(scene, &shown)?.pixels.iter().any(is_it))
}

/// The problem: the colours of both walls from a grey guess, in light that took other paths in the target,
/// which is written to `folder`.
pub fn experiment(scene: &Scene, target: PathTracing, folder: &Path) -> Result<Experiment, Error> {
    let truth = Scene { integrator: Integrator::Path(target), ..scene.clone() };
    let image: Image = render(&truth, &Settings::default())?;
    std::fs::create_dir_all(folder).map_err(|error| Error::new(folder.display(), error))?;
    let path = folder.join("target.exr");
    save_exr(&image, &path)?;
    let mut guess = scene.clone();
    for id in walls(scene)? {
        guess.set(id, &GUESS)?;
    }
    let tuned = |id| TunedParameter {
        min: Some(vec![0.0; 3]),
        max: Some(vec![1.0; 3]),
        ..TunedParameter::new(id)
    };
    let optimize = OptimizeSection {
        target: Some(Target::Image(path)),
        parameters: walls(scene)?.into_iter().map(tuned).collect(),
        learning_rate: Some(0.05),
        ..OptimizeSection::default()
    };
    Ok(Experiment::new(guess, Some(optimize)))
}

/// The colours of the walls.
pub fn walls(scene: &Scene) -> Result<Vec<ParameterId>, Error> {
    WALLS.iter().map(|wall| scene.parameter(&format!("material.{wall}.diffuse"))).collect()
}
