//! The mesh that the first argument of a program names.

use std::path::Path;

use renderer::Error;
use renderer::experiment::Experiment;
use renderer::scene::Scene;

/// If the program has an argument, puts the geometry and the materials of the file that it names in
/// place of the scene's own; camera, lights and the size of the image stay.
pub fn apply(scene: &mut Scene) -> Result<(), Error> {
    let Some(argument) = std::env::args_os().nth(1) else {
        return Ok(());
    };
    let path = Path::new(&argument);
    let mut other = Experiment::load(path)?.scene;
    (other.width, other.height) = (scene.width, scene.height);
    other.parameters.camera = scene.parameters.camera;
    other.parameters.lights.clone_from(&scene.parameters.lights);
    other.light_names.clone_from(&scene.light_names);
    other.validate(path.display())?;
    *scene = other;
    Ok(())
}
