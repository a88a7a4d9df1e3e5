//! A ball, two thirds rough and one third glossy, under a map of the light from everywhere.

use std::path::Path;

use glam::{DVec3, dvec3};
use renderer::experiment::{Experiment, OptimizeSection, Target, TunedParameter};
use renderer::files::save_exr;
use renderer::scene::{Environment, EnvironmentObject, Integrator, PathTracing, Wrap};
use renderer::{
    Camera, Error, Image, Material, Mesh, ParameterId, Scene, Settings, SphereObject, Texture,
    render,
};

/// Texels of the map: to the right, and down.
pub const SIZE: [u32; 2] = [16, 8];
/// The guess of all of them.
const GUESS: f64 = 0.5;

/// The true map: a sky that is bluer above, brown ground, a warm sun, and a dim green lamp opposite.
pub fn map() -> Image {
    let [width, height] = SIZE;
    let pixel = |index: u32| {
        let (x, y) = (f64::from(index % width) + 0.5, f64::from(index / width) + 0.5);
        let up = 1.0 - 2.0 * y / f64::from(height);
        let base = if up > 0.0 {
            dvec3(0.5, 0.6, 0.7).lerp(dvec3(0.15, 0.3, 0.8), up)
        } else {
            dvec3(0.25, 0.18, 0.1)
        };
        let spot = |column: f64, row: f64, color: DVec3| {
            color * (-0.5 * ((x - column).powi(2) + (y - row).powi(2))).exp()
        };
        let lamps = spot(5.5, 2.0, dvec3(9.0, 7.0, 4.0)) + spot(12.5, 3.5, dvec3(0.4, 2.0, 0.6));
        (base + lamps).as_vec3().to_array()
    };
    Image { width, height, pixels: (0..width * height).map(pixel).collect() }
}

/// The ball under a map, before a black background.
pub fn scene(size: u32, map: &Image, path_tracing: PathTracing) -> Result<Scene, Error> {
    let mut scene = stage(size, map, path_tracing)?;
    let plaster = Material {
        specular: DVec3::splat(6.0),
        exponent: 60.0,
        ..Material::lambertian(DVec3::splat(0.6))
    };
    let plaster = scene.add_material("plaster", plaster)?;
    scene.add_sphere(SphereObject::new("ball", DVec3::ZERO, 1.0).material(plaster))?;
    Ok(scene)
}

/// Something else under a map: three matt tiles that lean to different sides, on a floor.
pub fn relit(size: u32, map: &Image, path_tracing: PathTracing) -> Result<Scene, Error> {
    let mut scene = stage(size, map, path_tracing)?;
    let white = scene.add_material("white", Material::lambertian(DVec3::splat(0.8)))?;
    let mut quad = |name: &str, corners: [[f64; 3]; 4]| {
        let mesh = Mesh::new(name, corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]]);
        scene.add_mesh(mesh.material(white))
    };
    quad("floor", [[-3.0, -1.0, 3.0], [3.0, -1.0, 3.0], [3.0, -1.0, -3.0], [-3.0, -1.0, -3.0]])?;
    for (name, x, lean) in [("left", -0.9, -0.5), ("middle", 0.0, 0.0), ("right", 0.9, 0.5)] {
        let (low, high) = (x - 0.35, x + 0.35);
        let corner = |x: f64, y: f64| [x, y, lean * (x - low) - 0.3 * y];
        let corners = [corner(low, -1.0), corner(high, -1.0), corner(high, 0.6), corner(low, 0.6)];
        quad(name, corners)?;
    }
    Ok(scene)
}

/// Nothing under a map.
fn stage(size: u32, map: &Image, path_tracing: PathTracing) -> Result<Scene, Error> {
    let camera = Camera { vfov: 34.0, ..Camera::looking(dvec3(0.0, 0.4, 4.0), DVec3::ZERO) };
    let mut scene = Scene::new(size, size, camera);
    scene.integrator = Integrator::Path(path_tracing);
    let sky = scene.add_texture(Texture {
        name: "sky".to_owned(),
        width: map.width,
        height: map.height,
        wrap: Wrap::Repeat,
        texels: map.pixels.clone().into(),
    })?;
    let sky = EnvironmentObject::from(Environment::constant(DVec3::ONE)).with_texture(sky);
    scene.environment = Some(EnvironmentObject { background: Some(DVec3::ZERO), ..sky });
    Ok(scene)
}

/// The problem: the map from a grey guess, by a target in which light took other paths, which is written to
/// `folder`.
pub fn experiment(scene: &Scene, target: PathTracing, folder: &Path) -> Result<Experiment, Error> {
    let truth = Scene { integrator: Integrator::Path(target), ..scene.clone() };
    std::fs::create_dir_all(folder).map_err(|error| Error::new(folder.display(), error))?;
    let path = folder.join("target.exr");
    save_exr(&render(&truth, &Settings::default())?, &path)?;
    let mut guess = scene.clone();
    let texels = texels(scene)?;
    guess.set(texels, &vec![GUESS; guess.count(texels)])?;
    let optimize = OptimizeSection {
        target: Some(Target::Image(path)),
        parameters: vec![TunedParameter { min: Some(vec![0.0]), ..TunedParameter::new(texels) }],
        learning_rate: Some(0.1),
        ..OptimizeSection::default()
    };
    Ok(Experiment::new(guess, Some(optimize)))
}

/// The texels of the map.
pub fn texels(scene: &Scene) -> Result<ParameterId, Error> {
    scene.parameter("texture.sky.texels")
}

/// The root of the mean squared difference of two maps over the sphere, and that of the first alone.
pub fn difference(truth: &[f64], found: &[f64]) -> [f64; 2] {
    let [width, height] = SIZE.map(|size| size as usize);
    let weight = |index: usize| {
        let row = index / (3 * width);
        (std::f64::consts::PI * (row as f64 + 0.5) / height as f64).sin()
    };
    let mean = |square: &dyn Fn(usize) -> f64| {
        let sums = (0..truth.len()).fold((0.0, 0.0), |(sum, total), index| {
            (sum + weight(index) * square(index), total + weight(index))
        });
        (sums.0 / sums.1).sqrt()
    };
    [mean(&|i| (truth[i] - found[i]).powi(2)), mean(&|i| truth[i].powi(2))]
}
