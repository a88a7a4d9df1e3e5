//! Film scale and position of a camera, from one image of a rectangle.

use std::path::Path;

use renderer::experiment::Experiment;
use renderer::optimize::{Outcome, Quiet, Settings as OptimizeSettings};
use renderer::recovery::Recovery;
use renderer::{Camera, Error, Mesh, Settings};

/// The loss at which the paper stops, over its initial loss.
pub const PAPER_RATIO: f64 = 100.0 / 5705.98;

/// The paper's listings without the rectangle. There, the light is red, of which a green rectangle
/// reflects nothing where light and albedo are multiplied; so it is white here.
const SCENE: &str = r#"
[camera]
look_from = [5.0, -4.0, -20.0]
look_at = [0.0, 0.0, 0.0]
vfov = 90.0
film_scale = 3.0
width = 400
height = 300

[[light]]
name = "light"
type = "point"
position = [0.0, 0.0, -10.0]
radiant_intensity = 25000.0

[material.green]
diffuse = [0.0, 1.0, 0.0]

[optimize]
iterations = 400

[optimize.target_values]
"camera.look_from" = [0.0, 0.0, -30.0]
"camera.film_scale" = 1.0

[[optimize.parameter]]
path = "camera.look_from"

[[optimize.parameter]]
path = "camera.film_scale"
"#;

/// The problem, in an image of `width` by `height` pixels.
pub fn experiment(width: u32, height: u32) -> Result<Experiment, Error> {
    let mut experiment = Experiment::parse(SCENE, Path::new(""), "the scene")?;
    (experiment.scene.width, experiment.scene.height) = (width, height);
    // The rectangle of the paper: two triangles.
    let corners = [[20.0, 10.0], [20.0, -10.0], [-20.0, 10.0], [-20.0, -10.0]];
    let corners = corners.map(|[x, y]| [x, y, 0.0]).to_vec();
    experiment.scene.add_mesh(Mesh::new("rectangle", corners, vec![[0, 1, 2], [3, 1, 2]]))?;
    Ok(experiment)
}

/// Minimises with one learning rate for all parameters.
pub fn run(
    experiment: &Experiment,
    learning_rate: f64,
    settings: &OptimizeSettings,
) -> Result<Outcome, Error> {
    let mut experiment = experiment.clone();
    if let Some(optimize) = &mut experiment.optimize {
        optimize.learning_rate = Some(learning_rate);
    }
    let recovery = recovery(&experiment)?;
    recovery.run(settings, &mut Quiet)
}

/// The problem, ready to run.
pub fn recovery(experiment: &Experiment) -> Result<Recovery<'_>, Error> {
    Recovery::new(experiment, "camera calibration", &Settings::default())
}

/// The first iteration whose loss is no more than `ratio` times the initial one.
pub fn first_below(outcome: &Outcome, ratio: f64) -> Option<u64> {
    let limit = ratio * outcome.initial_loss;
    outcome.history.iter().find(|record| record.loss <= limit).map(|record| record.iteration)
}

/// What the image of a rectangle tells that the camera faces: film scale times distance.
pub fn magnification(camera: &Camera<f64>) -> f64 {
    camera.film_scale * camera.look_from.distance(camera.look_at)
}
