//! Adds a shape and a light of one's own to a scene, and recovers them from an image.
//!
//! The paper's users add objects by `intersect` and `get_normal`; here the kernels are also
//! `#[differentiable]`, so that every gradient reaches their parameters.

mod kinds;

use std::path::Path;
use std::sync::Arc;

use kinds::{Ellipsoid, Spotlight};
use renderer::Error;
use renderer::arithmetic::Arithmetic;
use renderer::experiment::{Experiment, OptimizeSection, Target, TunedParameter};
use renderer::files::save_png;
use renderer::optimize::Quiet;
use renderer::optimize::schedule::{Cosine, Schedule};
use renderer::recovery::{Recovery, render_at};
use renderer::scene::{CustomLightObject, CustomShapeObject, ParameterId, Scene};

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

[material.paint]
diffuse = [0.2, 0.4, 0.7]
specular = [0.3, 0.3, 0.3]
exponent = 30.0
"#;

/// The true parameters: centre and radii; place, aim, intensity and sharpness.
const EGG: [f64; 6] = [0.3, 0.2, 0.0, 0.9, 0.6, 0.5];
const SPOT: [f64; 8] = [2.0, 4.0, 3.0, 0.2, 0.0, 0.2, 0.4, 2.0];

fn main() -> Result<(), Error> {
    let folder = Path::new("out/custom_shape");
    std::fs::create_dir_all(folder).map_err(|error| Error::new(folder.display(), error))?;
    let mut truth = Experiment::parse(SCENE, Path::new(""), "scene")?.scene;
    add_own_kinds(&mut truth);
    truth.validate("scene")?;
    let arithmetic = Arithmetic::default();
    save_png(&render_at(arithmetic, &truth), &folder.join("target.png"))?;

    let mut guess = truth.clone();
    guess.parameters.shapes[0] = vec![0.25, 0.15, 0.1, 0.85, 0.65, 0.55];
    guess.parameters.custom_lights[0] = vec![1.5, 4.2, 3.2, 0.0, 0.0, 0.0, 0.3, 1.5];
    let experiment = Experiment { scene: guess, optimize: Some(problem()) };
    let guess = &experiment.scene;
    save_png(&render_at(arithmetic, guess), &folder.join("initial.png"))?;

    let recovery = Recovery::new(&experiment, "custom shape", arithmetic)?;
    let outcome = recovery.run(&recovery.settings(), &mut Quiet)?;
    println!("loss {:.2e} -> {:.2e}", outcome.initial_loss(), outcome.best.loss);
    let recovered = recovery.scene_at(&outcome.best.x);
    save_png(&render_at(arithmetic, &recovered), &folder.join("final.png"))?;
    for (id, truth) in
        [(ParameterId::ShapeParameters(0), &EGG[..]), (ParameterId::LightParameters(0), &SPOT[..])]
    {
        println!("{}", recovered.path(id));
        println!("  guess     {:.3?}", guess.parameters.get(id));
        println!("  recovered {:.3?}", recovered.parameters.get(id));
        println!("  truth     {truth:.3?}");
    }
    println!("{}", folder.display());
    Ok(())
}

fn add_own_kinds(scene: &mut Scene) {
    let material = scene.materials.iter().position(|material| material.name == "paint");
    scene.shapes.push(CustomShapeObject {
        name: "egg".into(),
        material: material.unwrap_or(0) as u32,
        shape: Arc::new(Ellipsoid),
    });
    scene.parameters.shapes.push(EGG.to_vec());
    scene.custom_lights.push(CustomLightObject { name: "spot".into(), light: Arc::new(Spotlight) });
    scene.parameters.custom_lights.push(SPOT.to_vec());
}

/// To find shape and light again, from the image that they make.
fn problem() -> OptimizeSection {
    let truth =
        [(ParameterId::ShapeParameters(0), &EGG[..]), (ParameterId::LightParameters(0), &SPOT)];
    let tuned = |id| TunedParameter { id, learning_rate: None, min: None, max: None };
    OptimizeSection {
        parameters: truth.iter().map(|&(id, _)| tuned(id)).collect(),
        target: Some(Target::Values(truth.map(|(id, values)| (id, values.to_vec())).into())),
        schedule: Some(Schedule::Cosine(Cosine::default())),
        iterations: Some(400),
        ..OptimizeSection::default()
    }
}
