//! From a scene file to an experiment.

use std::f64::consts::PI;
use std::path::Path;

use glam::DVec3;

use super::coordinates::drop_bare_textures;
use super::dark::of_darkness;
use super::format::{EnvironmentEntry, LightEntry, SceneFile, SphereEntry};
use super::invisible::invisible_meshes;
use super::levels::of_levels;
use super::materials::MaterialTable;
use super::small::of_smallness;
use super::textures::TextureTable;
use super::{Problem, meshes, numbers, optimize, views};
use crate::Warning;
use crate::experiment::{Experiment, ViewTarget};
use crate::scene::{
    Camera, Environment, EnvironmentObject, Integrator, Light, LightObject, LightSource, Scene,
    SphereObject,
};

/// The experiment that the file `name` in `folder` describes.
pub(super) fn experiment(
    file: &SceneFile,
    folder: &Path,
    name: &str,
) -> Result<Experiment, Problem> {
    let views = views::read(file, folder)?;
    let Experiment { mut scene, mut warnings, files, .. } = scene(file, folder)?;
    warnings.append(&mut drop_bare_textures(&mut scene, name));
    warnings.extend(invisible_meshes(&scene, name));
    warnings.extend(of_smallness(&scene, name));
    warnings.extend(unworn(&scene, file, name));
    warnings.extend(of_levels(file, name));
    let targets = views::add(views, &mut scene);
    scene.check()?;
    let asks_for_light = targets.iter().all(|target| target.passes.is_empty());
    if asks_for_light {
        warnings.extend(of_darkness(&scene, name));
    }
    let mut optimize = match &file.optimize {
        Some(entry) => Some(optimize::read(entry, &scene, folder)?),
        None => None,
    };
    if targets.iter().any(|target| *target != ViewTarget::default()) {
        optimize.get_or_insert_default().views = targets;
    }
    Ok(Experiment { warnings, files, ..Experiment::new(scene, optimize) })
}

/// The scene, without anything to recover.
fn scene(file: &SceneFile, folder: &Path) -> Result<Experiment, Problem> {
    let camera = Camera::looking(DVec3::NAN, DVec3::NAN);
    let mut scene = Scene { bounces: file.bounces, ..Scene::new(0, 0, camera) };
    if let Some(samples) = file.light_samples {
        scene.light_samples = samples;
    }
    if let Some(integrator) = file.integrator {
        scene.integrator = integrator.into();
    }
    if file.views.is_empty() {
        views::set_camera(&mut scene, file.camera.as_ref())?;
    }
    for entry in &file.lights {
        add_light(&mut scene, entry)?;
    }
    let textures = TextureTable::new(&file.textures, folder)?;
    if let Some(entry) = &file.environment {
        scene.environment = Some(environment(entry, &textures)?);
    }
    let takes_all_paths = scene.integrator != Integrator::Direct;
    let mut materials = MaterialTable::new(&file.materials, textures, takes_all_paths)?;
    let mut warnings = Vec::new();
    for entry in &file.meshes {
        warnings.extend(meshes::add_entry(&mut scene, &mut materials, entry, folder)?);
    }
    for entry in &file.spheres {
        add_sphere(&mut scene, &materials, entry)?;
    }
    let files = materials.files();
    warnings.extend(materials.move_into(&mut scene));
    Ok(Experiment { warnings, files, ..Experiment::new(scene, None) })
}

/// Warns of materials of the scene file that nothing has: they may be those of meshes, misspelt. Of a file that shows
/// nothing, they are for what programs add.
fn unworn(scene: &Scene, file: &SceneFile, place: &str) -> impl Iterator<Item = Warning> {
    let mut is_worn = vec![false; scene.materials.len()];
    let of_meshes = scene.meshes.iter().flat_map(|mesh| &mesh.materials);
    for &material in of_meshes.chain(scene.spheres.iter().map(|sphere| &sphere.material)) {
        is_worn[material as usize] = true;
    }
    // Those of the scene file are the first ones.
    let shows_nothing = scene.meshes.is_empty() && scene.spheres.is_empty();
    let entries = file.materials.iter().zip(is_worn);
    let entries = entries.filter(move |(_, is_worn)| !is_worn && !shows_nothing);
    entries.map(move |((name, _), _)| {
        let place = format_args!("{place}: material.{name}");
        Warning::new(place, "no mesh and no sphere has this material")
    })
}

fn environment(
    entry: &EnvironmentEntry,
    textures: &TextureTable,
) -> Result<EnvironmentObject, Problem> {
    let texture = entry.texture.as_ref().map(|name| textures.index(name)).transpose();
    let texture = texture.map_err(|problem| Problem::new("environment.texture", problem))?;
    // A map says by itself how bright it is.
    let radiance = if texture.is_some() { DVec3::ONE } else { DVec3::NAN };
    let background = entry.background.map(DVec3::from);
    let values = Environment::constant(radiance);
    let mut environment = EnvironmentObject { values, texture, background };
    numbers::assign(&mut environment, "environment", "environment", &entry.numbers)?;
    Ok(environment)
}

/// The name of the object number `index` of its kind.
fn name_of(kind: &str, index: usize, name: Option<&String>) -> Result<String, Problem> {
    name.cloned().ok_or_else(|| {
        Problem::new(kind, format!("number {} has no name; each {kind} needs one", index + 1))
    })
}

fn add_light(scene: &mut Scene, entry: &LightEntry) -> Result<(), Problem> {
    let name = name_of("light", scene.lights.len(), entry.name.as_ref())?;
    let path = format!("light.{name}");
    let kinds = || Light::KINDS.map(|(kind, _)| kind).join(", ");
    let Some(kind) = &entry.kind else {
        let problem = format!("is missing; the types of lights are {}", kinds());
        return Err(Problem::new(format!("{path}.type"), problem));
    };
    let Some((_, mut light)) = Light::KINDS.into_iter().find(|(name, _)| name == kind) else {
        let problem = format!("`{kind}` is no type of light; there are {}", kinds());
        return Err(Problem::new(format!("{path}.type"), problem));
    };
    if let Some(power) = entry.power {
        let Light::Point(light) = &mut light else {
            let problem = format!("is a number of point lights; this is a {kind} light");
            return Err(Problem::new(format!("{path}.power"), problem));
        };
        if entry.numbers.iter().any(|(key, _)| key == "radiant_intensity") {
            let problem = "give either power or radiant_intensity, which is power / 4π";
            return Err(Problem::new(format!("{path}.power"), problem));
        }
        light.radiant_intensity = power / (4.0 * PI);
    }
    let mut light = LightObject { name, source: LightSource::Known(light) };
    numbers::assign(&mut light, "light", &path, &entry.numbers)?;
    scene.lights.push(light);
    Ok(())
}

fn add_sphere(
    scene: &mut Scene,
    materials: &MaterialTable<'_>,
    entry: &SphereEntry,
) -> Result<(), Problem> {
    let name = name_of("sphere", scene.spheres.len(), entry.name.as_ref())?;
    let path = format!("sphere.{name}");
    let material = match &entry.material {
        Some(material) => materials.index(material),
        None => Err("is missing; a sphere needs one".to_owned()),
    };
    let material = material.map_err(|problem| Problem::new(format!("{path}.material"), problem))?;
    let mut sphere = SphereObject::new(name, DVec3::NAN, f64::NAN).material(material);
    numbers::assign(&mut sphere, "sphere", &path, &entry.numbers)?;
    scene.spheres.push(sphere);
    Ok(())
}
