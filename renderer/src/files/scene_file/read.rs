//! From a scene file to an experiment.

use std::path::Path;

use glam::DVec3;

use super::format::{CameraEntry, LightEntry, LightKind, SceneFile};
use super::materials::MaterialTable;
use super::textures::TextureTable;
use super::{Problem, meshes, optimize};
use crate::experiment::Experiment;
use crate::files::Warning;
use crate::kernels::camera::Camera;
use crate::kernels::light::{DistantLight, PointLight};
use crate::kernels::material::Material;
use crate::kernels::sphere::Sphere;
use crate::scene::{Light, Parameters, Scene, SphereObject};

/// The experiment that the file `name` in `folder` describes.
pub(super) fn experiment(
    file: &SceneFile,
    folder: &Path,
    name: &str,
) -> Result<Experiment, Problem> {
    let (scene, mut warnings) = scene(file, folder)?;
    scene.check()?;
    if is_black(&scene) {
        let problem =
            "has no light: add a [[light]], or an `ambient` to a material, or all is black";
        warnings.push(Warning::new(name, problem));
    }
    let optimize = match &file.optimize {
        Some(entry) => Some(optimize::read(entry, &scene, folder)?),
        None => None,
    };
    Ok(Experiment { scene, optimize, warnings })
}

/// The scene, and what was left out of the files that it names.
fn scene(file: &SceneFile, folder: &Path) -> Result<(Scene, Vec<Warning>), Problem> {
    let mut scene = Scene::empty();
    scene.bounces = file.bounces;
    scene.width = file.camera.width;
    scene.height = file.camera.height;
    scene.parameters.camera = camera(&file.camera);
    for entry in &file.lights {
        scene.light_names.push(entry.name.clone());
        scene.parameters.lights.push(light(entry)?);
    }
    let textures = TextureTable::new(&file.textures, folder)?;
    let mut materials = MaterialTable::new(&file.materials, textures)?;
    let mut warnings = Vec::new();
    for entry in &file.meshes {
        warnings.extend(meshes::add_entry(&mut scene, &mut materials, entry, folder)?);
    }
    for entry in &file.spheres {
        let material = materials
            .index(&entry.material)
            .map_err(|problem| Problem::new(format!("sphere.{}.material", entry.name), problem))?;
        scene.spheres.push(SphereObject { name: entry.name.clone(), material });
        let center = DVec3::from_array(entry.center);
        scene.parameters.spheres.push(Sphere { center, radius: entry.radius });
    }
    warnings.extend(materials.move_into(&mut scene));
    meshes::drop_unused_coordinates(&mut scene);
    Ok((scene, warnings))
}

/// Whether a scene shows something, but nothing that lights it.
fn is_black(scene: &Scene) -> bool {
    let glows = |material: &Material<f64>| material.ambient != DVec3::ZERO;
    let Parameters { lights, materials, .. } = &scene.parameters;
    lights.is_empty() && !materials.is_empty() && !materials.iter().any(glows)
}

fn camera(entry: &CameraEntry) -> Camera<f64> {
    Camera {
        look_from: DVec3::from_array(entry.look_from),
        look_at: DVec3::from_array(entry.look_at),
        up: DVec3::from_array(entry.up),
        vfov: entry.vfov,
        focus: entry.focus,
    }
}

fn light(entry: &LightEntry) -> Result<Light<f64>, Problem> {
    let color = DVec3::from_array(entry.color);
    let intensity = entry.intensity;
    let refuse = |field: &str, problem: &str| {
        Err(Problem::new(format!("light.{}.{field}", entry.name), problem))
    };
    match (entry.kind, entry.position, entry.direction) {
        (LightKind::Point, Some(position), None) => {
            let position = DVec3::from_array(position);
            Ok(Light::Point(PointLight { position, color, intensity }))
        }
        (LightKind::Distant, None, Some(direction)) => {
            let direction = DVec3::from_array(direction);
            Ok(Light::Distant(DistantLight { direction, color, intensity }))
        }
        (LightKind::Point, None, _) => refuse("position", "is missing; a point light needs one"),
        (LightKind::Point, ..) => refuse("direction", "a point light has none, but a position"),
        (LightKind::Distant, _, None) => {
            refuse("direction", "is missing; a distant light needs one")
        }
        (LightKind::Distant, ..) => refuse("position", "a distant light has none, but a direction"),
    }
}
