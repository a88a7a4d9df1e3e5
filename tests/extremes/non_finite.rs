//! What is not finite is found, named, and left out only where that is allowed.

use glam::DVec3;
use renderer::experiment::{Experiment, OptimizeSection, Target, TunedParameter};
use renderer::recovery::Recovery;
use renderer::scene::MaterialObject;
use renderer::settings::GradientSamples;
use renderer::{
    Arithmetic, Image, ImageLoss, LossKind, Material, ParameterId, Renderer, Samples, Sampling,
    Scene, Settings,
};

use crate::images::settings;
use crate::scenes::{multiply, set, small_parts, small_scene};

/// The small scene under a strong light, with a sphere of another material.
fn scene_with_sphere(material: Material<f64>) -> Scene {
    let mut parts = small_parts(48);
    parts.materials.push(MaterialObject { name: "blinding".into(), ..material.into() });
    parts.spheres[0].material = 2;
    let mut scene = parts.scene();
    multiply(&mut scene, "light.key.radiant_intensity", 100.0);
    scene
}

/// A sphere so bright under the light that single precision cannot hold it.
fn bright_scene() -> Scene {
    let material = small_parts(48).materials[1].values;
    scene_with_sphere(Material { diffuse: DVec3::splat(1e38), ..material })
}

fn experiment(scene: Scene, paths: &[&str], target: &str) -> Experiment {
    let id = |path: &str| scene.parameter(path).unwrap();
    let values = scene.get(id(target)).iter().map(|value| 0.9 * value).collect();
    let tuned = |path: &&str| TunedParameter::new(id(path));
    let optimize = OptimizeSection {
        target: Some(Target::Values(vec![(id(target), values)])),
        parameters: paths.iter().map(tuned).collect(),
        ..OptimizeSection::default()
    };
    Experiment::new(scene, Some(optimize))
}

const POSITION: &str = "light.key.position";
const INTENSITY: &str = "light.key.radiant_intensity";
const DIFFUSE: &str = "material.ground.diffuse";

#[test]
fn a_radiance_that_overflows_is_named() {
    let experiment = experiment(bright_scene(), &[POSITION, DIFFUSE], DIFFUSE);
    let recovery = Recovery::new(&experiment, "scene", &crate::without_edges()).unwrap();
    let error = recovery.evaluate().unwrap_err().to_string();
    assert!(error.contains("of 1296 pixels are not finite; at column"), "{error}");
    assert!(error.contains("the radiance is [inf, inf, inf], on sphere.ball"), "{error}");
}

/// Leaving pixels out is as if they were not there, and says so.
#[test]
fn pixels_are_left_out_where_that_is_allowed() {
    let paths = [POSITION, DIFFUSE, "camera.look_from"];
    let bright = experiment(bright_scene(), &paths, DIFFUSE);
    let recovery = Recovery::new(&bright, "scene", &crate::without_edges()).unwrap();
    let recovery = recovery.allowing_non_finite();
    let left_out = recovery.evaluate().unwrap();
    let warning = recovery.left_out().unwrap();
    assert!(warning.contains("pixels are not finite"), "{warning}");

    // A sphere without light on it has no gradient either.
    let dark = scene_with_sphere(Material::lambertian(DVec3::ZERO));
    let dark = experiment(dark, &paths, DIFFUSE);
    let recovery = Recovery::new(&dark, "scene", &crate::without_edges()).unwrap();
    let expected = recovery.evaluate().unwrap();
    assert_eq!(recovery.left_out(), None);
    assert!((left_out.loss / expected.loss - 1.0).abs() <= 1e-6, "{left_out:?} {expected:?}");
    for (found, expected) in left_out.gradient.iter().zip(&expected.gradient) {
        assert!((found - expected).abs() <= 1e-5 * expected.abs(), "{found} {expected}");
    }
}

/// A light so close above the floor that single precision holds what the floor shows there, and not
/// the derivative of that by the position of the light: it has another length in its denominator.
fn glaring_scene() -> Scene {
    let mut parts = small_parts(48);
    parts.meshes[0].vertices.iter_mut().for_each(|[_, y, _]| *y = 0.0);
    let mut scene = parts.scene();
    set(&mut scene, POSITION, &[0.5, 1e-3, 2.0]);
    set(&mut scene, INTENSITY, &[2.5e36]);
    scene
}

#[test]
fn a_derivative_that_overflows_is_named() {
    let experiment = experiment(glaring_scene(), &[POSITION], INTENSITY);
    let recovery = Recovery::new(&experiment, "scene", &crate::without_edges()).unwrap();
    let error = recovery.evaluate().unwrap_err().to_string();
    assert!(error.contains("the derivative by light.key.position is"), "{error}");
    assert!(error.ends_with("on mesh.floor"), "{error}");
    let double = recovery.with_settings(&crate::without_edges().in_double_precision());
    assert!(double.evaluate().unwrap().is_finite());
}

/// Where losses are extreme, cotangents alone would overflow at every bright pixel; those are brought
/// into range, and only the pixels are named whose derivative overflows in spite of that.
#[test]
fn no_more_pixels_are_named_than_overflow() {
    let scene = glaring_scene();
    let target = Image::black(scene.width, scene.height);
    let loss = ImageLoss::new(LossKind::SumSquared, &target, false);
    let ids: [ParameterId; 1] = [scene.parameter(POSITION).unwrap()];
    let [single, double] = [Arithmetic::F32x16, Arithmetic::F64x8]
        .map(|arithmetic| Renderer::new(&scene, &settings(arithmetic)).unwrap());
    let found = single.find_non_finite_gradient(&scene, &loss, &ids).unwrap();
    assert!((1..=10).contains(&found.count), "{found}");

    // The same without these pixels, in double precision.
    let [single, double] = [single, double]
        .map(|renderer| renderer.gradient_of_finite(&scene, &loss, &ids, &found).gradient.concat());
    let pairs = single.iter().zip(&double);
    for (single, double) in pairs {
        assert!((single - double).abs() <= 1e-3 * double.abs(), "{single:e} {double:e}");
    }
}

/// A ray through another part of the pixel than its first ray may be the one that overflows.
#[test]
fn what_any_ray_of_a_pixel_meets_is_named() {
    let experiment = experiment(bright_scene(), &[DIFFUSE], DIFFUSE);
    for seed in 0..8 {
        let samples = Samples { count: 4, seed, gradient: GradientSamples::Same };
        let sampling = Sampling::Sobol(samples);
        let settings = Settings { sampling, ..crate::without_edges() };
        let recovery = Recovery::new(&experiment, "scene", &settings).unwrap();
        let error = recovery.evaluate().unwrap_err().to_string();
        assert!(error.contains("the radiance is ["), "{seed}: {error}");
        assert!(error.ends_with("on sphere.ball"), "{seed}: {error}");
    }
}

/// Lights of 1e-30 and 1e30 have gradients of 1e-60 and 1e60, beyond what single precision holds.
#[test]
fn gradients_have_the_range_of_double_precision() {
    for intensity in [1e-30, 1e-15, 1e15, 1e30] {
        let mut scene = small_scene(48);
        set(&mut scene, INTENSITY, &[0.25 * intensity]);
        set(&mut scene, "light.sky.irradiance", &[0.0]);
        for path in ["material.ground.emission", "material.object.emission"] {
            set(&mut scene, path, &[0.0; 3]);
        }
        let paths = [POSITION, INTENSITY, DIFFUSE, "camera.vfov"];
        let experiment = experiment(scene, &paths, INTENSITY);
        let evaluate = |arithmetic: Arithmetic| {
            let recovery = Recovery::new(&experiment, "scene", &settings(arithmetic)).unwrap();
            recovery.evaluate().unwrap()
        };
        let (single, double) = (evaluate(Arithmetic::F32x16), evaluate(Arithmetic::F64x8));
        assert!((single.loss / double.loss - 1.0).abs() <= 1e-4, "{single:?} {double:?}");
        let mut worst = 0.0_f64;
        for (single, double) in single.gradient.iter().zip(&double.gradient) {
            assert!(*double != 0.0);
            worst = crate::larger(worst, (single / double - 1.0).abs());
        }
        println!("| light of intensity {intensity:e}: gradient of an image | {worst:.1e} |");
        assert!(worst <= 1e-3, "{single:?} instead of {double:?}");
    }
}
