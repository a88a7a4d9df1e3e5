//! The gradient of an image loss by every kind of parameter.

use ad::check;
use glam::DVec3;
use renderer::{
    Arithmetic, Image, ImageLoss, LossKind, ParameterId, Pass, PixelLoss, PrimaryVisibility,
    Renderer, Scene, Settings, loss_and_gradient, render,
};

use crate::away_from_edges::AwayFromEdges;
use crate::scenes::{mirror_scene, set, small_scene, textured_scene};

pub fn in_arithmetic(arithmetic: Arithmetic) -> Settings {
    Settings { arithmetic, ..crate::without_edges() }
}

/// The scene with another number; nothing if it may not have that.
fn with_number(scene: &Scene, id: ParameterId, element: usize, value: f64) -> Option<Scene> {
    let mut numbers = scene.get(id).into_owned();
    numbers[element] = value;
    let mut moved = scene.clone();
    moved.set(id, &numbers).ok()?;
    Some(moved)
}

/// Where a number may move by up to `step` both ways: 0 if it stands there; 1 if it stands at the lower
/// end of its range, -1 at the upper.
fn free_side(scene: &Scene, id: ParameterId, element: usize, step: f64) -> f64 {
    let value = scene.get(id)[element];
    let is_free = |to: f64| with_number(scene, id, element, value + to).is_some();
    match (is_free(-step), is_free(step)) {
        (false, true) => 1.0,
        (true, false) => -1.0,
        _ => 0.0,
    }
}

/// The pixels whose neighbourhood is smooth: small moves of the parameter change them by little.
fn smooth_pixels(
    settings: &Settings,
    scene: &Scene,
    id: ParameterId,
    element: usize,
    step: f64,
    jump: f64,
) -> Vec<bool> {
    let middle = scene.get(id)[element] + step * free_side(scene, id, element, step);
    let images = [-step, -step / 2.0, 0.0, step / 2.0, step].map(|offset| {
        render(&with_number(scene, id, element, middle + offset).unwrap(), settings).unwrap()
    });
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

/// The derivative of a loss by one number, from its values alone.
fn difference(
    settings: &Settings,
    scene: &Scene,
    loss: &dyn PixelLoss,
    id: ParameterId,
    element: usize,
    step: f64,
) -> f64 {
    let value_at = |x: f64| {
        let moved = with_number(scene, id, element, x).unwrap();
        Renderer::new(&moved, settings).unwrap().loss(loss)
    };
    let value = scene.get(id)[element];
    match free_side(scene, id, element, step) {
        0.0 => check::derivative(value_at, value, step).value,
        side => {
            // The parabola through the derivatives at three places within the range.
            let slope =
                |steps: f64| check::derivative(value_at, value + side * steps * step, step).value;
            3.0 * slope(1.0) - 3.0 * slope(2.0) + slope(3.0)
        }
    }
}

pub fn target(scene: &Scene) -> Image {
    target_of(scene, &in_arithmetic(Arithmetic::F64))
}

pub fn target_of(scene: &Scene, settings: &Settings) -> Image {
    let mut image = render(scene, settings).unwrap();
    for (i, pixel) in image.pixels.iter_mut().enumerate() {
        for (channel, value) in pixel.iter_mut().enumerate() {
            *value = *value * 0.7 + 0.05 * ((i * 7 + channel * 3) % 5) as f32;
        }
    }
    image
}

fn check_parameter(scene: &Scene, target: &Image, kind: LossKind, id: ParameterId) {
    check_parameter_with(&in_arithmetic(Arithmetic::F64), scene, target, kind, id);
}

pub fn agrees_with_finite_differences(scene: &Scene, id: ParameterId) {
    check_parameter(scene, &target(scene), LossKind::MeanSquared, id);
}

pub fn check_parameter_with(
    settings: &Settings,
    scene: &Scene,
    target: &Image,
    kind: LossKind,
    id: ParameterId,
) {
    let step = 1e-3;
    // A texture bends from texel to texel: there is no derivative there, though no jump.
    let jump = if scene.textures().is_empty() { 2e-3 } else { 3e-5 };
    // Of one ray among several.
    let jump = jump / f64::from(settings.sampling.count());
    let count = scene.get(id).len();
    for element in 0..count {
        let keep = smooth_pixels(settings, scene, id, element, step, jump);
        let kept = keep.iter().filter(|keep| **keep).count();
        assert!(kept * 10 > keep.len() * 7, "{kept} of {} pixels are smooth", keep.len());
        let loss_of_smooth =
            AwayFromEdges { loss: ImageLoss::new(kind, target, false), keep, width: scene.width };
        let result = loss_and_gradient(scene, settings, &loss_of_smooth, &[id]).unwrap();
        let ours = result.gradient.get(id)[element];
        let expected = difference(settings, scene, &loss_of_smooth, id, element, step / 10.0);
        let scale = expected.abs().max(1e-6);
        let error = (ours - expected).abs() / scale;
        assert!(error <= 1e-5, "{}[{element}]: {ours} instead of {expected}", scene.path(id));

        let unit = (0..count).map(|index| f64::from(u8::from(index == element))).collect();
        let renderer = Renderer::new(scene, settings).unwrap();
        let (value, forwards) = renderer.loss_jvp(scene, &loss_of_smooth, &[(id, unit)]).unwrap();
        assert!((value - result.loss).abs() <= 1e-12 * value, "{value} and {}", result.loss);
        let error = (forwards - expected).abs() / scale;
        assert!(error <= 1e-5, "{}[{element}]: {forwards} instead of {expected}", scene.path(id));
    }
}

#[test]
fn every_parameter_agrees_with_finite_differences() {
    let scene = small_scene(24);
    let target = target(&scene);
    for id in scene.parameters() {
        check_parameter(&scene, &target, LossKind::MeanSquared, id);
    }
}

#[test]
fn every_parameter_agrees_with_finite_differences_in_mirrors() {
    let scene = mirror_scene(20);
    let target = target(&scene);
    for id in scene.parameters() {
        check_parameter(&scene, &target, LossKind::MeanSquared, id);
    }
}

#[test]
fn every_parameter_agrees_with_finite_differences_under_textures() {
    let scene = textured_scene(16);
    let target = target(&scene);
    for id in scene.parameters() {
        check_parameter(&scene, &target, LossKind::MeanSquared, id);
    }
}

#[test]
fn the_rasterized_albedo_agrees_with_finite_differences() {
    let scene = textured_scene(16);
    let target = target(&scene);
    let settings = Settings {
        visibility: PrimaryVisibility::Raster,
        pass: Pass::Albedo,
        ..in_arithmetic(Arithmetic::F64)
    };
    for id in scene.parameters() {
        check_parameter_with(&settings, &scene, &target, LossKind::MeanSquared, id);
    }
}

/// The derivative by what a mirror adds that is still dark.
#[test]
fn dark_mirrors_have_a_gradient() {
    let mut scene = mirror_scene(20);
    let paths = ["material.ground.mirror", "material.object.mirror"];
    paths.iter().for_each(|path| set(&mut scene, path, &[0.0; 3]));
    let target = target(&scene);
    for path in paths {
        let id = scene.parameter(path).unwrap();
        check_parameter(&scene, &target, LossKind::MeanSquared, id);
    }
}

#[test]
fn every_loss_agrees_with_finite_differences() {
    let scene = small_scene(16);
    let target = target(&scene);
    for kind in [LossKind::SumSquared, LossKind::L1] {
        for path in ["light.key.radiant_intensity", "material.object.diffuse"] {
            check_parameter(&scene, &target, kind, scene.parameter(path).unwrap());
        }
    }
}

/// Measured on this scene: 2e-6 at most, relative to the largest element of the parameter.
#[test]
fn single_precision_is_close_to_double() {
    let scene = small_scene(32);
    single_agrees_with_double(&scene, &target(&scene), [Arithmetic::F32, Arithmetic::F64]);
}

/// Gradients by all parameters in single and in double precision.
pub fn single_agrees_with_double(scene: &Scene, target: &Image, arithmetics: [Arithmetic; 2]) {
    let loss = ImageLoss::new(LossKind::MeanSquared, target, false);
    let ids = scene.parameters();
    let [single, double] = arithmetics.map(|arithmetic| {
        loss_and_gradient(scene, &in_arithmetic(arithmetic), &loss, &ids).unwrap()
    });
    for id in ids {
        let (single, double) = (single.gradient.get(id), double.gradient.get(id));
        let scale = double.iter().fold(0.0_f64, |scale, x| scale.max(x.abs()));
        for (s, d) in single.iter().zip(double) {
            let error = if s == d { 0.0 } else { (s - d).abs() / scale };
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
    let ids = scene.parameters();
    let evaluate =
        |arithmetic| loss_and_gradient(scene, &in_arithmetic(arithmetic), &loss, &ids).unwrap();
    let (single, double) = (evaluate(Arithmetic::F32), evaluate(Arithmetic::F64));
    for (lanes, single, tolerance) in
        [(Arithmetic::F32x16, &single, 1e-4), (Arithmetic::F64x8, &double, 1e-12)]
    {
        let lanes = evaluate(lanes);
        assert!((lanes.loss - single.loss).abs() <= 0.1 * tolerance * single.loss);
        for &id in &ids {
            let (lanes, single) = (lanes.gradient.get(id), single.gradient.get(id));
            let scale = single.iter().fold(0.0_f64, |scale, x| scale.max(x.abs()));
            for (l, s) in lanes.iter().zip(single) {
                let error = if l == s { 0.0 } else { (l - s).abs() / scale };
                assert!(error <= tolerance, "{}: {l} instead of {s}", scene.path(id));
            }
        }
    }
}
