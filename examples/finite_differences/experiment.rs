//! Random triangles, and the derivatives of a loss by their 20 parameters each, two ways.

use std::iter;
use std::ops::Range;
use std::path::Path;

use glam::{DVec3, dvec3};
use renderer::Error;
use renderer::arithmetic::{Arithmetic, Precision};
use renderer::experiment::{Experiment, OptimizeSection, Target, TunedParameter};
use renderer::integrator::{Prepared, loss};
use renderer::kernels::material::Material;
use renderer::loss::{ImageLoss, LossKind};
use renderer::optimize::Objective;
use renderer::recovery::Recovery;
use renderer::scene::{MaterialObject, MeshObject, ParameterId, Scene};

use wide::f64x8;

use super::random::Random;

/// Camera and light, which stay.
const SCENE: &str = r#"
bounces = 1

[camera]
look_from = [0.0, 0.0, 6.0]
look_at = [0.0, 0.0, 0.0]
vfov = 40.0
width = 64
height = 64

[[light]]
name = "light"
type = "point"
position = [3.0, 4.0, 8.0]
intensity = 900.0
"#;

/// The parameters of a triangle: three vertices, three colours, the exponent, the reflection.
pub const PER_TRIANGLE: usize = 20;
/// Those of them that are coordinates of its vertices; these come first.
const VERTICES: usize = 9;
/// The step of the central differences.
const STEP: f64 = 1e-5;

/// A mesh of `count` random triangles that share no vertex, each of a material of its own, before a fixed camera and
/// light, in an image of `size` by `size` pixels.
pub fn scene(count: usize, size: u32, random: &mut Random) -> Result<Scene, Error> {
    let mut point = |reach: f64| {
        dvec3(
            random.between(-reach, reach),
            random.between(-reach, reach),
            random.between(-reach, reach),
        )
    };
    // The more triangles there are, the smaller they are: about the same part of the image shows
    // something.
    let edge = 1.5 / (count as f64).sqrt();
    let triangle = |_| {
        let middle = point(1.2);
        [(); 3].map(|()| (middle + point(edge)).to_array())
    };
    let vertices = (0..count).flat_map(triangle).collect();
    let mut color =
        || dvec3(random.between(0.1, 0.9), random.between(0.1, 0.9), random.between(0.1, 0.9));
    let mut material = |_| {
        let (ambient, diffuse, specular) = (0.1 * color(), color(), color());
        let numbers = color();
        Material {
            ambient,
            diffuse,
            specular,
            exponent: 1.0 + 20.0 * numbers.x,
            reflection: DVec3::splat(0.3 * numbers.y),
        }
    };
    let materials = (0..count).map(&mut material).collect();
    let indices = 0..count as u32;
    let mesh = MeshObject {
        name: "triangles".to_owned(),
        triangles: indices.clone().map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect(),
        materials: indices.collect(),
        texture_triangles: Vec::new(),
    };
    let mut scene = Experiment::parse(SCENE, Path::new(""), "the scene")?.scene;
    (scene.width, scene.height) = (size, size);
    scene.materials = (0..count).map(|i| MaterialObject::new(format!("paint{i}"))).collect();
    scene.parameters.materials = materials;
    scene.meshes.push(mesh);
    scene.parameters.vertices.push(vertices);
    scene.parameters.texture_coordinates.push(Vec::new());
    scene.validate("the scene")?;
    Ok(scene)
}

/// The scene with all of its triangles' parameters to vary. The loss is the mean squared difference
/// to the image that it has with other colours.
pub fn experiment(scene: Scene, random: &mut Random) -> Experiment {
    use ParameterId::*;
    let materials = 0..scene.materials.len();
    let of_material = |i| [Ambient(i), Diffuse(i), Specular(i), Exponent(i), Reflection(i)];
    let ids = iter::once(Vertices(0)).chain(materials.clone().flat_map(of_material));
    let tuned = |id| TunedParameter { id, learning_rate: None, min: None, max: None };
    let mut other_color = |index: usize| {
        let color = scene.parameters.materials[index].diffuse;
        (Diffuse(index), color.to_array().map(|value| value * random.between(0.5, 1.5)).to_vec())
    };
    let optimize = OptimizeSection {
        target: Some(Target::Values(materials.map(&mut other_color).collect())),
        parameters: ids.map(tuned).collect(),
        ..OptimizeSection::default()
    };
    Experiment::new(scene, Some(optimize))
}

/// The problem in double precision, which finite differences need.
pub fn recovery(experiment: &Experiment) -> Result<Recovery<'_>, Error> {
    Recovery::new(experiment, "random triangles", Arithmetic::fastest(Precision::F64))
}

/// The derivatives by the backward pass. The reflection is one number, so its three channels add up.
pub fn backward(recovery: &Recovery<'_>, objective: &mut dyn Objective, x: &[f64]) -> Vec<f64> {
    let gradient = objective.evaluate(x).gradient;
    let mut rest = &gradient[..];
    let mut derivatives = Vec::with_capacity(gradient.len());
    for (&id, variable) in recovery.ids().iter().zip(recovery.variables()) {
        let (block, others) = rest.split_at(variable.initial.len());
        rest = others;
        match id {
            ParameterId::Reflection(_) => derivatives.push(block.iter().sum()),
            _ => derivatives.extend(block),
        }
    }
    derivatives
}

/// A parameter, by index in the order of [`backward`], and its derivative.
pub type Derivative = (usize, f64);

/// The derivatives of every `stride`th parameter by central differences: two images for each.
pub fn central_differences(
    scene: &Scene,
    recovery: &Recovery<'_>,
    stride: usize,
) -> Vec<Derivative> {
    let image_loss = ImageLoss::new(LossKind::MeanSquared, recovery.target(), false);
    let mut prepared = Prepared::<f64x8>::new(scene);
    let mut parameters = scene.parameters.clone();
    let numbers = recovery.ids().iter().flat_map(|&id| {
        let count = scene.parameters.get(id).len();
        // The three channels of the reflection vary together.
        let width = if matches!(id, ParameterId::Reflection(_)) { count } else { 1 };
        (0..count).step_by(width).map(move |first| (id, first..first + width))
    });
    let derivative = |(index, (id, range)): (usize, (ParameterId, Range<usize>))| {
        let original = parameters.get(id)[range.start];
        let mut loss_at = |value| {
            parameters.get_mut(id)[range.clone()].fill(value);
            prepared.set_parameters(&parameters);
            loss(&prepared, &image_loss)
        };
        let (above, below) = (loss_at(original + STEP), loss_at(original - STEP));
        parameters.get_mut(id)[range].fill(original);
        (index, (above - below) / (2.0 * STEP))
    };
    numbers.enumerate().step_by(stride).map(derivative).collect()
}

/// The largest difference between both ways, relatively to the largest derivative, over what moves no
/// edge: vertices do, and the backward pass has the interior term of theirs.
pub fn largest_error(backward: &[f64], differences: &[Derivative]) -> f64 {
    let vertices = VERTICES * backward.len() / PER_TRIANGLE;
    let scale = backward[vertices..].iter().fold(f64::MIN_POSITIVE, |scale, d| scale.max(d.abs()));
    let inner = differences.iter().filter(|(index, _)| *index >= vertices);
    inner.fold(0.0, |error, &(index, d)| error.max((backward[index] - d).abs() / scale))
}
