//! Adds a shape and a light of one's own to a scene, and recovers them from an image.
//!
//! The paper's users add objects by `intersect` and `get_normal`; here the kernels are also
//! `#[differentiable]`, so that every gradient reaches their parameters.

mod kinds;

use std::path::Path;
use std::sync::Arc;

use kinds::{Ellipsoid, Spotlight};
use renderer::Error;
use renderer::experiment::Experiment;
use renderer::files::save_png;
use renderer::integrator::{Prepared, Wanted, gradient, render};
use renderer::loss::{ImageLoss, LossKind};
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
const SPOT: [f64; 8] = [2.0, 4.0, 3.0, 0.2, 0.0, 0.2, 40.0, 20.0];

fn main() -> Result<(), Error> {
    let folder = Path::new("out/custom_shape");
    std::fs::create_dir_all(folder).map_err(|error| Error::new(folder.display(), error))?;
    let mut truth = Experiment::parse(SCENE, Path::new(""), "scene")?.scene;
    add_own_kinds(&mut truth);
    truth.validate("scene")?;
    let target = render(&Prepared::<wide::f32x16>::new(&truth));
    save_png(&target, &folder.join("target.png"))?;

    let mut guess = truth.clone();
    guess.parameters.shapes[0] = vec![0.25, 0.15, 0.1, 0.85, 0.65, 0.55];
    guess.parameters.custom_lights[0] = vec![1.5, 4.2, 3.2, 0.0, 0.0, 0.0, 30.0, 15.0];
    save_png(&render(&Prepared::<wide::f32x16>::new(&guess)), &folder.join("initial.png"))?;

    let recovered = recover(&guess, &ImageLoss::new(LossKind::MeanSquared, &target, false), 400);
    save_png(&render(&Prepared::<wide::f32x16>::new(&recovered)), &folder.join("final.png"))?;
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

/// Descends by Adam (Kingma & Ba 2015), with steps relative to the size of each number.
fn recover(guess: &Scene, loss: &ImageLoss<'_>, iterations: i32) -> Scene {
    let ids = [ParameterId::ShapeParameters(0), ParameterId::LightParameters(0)];
    let mut scene = guess.clone();
    let mut prepared = Prepared::<wide::f32x16>::new(guess);
    let mut moments = ids.map(|id| vec![(0.0, 0.0); guess.parameters.get(id).len()]);
    for iteration in 1..=iterations {
        prepared.set_parameters(&scene.parameters);
        let result = gradient(&prepared, loss, Wanted::by(&ids));
        if iteration == 1 || iteration == iterations {
            println!("iteration {iteration}: loss {:.2e}", result.loss);
        }
        let rate = 0.01 * (1.0 - f64::from(iteration) / f64::from(iterations + 1));
        for (&id, moments) in ids.iter().zip(&mut moments) {
            let slopes = result.gradient.get(id);
            let values = scene.parameters.get_mut(id).iter_mut();
            for ((value, slope), (mean, square)) in values.zip(slopes).zip(moments) {
                *mean = 0.9 * *mean + 0.1 * slope;
                *square = 0.999 * *square + 0.001 * slope * slope;
                let mean = *mean / (1.0 - 0.9_f64.powi(iteration));
                let square: f64 = *square / (1.0 - 0.999_f64.powi(iteration));
                *value -= rate * value.abs().max(0.2) * mean / (square.sqrt() + 1e-12);
            }
        }
    }
    scene
}
