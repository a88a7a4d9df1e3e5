//! The mesh that the first argument of a program names.

use std::path::Path;

use renderer::experiment::Experiment;
use renderer::scene::LightSource;
use renderer::{Error, Scene};

/// If the program has an argument, puts the geometry and the materials of the file that it names in
/// place of the scene's own; camera, lights and the size of the image stay.
pub fn apply(scene: &mut Scene) -> Result<(), Error> {
    let Some(argument) = std::env::args_os().nth(1) else {
        return Ok(());
    };
    let file = Experiment::load(Path::new(&argument))?.scene;
    let mut other = Scene::new(scene.width, scene.height, scene.camera);
    other.bounces = scene.bounces;
    for light in scene.lights() {
        if let LightSource::Known(known) = light.source {
            other.add_light(&light.name, known)?;
        }
    }
    for texture in file.textures() {
        other.add_texture(texture.clone())?;
    }
    for material in file.materials() {
        other.add_material(&material.name, material.clone())?;
    }
    for mesh in file.meshes() {
        other.add_mesh(mesh.clone())?;
    }
    *scene = other;
    Ok(())
}
