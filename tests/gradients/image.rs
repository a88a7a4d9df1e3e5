//! The gradient of an image loss by every kind of parameter.

use ad::check;
use glam::DVec3;
use renderer::image::Image;
use renderer::integrator::{
    Pass, Prepared, RenderSettings, Visibility, Wanted, gradient, loss, render,
};
use renderer::loss::{ImageLoss, LossKind};
use renderer::scene::{ParameterId, Scene};
use wide::{f32x8, f32x16, f64x8};

use crate::away_from_edges::AwayFromEdges;
use crate::scenes::{mirror_scene, small_scene, textured_scene};

/// The pixels whose neighbourhood is smooth: small moves of the parameter change them by little.
fn smooth_pixels(
    settings: RenderSettings,
    scene: &Scene,
    id: ParameterId,
    element: usize,
    step: f64,
    jump: f64,
) -> Vec<bool> {
    let mut images = Vec::new();
    for offset in [-step, -step / 2.0, 0.0, step / 2.0, step] {
        let mut moved = scene.clone();
        moved.parameters.get_mut(id)[element] += offset;
        images.push(render(&Prepared::<f64>::with_settings(&moved, settings)));
    }
    (0..images[0].pixels.len())
        .map(|pixel| {
            let values = |i: usize| DVec3::from(images[i].pixels[pixel].map(f64::from));
            // A jump shows as a second difference that does not shrink with the step.
            let coarse = (values(0) + values(4) - 2.0 * values(2)).abs().max_element();
            let fine = (values(1) + values(3) - 2.0 * values(2)).abs().max_element();
            coarse < jump && fine < jump / 2.0
        })
        .collect()
}

pub fn target(scene: &Scene) -> Image {
    let mut image = render(&Prepared::<f64>::new(scene));
    for (i, pixel) in image.pixels.iter_mut().enumerate() {
        for (channel, value) in pixel.iter_mut().enumerate() {
            *value = *value * 0.7 + 0.05 * ((i * 7 + channel * 3) % 5) as f32;
        }
    }
    image
}

fn check_parameter(scene: &Scene, target: &Image, kind: LossKind, id: ParameterId) {
    check_parameter_with(RenderSettings::default(), scene, target, kind, id);
}

pub fn agrees_with_finite_differences(scene: &Scene, id: ParameterId) {
    check_parameter(scene, &target(scene), LossKind::MeanSquared, id);
}

pub fn check_parameter_with(
    settings: RenderSettings,
    scene: &Scene,
    target: &Image,
    kind: LossKind,
    id: ParameterId,
) {
    let prepared = Prepared::<f64>::with_settings(scene, settings);
    let step = 1e-3;
    // A texture bends from texel to texel: there is no derivative there, though no jump.
    let jump = if scene.textures.is_empty() { 2e-3 } else { 3e-5 };
    // Of one ray among several.
    let jump = jump / f64::from(settings.sampling.count());
    for element in 0..scene.parameters.get(id).len() {
        let keep = smooth_pixels(settings, scene, id, element, step, jump);
        let kept = keep.iter().filter(|keep| **keep).count();
        assert!(kept * 10 > keep.len() * 7, "{kept} of {} pixels are smooth", keep.len());
        let loss_of_smooth =
            AwayFromEdges { loss: ImageLoss::new(kind, target, false), keep, width: scene.width };
        let result = gradient(&prepared, &loss_of_smooth, Wanted::by(&[id]));
        let ours = result.gradient.get(id)[element];

        let mut moved = scene.clone();
        let expected = check::derivative(
            |x| {
                moved.parameters.get_mut(id)[element] = x;
                loss(&Prepared::<f64>::with_settings(&moved, settings), &loss_of_smooth)
            },
            scene.parameters.get(id)[element],
            step / 10.0,
        );
        let scale = expected.value.abs().max(1e-6);
        let error = (ours - expected.value).abs() / scale;
        assert!(error <= 1e-5, "{}[{element}]: {ours} instead of {expected:?}", scene.path(id));
    }
}

#[test]
fn every_parameter_agrees_with_finite_differences() {
    let scene = small_scene(24);
    let target = target(&scene);
    for id in scene.parameter_ids() {
        check_parameter(&scene, &target, LossKind::MeanSquared, id);
    }
}

#[test]
fn every_parameter_agrees_with_finite_differences_in_mirrors() {
    let scene = mirror_scene(20);
    let target = target(&scene);
    for id in scene.parameter_ids() {
        check_parameter(&scene, &target, LossKind::MeanSquared, id);
    }
}

#[test]
fn every_parameter_agrees_with_finite_differences_under_textures() {
    let scene = textured_scene(16);
    let target = target(&scene);
    for id in scene.parameter_ids() {
        check_parameter(&scene, &target, LossKind::MeanSquared, id);
    }
}

#[test]
fn the_rasterized_albedo_agrees_with_finite_differences() {
    let scene = textured_scene(16);
    let target = target(&scene);
    let settings = RenderSettings {
        visibility: Visibility::Raster,
        pass: Pass::Albedo,
        ..RenderSettings::default()
    };
    for id in scene.parameter_ids() {
        check_parameter_with(settings, &scene, &target, LossKind::MeanSquared, id);
    }
}

/// The derivative by the reflection of a mirror that is still dark.
#[test]
fn dark_mirrors_have_a_gradient() {
    let mut scene = mirror_scene(20);
    for material in &mut scene.parameters.materials {
        material.reflection = DVec3::ZERO;
    }
    let target = target(&scene);
    check_parameter(&scene, &target, LossKind::MeanSquared, ParameterId::Reflection(0));
    check_parameter(&scene, &target, LossKind::MeanSquared, ParameterId::Reflection(1));
}

#[test]
fn every_loss_agrees_with_finite_differences() {
    let scene = small_scene(16);
    let target = target(&scene);
    for kind in [LossKind::SumSquared, LossKind::L1] {
        check_parameter(&scene, &target, kind, ParameterId::LightIntensity(0));
        check_parameter(&scene, &target, kind, ParameterId::Diffuse(1));
    }
}

/// Measured on this scene: 2e-6 at most, relative to the largest element of the parameter.
#[test]
fn single_precision_is_close_to_double() {
    let scene = small_scene(32);
    let target = target(&scene);
    let loss = ImageLoss::new(LossKind::MeanSquared, &target, false);
    let ids = scene.parameter_ids();
    let wanted = Wanted::by(&ids);
    let single = gradient(&Prepared::<f32>::new(&scene), &loss, wanted);
    let double = gradient(&Prepared::<f64>::new(&scene), &loss, wanted);
    for id in ids {
        let (single, double) = (single.gradient.get(id), double.gradient.get(id));
        let scale = double.iter().fold(0.0_f64, |scale, x| scale.max(x.abs()));
        for (s, d) in single.iter().zip(double) {
            let error = (s - d).abs() / scale;
            println!("{}: {error:.1e}", scene.path(id));
            assert!(error <= 1e-4, "{}: {s} instead of {d}", scene.path(id));
        }
    }
}

/// Lanes compute the same, but for the rounding of `powf`.
#[test]
fn lanes_agree_with_single_numbers() {
    lanes_agree_on(&small_scene(37));
    lanes_agree_on(&textured_scene(37));
}

pub fn lanes_agree_on(scene: &Scene) {
    let target = target(scene);
    let loss = ImageLoss::new(LossKind::MeanSquared, &target, false);
    let ids = scene.parameter_ids();
    let wanted = Wanted::by(&ids);
    let single = gradient(&Prepared::<f32>::new(scene), &loss, wanted);
    let double = gradient(&Prepared::<f64>::new(scene), &loss, wanted);
    for (lanes, single, tolerance) in [
        (gradient(&Prepared::<f32x8>::new(scene), &loss, wanted), &single, 1e-4),
        (gradient(&Prepared::<f32x16>::new(scene), &loss, wanted), &single, 1e-4),
        (gradient(&Prepared::<f64x8>::new(scene), &loss, wanted), &double, 1e-12),
    ] {
        assert!((lanes.loss - single.loss).abs() <= 0.1 * tolerance * single.loss);
        for &id in &ids {
            let (lanes, single) = (lanes.gradient.get(id), single.gradient.get(id));
            let scale = single.iter().fold(0.0_f64, |scale, x| scale.max(x.abs()));
            for (l, s) in lanes.iter().zip(single) {
                let error = (l - s).abs() / scale;
                assert!(error <= tolerance, "{}: {l} instead of {s}", scene.path(id));
            }
        }
    }
}
