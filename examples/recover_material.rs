//! A few lines of Rust recover the colour of a sphere from one image of it.
//!
//! `cargo run --release --example recover_material`

use std::path::Path;

use renderer::Settings;
use renderer::experiment::Experiment;
use renderer::optimize::Quiet;
use renderer::recovery::Recovery;

/// What is known, and what is guessed: a grey ball. The target is rendered with the true values.
const SCENE: &str = r#"
[camera]
look_from = [0.0, 1.0, 4.0]
look_at = [0.0, 0.0, 0.0]
width = 96
height = 96

[[light]]
name = "key"
type = "point"
position = [2.0, 3.0, 3.0]
radiant_intensity = 75.0

[[sphere]]
name = "ball"
center = [0.0, 0.0, 0.0]
radius = 1.0
material = "paint"

[material.paint]
diffuse = [0.5, 0.5, 0.5]
specular = [0.1, 0.1, 0.1]
exponent = 10.0

[optimize]
iterations = 500

[optimize.target_values]
"material.paint.diffuse" = [0.8, 0.3, 0.1]
"material.paint.exponent" = 40.0

[[optimize.parameter]]
path = "material.paint.diffuse"
max = 1.0

[[optimize.parameter]]
path = "material.paint.exponent"
learning_rate = 1.0
"#;

fn main() -> Result<(), renderer::Error> {
    let experiment = Experiment::parse(SCENE, Path::new("."), "the scene")?;
    let recovery = Recovery::new(&experiment, "the scene", &Settings::default())?;
    let outcome = recovery.run(&recovery.settings(), &mut Quiet)?;
    let paint = recovery.scene_at(&outcome.best.x).materials()[0].values;
    println!("diffuse  {:.4} (true: [0.8, 0.3, 0.1])", paint.diffuse);
    println!("exponent {:.3} (true: 40)", paint.exponent);
    println!(
        "loss {:.2e}, {:.1e} of the initial",
        outcome.best.loss,
        outcome.best.loss / outcome.initial_loss
    );
    Ok(())
}
