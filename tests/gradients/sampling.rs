//! Several rays per pixel.

use renderer::settings::GradientSamples;
use renderer::{
    Arithmetic, Image, ImageLoss, LossKind, Renderer, Samples, Sampling, Scene, Settings,
    loss_and_gradient, render,
};

use crate::image::{check_parameter_with, in_arithmetic, target};
use crate::paths::lit_box;
use crate::scenes::{mirror_scene, small_scene, textured_scene};

fn settings(arithmetic: Arithmetic, sampling: Sampling) -> Settings {
    Settings { sampling, ..in_arithmetic(arithmetic) }
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
        let (target, settings) = (target(&scene), settings(Arithmetic::F64, sampling));
        for id in scene.parameters() {
            check_parameter_with(&settings, &scene, &target, LossKind::MeanSquared, id);
        }
    }
}

#[test]
fn lanes_agree_with_single_numbers() {
    let scene = mirror_scene(21);
    let target = target(&scene);
    let target = ImageLoss::new(LossKind::MeanSquared, &target, false);
    let ids = scene.parameters();
    let [single, lanes] = [Arithmetic::F64, Arithmetic::F64x8].map(|arithmetic| {
        let settings = settings(arithmetic, Sampling::Stratified(samples(4, 2)));
        let renderer = Renderer::new(&scene, &settings).unwrap();
        let result = renderer.loss_and_gradient(&scene, &target, &ids);
        assert!((renderer.loss(&target) - result.loss).abs() <= 1e-12 * result.loss);
        result
    });
    assert!((single.loss - lanes.loss).abs() <= 1e-12 * single.loss);
    for id in ids {
        let (single, lanes) = (single.gradient.get(id), lanes.gradient.get(id));
        let size = single.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        for (a, b) in single.iter().zip(lanes) {
            assert!((a - b).abs() <= 1e-10 * size, "{}: {a} and {b}", scene.path(id));
        }
    }
}

fn image(scene: &Scene, sampling: Sampling) -> Image {
    render(scene, &settings(Arithmetic::F32x16, sampling)).unwrap()
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

/// With few samples, the mean over many seeds: of rays, of paths whose image has noise, and of an odd number of them.
#[test]
fn independent_samples_take_the_bias_out_of_gradients() {
    for (scene, path, counts, many) in [
        (small_scene(16), "material.ground.diffuse", &[2][..], 1024),
        (lit_box(8), "material.red.diffuse", &[4, 3], 1 << 13),
    ] {
        let id = scene.parameter(path).unwrap();
        let target = target(&scene);
        let target = ImageLoss::new(LossKind::MeanSquared, &target, false);
        let slope = |samples| {
            let settings = settings(Arithmetic::F32x16, Sampling::Stratified(samples));
            loss_and_gradient(&scene, &settings, &target, &[id]).unwrap().gradient.get(id)[0]
        };
        let reference = slope(samples(many, 99));
        let bias = |count, gradient| {
            let seeds = 0..200;
            let of_seed = |seed| slope(Samples { gradient, ..samples(count, seed) });
            let mean = seeds.clone().map(of_seed).sum::<f64>() / seeds.len() as f64;
            (mean - reference).abs() / reference.abs()
        };
        for &count in counts {
            let same = bias(count, GradientSamples::Same);
            let independent = bias(count, GradientSamples::Independent);
            assert!(independent < 0.2 * same, "{path}, {count} samples: {same} {independent}");
        }
    }
}

/// The image is the mean of both halves, and its loss the one that comes with the gradient.
#[test]
fn independent_samples_have_one_image() {
    let scene = lit_box(11);
    let loss = target(&scene);
    let loss = ImageLoss::new(LossKind::L1, &loss, false);
    let halves = Samples { gradient: GradientSamples::Independent, ..samples(5, 4) };
    let settings = settings(Arithmetic::F64x8, Sampling::Sobol(halves));
    let renderer = Renderer::new(&scene, &settings).unwrap();
    let result = renderer.loss_and_gradient(&scene, &loss, &scene.parameters());
    assert!((renderer.loss(&loss) - result.loss).abs() <= 1e-12 * result.loss);
    let first = Sampling::Sobol(samples(3, 4));
    let first = render(&scene, &Settings { sampling: first, ..settings }).unwrap();
    let pairs = renderer.render().pixels.into_iter().zip(first.pixels);
    // What the other half leaves is an image too, of two samples.
    let left = |([whole, ..], [first, ..]): ([f32; 3], [f32; 3])| 5.0 * whole - 3.0 * first;
    let left: Vec<f32> = pairs.map(left).collect();
    assert!(left.iter().all(|&value| value > -1e-4), "{left:?}");
    assert!(left.iter().any(|&value| value > 0.1), "{left:?}");
}
