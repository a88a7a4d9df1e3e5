//! Several rays per pixel.

use renderer::image::Image;
use renderer::integrator::{
    GradientSamples, Prepared, RenderSettings, Samples, Sampling, Wanted, gradient, loss, render,
};
use renderer::loss::{ImageLoss, LossKind};
use renderer::scene::{ParameterId, Scene};
use wide::{f32x16, f64x8};

use crate::image::{check_parameter_with, target};
use crate::scenes::{mirror_scene, small_scene, textured_scene};

fn settings(sampling: Sampling) -> RenderSettings {
    RenderSettings { sampling, ..RenderSettings::default() }
}

pub fn samples(count: u32, seed: u32) -> Samples {
    Samples { count, seed, gradient: GradientSamples::Same }
}

#[test]
fn gradients_agree_with_finite_differences() {
    let samples = samples(3, 7);
    for (scene, sampling) in [
        (small_scene(16), Sampling::Sobol(samples)),
        (mirror_scene(12), Sampling::Stratified(samples)),
        (textured_scene(12), Sampling::Sobol(samples)),
    ] {
        let target = target(&scene);
        for id in scene.parameter_ids() {
            check_parameter_with(settings(sampling), &scene, &target, LossKind::MeanSquared, id);
        }
    }
}

#[test]
fn lanes_agree_with_single_numbers() {
    let scene = mirror_scene(21);
    let target = target(&scene);
    let target = ImageLoss::new(LossKind::MeanSquared, &target, false);
    let settings = settings(Sampling::Stratified(samples(4, 2)));
    let ids = scene.parameter_ids();
    let wanted = Wanted::by(&ids);
    let single = gradient(&Prepared::<f64>::with_settings(&scene, settings), &target, wanted);
    let prepared = Prepared::<f64x8>::with_settings(&scene, settings);
    let lanes = gradient(&prepared, &target, wanted);
    assert!((single.loss - lanes.loss).abs() <= 1e-12 * single.loss);
    assert!((loss(&prepared, &target) - lanes.loss).abs() <= 1e-12 * single.loss);
    for id in scene.parameter_ids() {
        let (single, lanes) = (single.gradient.get(id), lanes.gradient.get(id));
        let size = single.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        for (a, b) in single.iter().zip(lanes) {
            assert!((a - b).abs() <= 1e-10 * size, "{}: {a} and {b}", scene.path(id));
        }
    }
}

fn image(scene: &Scene, sampling: Sampling) -> Image {
    render(&Prepared::<f32x16>::with_settings(scene, settings(sampling)))
}

fn error(image: &Image, reference: &Image) -> f64 {
    let pairs = image.pixels.as_flattened().iter().zip(reference.pixels.as_flattened());
    let squares: f64 = pairs.map(|(a, b)| f64::from(a - b).powi(2)).sum();
    (squares / (3 * image.pixels.len()) as f64).sqrt()
}

#[test]
fn images_converge_and_even_samples_do_so_faster() {
    let scene = small_scene(48);
    let reference = image(&scene, Sampling::Stratified(samples(4096, 11)));
    let center = error(&image(&scene, Sampling::Center), &reference);
    let errors = [4, 64].map(|count| {
        [Sampling::Stratified(samples(count, 5)), Sampling::Sobol(samples(count, 5))]
            .map(|sampling| error(&image(&scene, sampling), &reference))
    });
    let [[stratified_4, sobol_4], [stratified_64, sobol_64]] = errors;
    assert!(sobol_4 < center && stratified_4 < center, "{errors:?} {center}");
    // Random points would gain a factor of 4; across an edge even ones gain 8.
    assert!(sobol_64 * 6.0 < sobol_4, "{errors:?}");
    assert!(stratified_64 * 6.0 < stratified_4, "{errors:?}");
    assert!(sobol_64 < stratified_64 * 1.2, "{errors:?}");
}

/// With few samples, the mean over many seeds.
#[test]
fn samples_of_their_own_take_the_bias_out_of_gradients() {
    let scene = small_scene(24);
    let id = ParameterId::Diffuse(0);
    let target = target(&scene);
    let target = ImageLoss::new(LossKind::MeanSquared, &target, false);
    let slopes = |samples| {
        let settings = settings(Sampling::Stratified(samples));
        let prepared = Prepared::<f32x16>::with_settings(&scene, settings);
        gradient(&prepared, &target, Wanted::by(&[id])).gradient.get(id)[0]
    };
    let reference = slopes(samples(1024, 99));
    let bias = |gradient| {
        let seeds = 0..400;
        let count = f64::from(seeds.end);
        let mean = seeds.map(|seed| slopes(Samples { gradient, ..samples(1, seed) })).sum::<f64>();
        (mean / count - reference).abs() / reference.abs()
    };
    let (same, independent) = (bias(GradientSamples::Same), bias(GradientSamples::Independent));
    assert!(independent < 0.2 * same, "{same} {independent}");
}
