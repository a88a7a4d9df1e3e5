//! A texture on a wavy sheet, from three images of it.

use std::f64::consts::PI;
use std::path::Path;

use glam::{DVec3, dvec3};
use renderer::experiment::{Experiment, Target};
use renderer::optimize::{Evaluation, Optimization, Outcome, Quiet, Settings as OptimizeSettings};
use renderer::recovery::Recovery;
use renderer::{Error, Mesh, Settings};

/// Camera, light and the texture to recover, grey at first, without the sheet.
const SCENE: &str = r#"
[camera]
look_from = [0.0, 0.0, 3.2]
look_at = [0.0, 0.0, 0.0]
vfov = 40.0
width = 256
height = 256

[[light]]
name = "sun"
type = "distant"
direction = [0.3, 0.5, 1.0]
irradiance = 3.14159

[material.sheet]
diffuse_texture = "pattern"
diffuse = [1.0, 1.0, 1.0]

[texture.pattern]
size = [TEXELS, TEXELS]
color = [0.5, 0.5, 0.5]
wrap = "clamp"

[optimize]
learning_rate = 0.05

[[optimize.parameter]]
path = "texture.pattern.texels"
max = 1.0
"#;

/// Where the camera stands in each view.
const VIEWS: [DVec3; 3] = [dvec3(0.0, 0.0, 3.2), dvec3(1.6, 0.9, 2.6), dvec3(-1.4, -1.1, 2.7)];
/// Quadrilaterals along each side of the sheet.
const CELLS: u32 = 24;

/// One problem for each view, of a texture of `texels` by `texels`, in images of `size` by `size`
/// pixels. All have the same texture to find.
pub fn views(texels: u32, size: u32) -> Result<Vec<Experiment>, Error> {
    let text = SCENE.replace("TEXELS", &texels.to_string());
    let mut experiment = Experiment::parse(&text, Path::new(""), "the scene")?;
    let scene = &mut experiment.scene;
    (scene.width, scene.height) = (size, size);
    scene.add_mesh(sheet())?;
    let pattern = (scene.parameter("texture.pattern.texels")?, pattern(texels).concat());
    if let Some(optimize) = &mut experiment.optimize {
        optimize.target = Some(Target::Values(vec![pattern]));
    }
    let view = |look_from| {
        let mut view = experiment.clone();
        view.scene.camera.look_from = look_from;
        view
    };
    Ok(VIEWS.map(view).to_vec())
}

/// A square sheet with waves, two units wide, whose texture covers it once.
fn sheet() -> Mesh {
    let at = |i: u32| f64::from(i) / f64::from(CELLS);
    let grid = || (0..=CELLS).flat_map(|i| (0..=CELLS).map(move |j| (at(j), at(i))));
    let height = |u: f64, v: f64| 0.12 * (2.0 * PI * u).sin() * (1.5 * PI * v).cos();
    let vertex = |(u, v): (f64, f64)| [2.0 * u - 1.0, 2.0 * v - 1.0, height(u, v)];
    let cells = (0..CELLS).flat_map(|i| (0..CELLS).map(move |j| i * (CELLS + 1) + j));
    let triangles: Vec<[u32; 3]> = cells
        .flat_map(|a| [[a, a + 1, a + CELLS + 2], [a, a + CELLS + 2, a + CELLS + 1]])
        .collect();
    let coordinates = grid().map(|(u, v)| [u, v]).collect();
    Mesh::new("sheet", grid().map(vertex).collect(), triangles.clone())
        .texture_coordinates(coordinates, triangles)
}

/// The true texture: coloured rings with a checkerboard over them.
fn pattern(texels: u32) -> Vec<[f64; 3]> {
    let places = (0..texels).flat_map(|row| (0..texels).map(move |column| (column, row)));
    let texel = |(column, row): (u32, u32)| {
        let place = |index: u32| 2.0 * (f64::from(index) + 0.5) / f64::from(texels) - 1.0;
        let (x, y) = (place(column), place(row));
        let wave = |phase: f64| 0.5 + 0.35 * (9.0 * x.hypot(y) + phase).cos();
        let checker =
            if (8 * column / texels + 8 * row / texels).is_multiple_of(2) { 1.0 } else { 0.6 };
        [0.0, 2.0, 4.0].map(|phase| checker * wave(phase))
    };
    places.map(texel).collect()
}

/// The problems, ready to run.
pub fn recoveries(views: &[Experiment]) -> Result<Vec<Recovery<'_>>, Error> {
    let ready = |view| Recovery::new(view, "texture recovery", &Settings::default());
    views.iter().map(ready).collect()
}

/// Minimises the sum of the losses of all views.
pub fn run(recoveries: &[Recovery<'_>], steps: u64) -> Result<Outcome, Error> {
    let mut objectives: Vec<_> = recoveries.iter().map(Recovery::objective).collect();
    let mut sum = |x: &[f64]| {
        let mut total = Evaluation { loss: 0.0, gradient: vec![0.0; x.len()] };
        for objective in &mut objectives {
            let Evaluation { loss, gradient } = objective.evaluate(x);
            total.loss += loss;
            total.gradient.iter_mut().zip(gradient).for_each(|(total, part)| *total += part);
        }
        total
    };
    let settings = OptimizeSettings { iterations: steps, ..recoveries[0].settings() };
    Optimization::start(recoveries[0].variables(), &settings)?.run(&mut sum, &mut Quiet)
}

/// The root mean square error of the texels.
pub fn error(recovery: &Recovery<'_>, texels: &[f64]) -> f64 {
    let truth = recovery.variables()[0].target.iter().flatten();
    let squares: f64 = texels.iter().zip(truth).map(|(found, truth)| (found - truth).powi(2)).sum();
    (squares / texels.len() as f64).sqrt()
}
