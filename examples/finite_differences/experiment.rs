//! Random triangles, and the derivatives of a loss by their 20 parameters each, two ways.

use std::ops::Range;
use std::path::Path;

use glam::{DVec3, dvec3};
use renderer::experiment::{Experiment, OptimizeSection, Target, TunedParameter};
use renderer::optimize::Objective;
use renderer::recovery::Recovery;
use renderer::{
    Edges, Error, ImageLoss, LossKind, Material, Mesh, ParameterId, Renderer, Scene, Settings,
};

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
radiant_intensity = 225.0
"#;

/// The parameters of a triangle: three vertices, three colours, the exponent, the mirror.
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
    let indices = 0..count as u32;
    let triangles = indices.clone().map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    let mesh = Mesh::new("triangles", vertices, triangles);
    let mut color =
        || dvec3(random.between(0.1, 0.9), random.between(0.1, 0.9), random.between(0.1, 0.9));
    let mut scene = Experiment::parse(SCENE, Path::new(""), "the scene")?.scene;
    (scene.width, scene.height) = (size, size);
    for index in indices.clone() {
        let (emission, diffuse, specular) = (0.1 * color(), color(), color());
        let numbers = color();
        let (exponent, mirror) = (1.0 + 20.0 * numbers.x, DVec3::splat(0.3 * numbers.y));
        let material =
            Material { emission, specular, exponent, mirror, ..Material::lambertian(diffuse) };
        scene.add_material(format!("paint{index}"), material)?;
    }
    scene.add_mesh(Mesh { materials: indices.collect(), ..mesh })?;
    Ok(scene)
}

/// The scene with all of its triangles' parameters to vary. The loss is the mean squared difference
/// to the image that it has with other colours.
pub fn experiment(scene: Scene, random: &mut Random) -> Experiment {
    let mut ids = scene.parameters();
    let of_paper = ["vertices", "emission", "diffuse", "specular", "exponent", "mirror"];
    ids.retain(|id| of_paper.contains(&id.field));
    // Vertices come first.
    ids.sort_by_key(|id| id.field != "vertices");
    let mut other_color = |&id: &ParameterId| {
        (id, scene.get(id).iter().map(|value| value * random.between(0.5, 1.5)).collect())
    };
    let diffuse = ids.iter().filter(|id| id.field == "diffuse");
    let target = Target::Values(diffuse.map(&mut other_color).collect());
    let tuned = TunedParameter::new;
    let optimize = OptimizeSection {
        target: Some(target),
        parameters: ids.into_iter().map(tuned).collect(),
        ..OptimizeSection::default()
    };
    Experiment::new(scene, Some(optimize))
}

/// The problem in double precision, which finite differences need.
pub fn recovery(experiment: &Experiment) -> Result<Recovery<'_>, Error> {
    Recovery::new(
        experiment,
        "random triangles",
        &Settings { edges: Edges::Off, ..Settings::default() }.in_double_precision(),
    )
}

/// The derivatives by the backward pass. The mirror is one number, so its three channels add up.
pub fn backward(recovery: &Recovery<'_>, objective: &mut dyn Objective, x: &[f64]) -> Vec<f64> {
    let gradient = objective.evaluate(x).gradient;
    let mut rest = &gradient[..];
    let mut derivatives = Vec::with_capacity(gradient.len());
    for (&id, variable) in recovery.ids().iter().zip(recovery.variables()) {
        let (block, others) = rest.split_at(variable.initial.len());
        rest = others;
        match id.field {
            "mirror" => derivatives.push(block.iter().sum()),
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
) -> Result<Vec<Derivative>, Error> {
    let image_loss = ImageLoss::new(LossKind::MeanSquared, recovery.target(), false);
    let mut renderer = Renderer::new(scene, recovery.render_settings())?;
    let mut moved = scene.clone();
    let numbers = recovery.ids().iter().flat_map(|&id| {
        let count = scene.get(id).len();
        // The three channels of the mirror vary together.
        let width = if id.field == "mirror" { count } else { 1 };
        (0..count).step_by(width).map(move |first| (id, first..first + width))
    });
    let derivative = |(index, (id, range)): (usize, (ParameterId, Range<usize>))| {
        let original = scene.get(id);
        let mut loss_at = |offset: f64| {
            let mut numbers = original.to_vec();
            numbers[range.clone()].iter_mut().for_each(|number| *number += offset);
            moved.set(id, &numbers)?;
            renderer.update(&moved);
            Ok::<f64, Error>(renderer.loss(&image_loss))
        };
        let (above, below) = (loss_at(STEP)?, loss_at(-STEP)?);
        moved.set(id, &original)?;
        Ok((index, (above - below) / (2.0 * STEP)))
    };
    numbers.enumerate().step_by(stride).map(derivative).collect()
}

/// The largest difference between both ways, relatively to the largest derivative, over what moves no
/// edge: vertices do, and the backward pass has the interior term of theirs.
pub fn largest_error(backward: &[f64], differences: &[Derivative]) -> f64 {
    let vertices = VERTICES * backward.len() / PER_TRIANGLE;
    let scale = backward[vertices..].iter().fold(f64::MIN_POSITIVE, |scale, d| scale.max(d.abs()));
    let inner = differences.iter().filter(|(index, _)| *index >= vertices);
    inner.fold(0.0, |error, &(index, d)| larger(error, (backward[index] - d).abs() / scale))
}

/// The larger of two errors; no number is larger than any, while `f64::max` would drop it.
pub fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}
