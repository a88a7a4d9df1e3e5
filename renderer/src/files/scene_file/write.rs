//! From an experiment to a folder.

use std::path::{Path, PathBuf};

use super::format::value::Numbers;
use super::format::{
    CameraEntry, ChannelEntry, EnvironmentEntry, LightEntry, MaterialEntry, MeshEntry,
    NormalsEntry, OptimizeEntry, ParameterEntry, SceneFile, SphereEntry, TextureEntry,
};
use super::numbers;
use crate::Error;
use crate::disk::write_atomically;
use crate::disk::{create_folder, read};
use crate::experiment::{Experiment, OptimizeSection, Target, TunedParameter};
use crate::files::images::save_exr;
use crate::files::names::Names;
use crate::files::obj::save_obj;
use crate::scene::{
    Integrator, LightObject, LightSource, MaterialObject, Normals, Scene, Slot, SphereObject,
    Transform,
};

/// Writes `scene.toml` and what it names, `meshes/*.obj` and `textures/*.exr`, into `folder`, which
/// is made if it does not exist; the path of the scene file. Every number is read back as it was, but
/// for texels, which are kept in single precision.
///
/// A mesh is read back with its vertices in the order in which its triangles first use them, and
/// without unused ones; those of every scene that came from files are in this order.
///
/// # Errors
///
/// If the scene is not valid, holds shapes or lights that a user adds, or a file cannot be written.
pub fn save_scene(scene: &Scene, folder: &Path) -> Result<PathBuf, Error> {
    save(scene, None, folder)
}

/// [`save_scene`] with the section `[optimize]`; a target image is copied into the folder.
///
/// # Errors
///
/// As [`save_scene`], and if the target image cannot be read.
pub fn save_experiment(experiment: &Experiment, folder: &Path) -> Result<PathBuf, Error> {
    save(&experiment.scene, experiment.optimize.as_ref(), folder)
}

fn save(
    scene: &Scene,
    optimize: Option<&OptimizeSection>,
    folder: &Path,
) -> Result<PathBuf, Error> {
    let path = folder.join("scene.toml");
    scene.validate(path.display())?;
    let shapes = scene.shapes.iter().map(|shape| format!("shape.{}", shape.name));
    let is_custom = |light: &&LightObject| matches!(light.source, LightSource::Custom { .. });
    let custom_lights = scene.lights.iter().filter(is_custom);
    let custom_lights = custom_lights.map(|light| format!("light.{}", light.name));
    if let Some(custom) = shapes.chain(custom_lights).next() {
        let problem = "is defined in Rust: a scene file cannot hold it";
        return Err(Error::new(format!("{}: {custom}", path.display()), problem));
    }
    create_folder(folder)?;
    // The scene file comes last: once it stands, all that it names does.
    let file = SceneFile {
        bounces: scene.bounces,
        integrator: match scene.integrator {
            Integrator::Direct => None,
            chosen @ Integrator::Path(_) => Some(chosen.into()),
        },
        camera: camera(scene),
        environment: scene.environment.map(|it| EnvironmentEntry { numbers: numbers::of(&it) }),
        lights: lights(scene),
        meshes: save_meshes(scene, folder)?,
        spheres: spheres(scene),
        textures: save_textures(scene, folder)?,
        materials: materials(scene),
        optimize: optimize.map(|section| optimize_entry(section, scene, folder)).transpose()?,
    };
    let text = toml::to_string(&file).map_err(|error| Error::new(path.display(), error))?;
    write_atomically(&path, text.as_bytes())?;
    Ok(path)
}

fn camera(scene: &Scene) -> CameraEntry {
    CameraEntry {
        width: Some(scene.width),
        height: Some(scene.height),
        numbers: numbers::of(&scene.camera),
    }
}

fn lights(scene: &Scene) -> Vec<LightEntry> {
    let entry = |light: &LightObject| {
        let kind = match &light.source {
            LightSource::Known(light) => Some(light.kind().to_owned()),
            LightSource::Custom { .. } => None,
        };
        let name = Some(light.name.clone());
        LightEntry { name, kind, power: None, numbers: numbers::of(light) }
    };
    scene.lights.iter().map(entry).collect()
}

fn spheres(scene: &Scene) -> Vec<SphereEntry> {
    let entry = |sphere: &SphereObject| SphereEntry {
        name: Some(sphere.name.clone()),
        material: Some(scene.materials[sphere.material as usize].name.clone()),
        numbers: numbers::of(sphere),
    };
    scene.spheres.iter().map(entry).collect()
}

fn materials(scene: &Scene) -> Vec<(String, MaterialEntry)> {
    let entry = |material: &MaterialObject| {
        let texture = |slot: Slot| {
            let index = material.textures.get(slot)?;
            Some(scene.textures[index as usize].name.clone())
        };
        let [emission_texture, diffuse_texture, specular_texture, opacity_texture] =
            Slot::ALL.map(texture);
        let entry = MaterialEntry {
            emission_texture,
            diffuse_texture,
            specular_texture,
            opacity_texture,
            numbers: numbers::of(material),
        };
        (material.name.clone(), entry)
    };
    scene.materials.iter().map(entry).collect()
}

fn save_meshes(scene: &Scene, folder: &Path) -> Result<Vec<MeshEntry>, Error> {
    if !scene.meshes.is_empty() {
        create_folder(&folder.join("meshes"))?;
    }
    let mut entries: Vec<MeshEntry> = Vec::new();
    let mut stems = Names::default();
    for mesh in &scene.meshes {
        let stem = stems.take(file_stem(&mesh.name));
        let path = Path::new("meshes").join(format!("{stem}.obj"));
        save_obj(mesh, &scene.materials, &folder.join(&path))?;
        let numbers = match mesh.transform == Transform::IDENTITY {
            true => Vec::new(),
            false => numbers::of(&mesh.transform),
        };
        entries.push(MeshEntry {
            path: Some(path),
            name: Some(mesh.name.clone()),
            material: None,
            normals: match &mesh.normals {
                Normals::Smooth => Some(NormalsEntry::Smooth),
                Normals::Given { triangles, .. } if triangles.iter().any(Option::is_some) => {
                    Some(NormalsEntry::File)
                }
                Normals::Given { .. } | Normals::Flat => None,
            },
            numbers,
        });
    }
    Ok(entries)
}

/// Textures are written as they are, in single precision.
fn save_textures(scene: &Scene, folder: &Path) -> Result<Vec<(String, TextureEntry)>, Error> {
    if !scene.textures.is_empty() {
        create_folder(&folder.join("textures"))?;
    }
    let mut entries: Vec<(String, TextureEntry)> = Vec::new();
    let mut stems = Names::default();
    for texture in &scene.textures {
        let stem = stems.take(file_stem(&texture.name));
        let path = Path::new("textures").join(format!("{stem}.exr"));
        save_exr(&texture.image(), &folder.join(&path))?;
        let entry = TextureEntry {
            path: Some(path),
            size: None,
            color: None,
            wrap: texture.wrap.into(),
            channel: ChannelEntry::Color,
        };
        entries.push((texture.name.clone(), entry));
    }
    Ok(entries)
}

/// A file name for an object. Names may hold what file names may not, and differ only in case.
fn file_stem(name: &str) -> String {
    let allowed = |c: char| if c.is_alphanumeric() || "-_".contains(c) { c } else { '_' };
    name.chars().map(allowed).collect::<String>().to_lowercase()
}

fn optimize_entry(
    section: &OptimizeSection,
    scene: &Scene,
    folder: &Path,
) -> Result<OptimizeEntry, Error> {
    let mut entry = OptimizeEntry {
        loss: section.loss,
        optimizer: section.optimizer,
        schedule: section.schedule,
        learning_rate: section.learning_rate,
        iterations: section.iterations,
        tolerance: section.tolerance,
        gradient_tolerance: section.gradient_tolerance,
        ..Default::default()
    };
    let numbers = |values: &Vec<f64>| Numbers::from(&values[..]);
    match &section.target {
        Some(Target::Image(image)) => {
            let mut name = PathBuf::from("target");
            if let Some(extension) = image.extension() {
                name.set_extension(extension);
            }
            write_atomically(&folder.join(&name), &read(image)?)?;
            entry.target = Some(name);
        }
        Some(Target::Values(values)) => {
            let value = |(id, values): &(_, _)| (scene.path(*id).to_string(), numbers(values));
            entry.target_values = values.iter().map(value).collect();
        }
        None => {}
    }
    let parameter = |tuned: &TunedParameter| ParameterEntry {
        path: scene.path(tuned.id).to_string(),
        learning_rate: tuned.learning_rate,
        min: tuned.min.as_ref().map(numbers),
        max: tuned.max.as_ref().map(numbers),
    };
    entry.parameters = section.parameters.iter().map(parameter).collect();
    Ok(entry)
}
