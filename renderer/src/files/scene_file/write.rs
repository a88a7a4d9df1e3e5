//! From an experiment to a folder.

use std::path::{Path, PathBuf};

use renderer_files::disk::{create_folder, read, write_atomically};
use renderer_files::names::file_stems;

use super::format::value::Numbers;
use super::format::{
    CameraEntry, ChannelEntry, EnvironmentEntry, LaplacianEntry, LightEntry, MatchedEntry,
    MatchedFile, MaterialEntry, MeshEntry, NormalsEntry, OptimizeEntry, ParameterEntry, SceneFile,
    SphereEntry, TextureEntry, ViewEntry,
};
use super::numbers;
use crate::Error;
use crate::experiment::{
    Experiment, MatchedPass, OptimizeSection, Target, Term, TunedParameter, ViewTarget,
};
use crate::files::images::save_exr;
use crate::files::save_obj;
use crate::optimize::Scale;
use crate::scene::{
    Bsdf, DEFAULT_LIGHT_SAMPLES, Integrator, LightObject, LightSource, MaterialObject, Normals,
    Scene, Slot, SphereObject, Transform,
};
use crate::settings::Pass;

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
        light_samples: (scene.light_samples != DEFAULT_LIGHT_SAMPLES)
            .then_some(scene.light_samples),
        integrator: match scene.integrator {
            Integrator::Direct => None,
            chosen @ Integrator::Path(_) => Some(chosen.into()),
        },
        camera: scene.views().is_empty().then(|| camera(scene)),
        views: views(scene, optimize, folder)?,
        environment: scene.environment.map(|it| EnvironmentEntry {
            texture: it.texture.map(|index| scene.textures[index as usize].name.clone()),
            background: it.background.map(Into::into),
            numbers: numbers::of(&it),
        }),
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

/// The views, with copies of the files that they are compared with.
fn views(
    scene: &Scene,
    optimize: Option<&OptimizeSection>,
    folder: &Path,
) -> Result<Vec<ViewEntry>, Error> {
    let stems = file_stems(scene.views().iter().map(|view| &view.name[..]));
    let mut entries = Vec::new();
    for (index, (view, stem)) in scene.views().iter().zip(stems).enumerate() {
        let default = ViewTarget::default();
        let target = optimize.and_then(|section| section.views.get(index)).unwrap_or(&default);
        let copy = |kind: &str, file: &Path| copied(file, &format!("{kind}-{stem}"), folder);
        let copied = |kind: &str, file: &Option<PathBuf>| {
            file.as_ref().map(|file| copy(kind, file)).transpose()
        };
        let matched = |pass: Pass| {
            let matched = target.passes.iter().find(|matched| matched.pass == pass);
            let entry = |MatchedPass { file, weight, .. }: &MatchedPass| {
                let path = copy(pass.name(), file)?;
                Ok::<_, Error>(MatchedEntry(MatchedFile { path, weight: *weight }))
            };
            matched.map(entry).transpose()
        };
        entries.push(ViewEntry {
            path: None,
            name: Some(view.name.clone()),
            width: Some(view.width),
            height: Some(view.height),
            target: copied("target", &target.image)?,
            coverage: matched(Pass::Coverage)?,
            depth: matched(Pass::Depth)?,
            normals: matched(Pass::Normals)?,
            mask: copied("mask", &target.mask)?,
            weight: (target.weight != 1.0).then_some(target.weight),
            held_out: target.held_out.then_some(true),
            numbers: numbers::of(&view.camera),
        });
    }
    Ok(entries)
}

/// Copies a file into a folder, as `stem` with its extension; the name there.
fn copied(file: &Path, stem: &str, folder: &Path) -> Result<PathBuf, Error> {
    let mut name = PathBuf::from(stem);
    if let Some(extension) = file.extension() {
        name.set_extension(extension);
    }
    write_atomically(&folder.join(&name), &read(file)?)?;
    Ok(name)
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
        let kind = match material.bsdf {
            Bsdf::BlinnPhong => None,
            bsdf => Bsdf::ALL.into_iter().find(|(_, other)| *other == bsdf),
        };
        let entry = MaterialEntry {
            kind: kind.map(|(name, _)| name.to_owned()),
            emission_texture: texture(Slot::Emission),
            diffuse_texture: texture(Slot::Diffuse),
            specular_texture: texture(Slot::Specular),
            opacity_texture: texture(Slot::Opacity),
            metallic_roughness_texture: texture(Slot::MetallicRoughness),
            normal_texture: texture(Slot::Normal),
            normal_scale: Some(material.normal_scale).filter(|&scale| scale != 1.0),
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
    let stems = file_stems(scene.meshes.iter().map(|mesh| &mesh.name[..]));
    for (mesh, stem) in scene.meshes.iter().zip(stems) {
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
    let stems = file_stems(scene.textures.iter().map(|texture| &texture.name[..]));
    for (texture, stem) in scene.textures.iter().zip(stems) {
        let path = Path::new("textures").join(format!("{stem}.exr"));
        save_exr(&texture.image(), &folder.join(&path))?;
        let entry = TextureEntry {
            path: Some(path),
            size: None,
            color: None,
            wrap: texture.wrap,
            channel: ChannelEntry::Color,
        };
        entries.push((texture.name.clone(), entry));
    }
    Ok(entries)
}

fn optimize_entry(
    section: &OptimizeSection,
    scene: &Scene,
    folder: &Path,
) -> Result<OptimizeEntry, Error> {
    let mut entry = OptimizeEntry {
        loss: section.loss,
        mask: section.mask.as_ref().map(|mask| copied(mask, "mask", folder)).transpose()?,
        coarse_to_fine: (section.coarse_to_fine > 0).then_some(section.coarse_to_fine),
        batch: section.batch.map(|batch| batch.size),
        resample: section.resample,
        starts: section.starts.map(|starts| starts.count),
        seed: section.batch.map(|of| of.seed).or(section.starts.map(|of| of.seed)),
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
            entry.target = Some(copied(image, "target", folder)?);
        }
        Some(Target::Values(values)) => {
            let value = |(id, values): &(_, _)| (scene.path(*id).to_string(), numbers(values));
            entry.target_values = values.iter().map(value).collect();
        }
        None => {}
    }
    let parameter = |tuned: &TunedParameter| ParameterEntry {
        path: scene.path(tuned.id).to_string(),
        scale: (tuned.scale != Scale::default()).then_some(tuned.scale),
        learning_rate: tuned.learning_rate,
        min: tuned.min.as_ref().map(numbers),
        max: tuned.max.as_ref().map(numbers),
        spread: tuned.spread.as_ref().map(numbers),
        large_steps: tuned.large_steps,
        laplacian: tuned.terms.iter().find_map(|weighted| match weighted.term {
            Term::Laplacian(weights) => Some(LaplacianEntry { weight: weighted.weight, weights }),
            _ => None,
        }),
        edge_length: weight_of(tuned, Term::EdgeLength),
        normal_consistency: weight_of(tuned, Term::NormalConsistency),
        total_variation: weight_of(tuned, Term::TotalVariation),
        remesh: tuned.remesh,
    };
    entry.parameters = section.parameters.iter().map(parameter).collect();
    Ok(entry)
}

/// The weight of a term of a parameter, if it has it.
fn weight_of(tuned: &TunedParameter, term: Term) -> Option<f64> {
    tuned.terms.iter().find(|weighted| weighted.term == term).map(|weighted| weighted.weight)
}
