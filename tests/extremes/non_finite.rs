//! What is not finite is found, named, and left out only where that is allowed.

use ad::lanes::{f32x16, f64x8};
use glam::DVec3;
use renderer::arithmetic::Arithmetic;
use renderer::experiment::{Experiment, OptimizeSection, Target, TunedParameter};
use renderer::image::Image;
use renderer::integrator::{
    GradientSamples, Prepared, RenderSettings, Samples, Sampling, Wanted, find_non_finite,
    gradient_of_finite,
};
use renderer::kernels::material::Material;
use renderer::loss::{ImageLoss, LossKind};
use renderer::recovery::Recovery;
use renderer::scene::{MaterialObject, ParameterId, Scene};

use crate::scenes::small_scene;

/// The small scene with a sphere so bright under the light that single precision cannot hold it.
fn bright_scene() -> Scene {
    let mut scene = small_scene(48);
    scene.materials.push(MaterialObject::new("blinding"));
    let blinding = Material { diffuse: DVec3::splat(1e38), ..scene.parameters.materials[1] };
    scene.parameters.materials.push(blinding);
    scene.spheres[0].material = 2;
    scene.parameters.get_mut(ParameterId::LightIntensity(0))[0] *= 100.0;
    scene
}

fn experiment(scene: Scene, ids: &[ParameterId], target: &[ParameterId]) -> Experiment {
    let values = target
        .iter()
        .map(|&id| (id, scene.parameters.get(id).iter().map(|value| 0.9 * value).collect()));
    let tuned =
        |&id: &ParameterId| TunedParameter { id, learning_rate: None, min: None, max: None };
    let optimize = OptimizeSection {
        target: Some(Target::Values(values.collect())),
        parameters: ids.iter().map(tuned).collect(),
        ..OptimizeSection::default()
    };
    Experiment::new(scene, Some(optimize))
}

#[test]
fn a_radiance_that_overflows_is_named() {
    let ids = [ParameterId::LightPosition(0), ParameterId::Diffuse(0)];
    let experiment = experiment(bright_scene(), &ids, &[ParameterId::Diffuse(0)]);
    let recovery = Recovery::new(&experiment, "scene", Arithmetic::F32x16).unwrap();
    let error = recovery.evaluate().unwrap_err().to_string();
    assert!(error.contains("of 1296 pixels are not finite; at column"), "{error}");
    assert!(error.contains("the radiance is [inf, inf, inf], on sphere.ball"), "{error}");
}

/// Leaving pixels out is as if they were not there, and says so.
#[test]
fn pixels_are_left_out_where_that_is_allowed() {
    let ids = [ParameterId::LightPosition(0), ParameterId::Diffuse(0), ParameterId::LookFrom];
    let bright = experiment(bright_scene(), &ids, &[ParameterId::Diffuse(0)]);
    let recovery = Recovery::new(&bright, "scene", Arithmetic::F32x16).unwrap();
    let recovery = recovery.allowing_non_finite();
    let left_out = recovery.evaluate().unwrap();
    let warning = recovery.left_out().unwrap();
    assert!(warning.contains("pixels are not finite"), "{warning}");

    // A sphere without light on it has no gradient either.
    let mut dark = bright_scene();
    dark.parameters.materials[2] = Material { ambient: DVec3::ZERO, ..Material::zero() };
    let dark = experiment(dark, &ids, &[ParameterId::Diffuse(0)]);
    let recovery = Recovery::new(&dark, "scene", Arithmetic::F32x16).unwrap();
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
    let mut scene = small_scene(48);
    let floor = &mut scene.parameters.vertices[0];
    floor.iter_mut().for_each(|[_, y, _]| *y = 0.0);
    let position = ParameterId::LightPosition(0);
    scene.parameters.get_mut(position).copy_from_slice(&[0.5, 1e-3, 2.0]);
    scene.parameters.get_mut(ParameterId::LightIntensity(0))[0] = 1e37;
    scene
}

#[test]
fn a_derivative_that_overflows_is_named() {
    let position = ParameterId::LightPosition(0);
    let experiment = experiment(glaring_scene(), &[position], &[ParameterId::LightIntensity(0)]);
    let recovery = Recovery::new(&experiment, "scene", Arithmetic::F32x16).unwrap();
    let error = recovery.evaluate().unwrap_err().to_string();
    assert!(error.contains("the derivative by light.key.position is"), "{error}");
    assert!(error.ends_with("on mesh.floor"), "{error}");
    let double = Recovery::new(&experiment, "scene", Arithmetic::F64x8).unwrap();
    assert!(double.evaluate().unwrap().is_finite());
}

/// Where losses are extreme, cotangents alone would overflow at every bright pixel; those are brought
/// into range, and only the pixels are named whose derivative overflows in spite of that.
#[test]
fn no_more_pixels_are_named_than_overflow() {
    let scene = glaring_scene();
    let target = Image::black(scene.width, scene.height);
    let loss = ImageLoss::new(LossKind::SumSquared, &target, false);
    let position = ParameterId::LightPosition(0);
    let single = Prepared::<f32x16>::new(&scene);
    let found = find_non_finite(&single, &loss, &[position]).unwrap();
    assert!((1..=10).contains(&found.count), "{found}");

    // The same without these pixels, in double precision.
    let double = Prepared::<f64x8>::new(&scene);
    let ids = [position];
    let wanted = Wanted::by(&ids);
    let of_single = gradient_of_finite(&single, &loss, wanted, &found);
    let of_double = gradient_of_finite(&double, &loss, wanted, &found);
    let pairs = of_single.gradient.get(position).iter().zip(of_double.gradient.get(position));
    for (single, double) in pairs {
        assert!((single - double).abs() <= 1e-3 * double.abs(), "{single:e} {double:e}");
    }
}

/// A ray through another part of the pixel than its first ray may be the one that overflows.
#[test]
fn what_any_ray_of_a_pixel_meets_is_named() {
    let ids = [ParameterId::Diffuse(0)];
    let experiment = experiment(bright_scene(), &ids, &ids);
    for seed in 0..8 {
        let samples = Samples { count: 4, seed, gradient: GradientSamples::Same };
        let sampling = Sampling::Sobol(samples);
        let settings = RenderSettings { sampling, ..RenderSettings::default() };
        let recovery =
            Recovery::with_settings(&experiment, "scene", Arithmetic::F32x16, settings).unwrap();
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
        scene.parameters.get_mut(ParameterId::LightIntensity(0))[0] = intensity;
        scene.parameters.get_mut(ParameterId::LightIntensity(1))[0] = 0.0;
        scene.parameters.materials.iter_mut().for_each(|m| m.ambient = DVec3::ZERO);
        let ids = [
            ParameterId::LightPosition(0),
            ParameterId::LightIntensity(0),
            ParameterId::Diffuse(0),
            ParameterId::Vfov,
        ];
        let experiment = experiment(scene, &ids, &[ParameterId::LightIntensity(0)]);
        let evaluate = |arithmetic: Arithmetic| {
            let recovery = Recovery::new(&experiment, "scene", arithmetic).unwrap();
            recovery.evaluate().unwrap()
        };
        let (single, double) = (evaluate(Arithmetic::F32x16), evaluate(Arithmetic::F64x8));
        assert!((single.loss / double.loss - 1.0).abs() <= 1e-4, "{single:?} {double:?}");
        let mut worst = 0.0_f64;
        for (single, double) in single.gradient.iter().zip(&double.gradient) {
            assert!(*double != 0.0);
            worst = worst.max((single / double - 1.0).abs());
        }
        println!("| light of intensity {intensity:e}: gradient of an image | {worst:.1e} |");
        assert!(worst <= 1e-3, "{single:?} instead of {double:?}");
    }
}
