//! Adds a custom shape and a custom light to a scene, and recovers them from an image.
//!
//! The paper's users add objects by `intersect` and `get_normal`; here the kernels are also
//! `#[differentiable]`, so that every gradient reaches their parameters.

mod kinds;

use std::path::Path;

use glam::dvec3;
use kinds::{Ellipsoid, Spotlight};
use renderer::experiment::{Experiment, OptimizeSection, Target, TunedParameter};
use renderer::files::save_png;
use renderer::optimize::Quiet;
use renderer::optimize::schedule::{Cosine, Schedule};
use renderer::recovery::Recovery;
use renderer::{Error, Material, ParameterId, Scene, Settings};

const SCENE: &str = r#"
[camera]
look_from = [0.0, 1.5, 5.0]
look_at = [0.0, 0.3, 0.0]
width = 256
height = 192

[[sphere]]
name = "ground"
center = [0.0, -50.5, 0.0]
radius = 50.0
material = "ground"

[material.ground]
diffuse = [0.5, 0.5, 0.4]
"#;

/// What there is: by path the truth, and the guess.
const VALUES: [(&str, &[f64], &[f64]); 6] = [
    ("shape.egg.center", &[0.3, 0.2, 0.0], &[0.25, 0.15, 0.1]),
    ("shape.egg.radii", &[0.9, 0.6, 0.5], &[0.85, 0.65, 0.55]),
    ("light.spot.position", &[2.0, 4.0, 3.0], &[1.5, 4.2, 3.2]),
    ("light.spot.target", &[0.2, 0.0, 0.2], &[0.0, 0.0, 0.0]),
    ("light.spot.radiant_intensity", &[125.0], &[95.0]),
    ("light.spot.sharpness", &[20.0], &[15.0]),
];

fn main() -> Result<(), Error> {
    let folder = Path::new("out/custom_shape");
    std::fs::create_dir_all(folder).map_err(|error| Error::new(folder.display(), error))?;
    let mut guess = Experiment::parse(SCENE, Path::new(""), "scene")?.scene;
    add_own_kinds(&mut guess)?;
    let (mut ids, mut truth) = (Vec::new(), Vec::new());
    for (path, values, start) in VALUES {
        let id = guess.parameter(path)?;
        guess.set(id, start)?;
        ids.push(id);
        truth.push((id, values.to_vec()));
    }
    let experiment = Experiment::new(guess, Some(problem(&ids, truth)));
    let recovery = Recovery::new(&experiment, "custom shape", &Settings::default())?;
    save_png(recovery.target(), &folder.join("target.png"))?;
    save_png(&recovery.render(&experiment.scene), &folder.join("initial.png"))?;

    let outcome = recovery.run(&recovery.settings(), &mut Quiet)?;
    println!("loss {:.2e} -> {:.2e}", outcome.initial_loss, outcome.best.loss);
    let recovered = recovery.scene_at(&outcome.best.x);
    save_png(&recovery.render(&recovered), &folder.join("final.png"))?;
    for (id, (path, truth, guess)) in ids.into_iter().zip(VALUES) {
        println!("{path}");
        println!("  guess     {guess:.3?}");
        println!("  recovered {:.3?}", recovered.get(id));
        println!("  truth     {truth:.3?}");
    }
    println!("{}", folder.display());
    Ok(())
}

/// Adds an egg and a spotlight.
fn add_own_kinds(scene: &mut Scene) -> Result<(), Error> {
    let paint = Material {
        specular: dvec3(0.3, 0.3, 0.3),
        exponent: 30.0,
        ..Material::lambertian(dvec3(0.2, 0.4, 0.7))
    };
    let paint = scene.add_material("paint", paint)?;
    let (center, radii) = (dvec3(0.0, 0.0, 0.0), dvec3(1.0, 1.0, 1.0));
    scene.add_shape("egg", Ellipsoid { center, radii }, paint)?;
    let (position, target) = (dvec3(0.0, 5.0, 0.0), center);
    let spot = Spotlight { position, target, radiant_intensity: 100.0, sharpness: 10.0 };
    scene.add_emitter("spot", spot)?;
    Ok(())
}

/// To find shape and light again, from the image that they make.
fn problem(ids: &[ParameterId], truth: Vec<(ParameterId, Vec<f64>)>) -> OptimizeSection {
    let tuned = |&id| TunedParameter::new(id);
    OptimizeSection {
        parameters: ids.iter().map(tuned).collect(),
        target: Some(Target::Values(truth)),
        schedule: Some(Schedule::Cosine(Cosine::default())),
        iterations: Some(400),
        ..OptimizeSection::default()
    }
}
