//! Images and gradients of whole scenes.

use glam::DVec3;
use renderer::arithmetic::Arithmetic;
use renderer::experiment::{Experiment, OptimizeSection, Target, TunedParameter};
use renderer::image::Image;
use renderer::optimize::Evaluation;
use renderer::recovery::{Recovery, render_at};
use renderer::scene::{Differentiability, Light, ParameterId, Scene};

pub const ARITHMETICS: [Arithmetic; 4] =
    [Arithmetic::F32, Arithmetic::F32x16, Arithmetic::F64, Arithmetic::F64x8];

/// The scene `scale` times as large, then moved. The light that arrives stays the same.
pub fn placed(scene: &Scene, scale: f64, offset: DVec3) -> Scene {
    let mut scene = scene.clone();
    let place = |v: &mut DVec3| *v = *v * scale + offset;
    let parameters = &mut scene.parameters;
    place(&mut parameters.camera.look_from);
    place(&mut parameters.camera.look_at);
    for light in &mut parameters.lights {
        if let Light::Point(light) = light {
            place(&mut light.position);
            light.intensity *= scale * scale;
        }
    }
    for sphere in &mut parameters.spheres {
        place(&mut sphere.center);
        sphere.radius *= scale;
    }
    for vertex in parameters.vertices.iter_mut().flatten() {
        let mut moved = DVec3::from(*vertex);
        place(&mut moved);
        *vertex = moved.into();
    }
    scene
}

/// The scene has to be valid.
#[track_caller]
pub fn render(scene: &Scene, arithmetic: Arithmetic) -> Image {
    scene.validate("scene").unwrap();
    let image = render_at(arithmetic, scene);
    assert!(image.pixels.as_flattened().iter().all(|x| x.is_finite()), "not finite");
    image
}

/// The mean squared difference to an image with other light, and its gradient by every parameter.
#[track_caller]
pub fn evaluate(scene: &Scene, arithmetic: Arithmetic) -> (f64, Vec<(ParameterId, Vec<f64>)>) {
    let ids = scene.parameter_ids();
    let dimmed = ids.iter().filter(|id| matches!(id, ParameterId::LightIntensity(_)));
    let values = dimmed.map(|&id| (id, vec![0.7 * scene.parameters.get(id)[0]])).collect();
    let tuned =
        |&id: &ParameterId| TunedParameter { id, learning_rate: None, min: None, max: None };
    let optimize = OptimizeSection {
        target: Some(Target::Values(values)),
        parameters: ids.iter().map(tuned).collect(),
        ..OptimizeSection::default()
    };
    let experiment = Experiment::new(scene.clone(), Some(optimize));
    let recovery = Recovery::new(&experiment, "scene", arithmetic).unwrap();
    let Evaluation { loss, gradient } = recovery.evaluate().unwrap();
    let mut rest = &gradient[..];
    let blocks = ids.into_iter().map(|id| {
        let (block, others) = rest.split_at(scene.parameters.get(id).len());
        rest = others;
        (id, block.to_vec())
    });
    let blocks = blocks.collect();
    (loss, blocks)
}

/// Checks that a scene shows the same in every arithmetic, and that the loss and its gradient by lights
/// and materials, which move no edge, agree too: each within `bound`, relative to the largest element of
/// its parameter. Every other derivative has to be finite.
#[track_caller]
pub fn check_agreement(name: &str, scene: &Scene, bound: f64) {
    let exact = Arithmetic::F64x8;
    let (image, (loss, gradient)) = (render(scene, exact), evaluate(scene, exact));
    for arithmetic in ARITHMETICS {
        let off_by = difference(&image, &render(scene, arithmetic));
        let (other_loss, other_gradient) = evaluate(scene, arithmetic);
        let mut worst = if other_loss == loss { 0.0 } else { (other_loss / loss - 1.0).abs() };
        for ((id, block), (_, other)) in gradient.iter().zip(&other_gradient) {
            let path = scene.path(*id);
            assert!(
                block.iter().chain(other).all(|x| x.is_finite()),
                "{name}, {arithmetic:?}: {path}"
            );
            let largest = block.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
            if id.differentiability() == Differentiability::Smooth && largest > 0.0 {
                let errors = block.iter().zip(other).map(|(a, b)| (a - b).abs() / largest);
                let error = errors.fold(0.0, f64::max);
                assert!(
                    error <= bound,
                    "{name}, {arithmetic:?}: gradients by {path} differ by {error:e}: {block:?}, {other:?}"
                );
                worst = worst.max(error);
            }
        }
        println!("| {name} | {arithmetic:?} | {off_by:.1e} | {worst:.1e} |");
        assert!(off_by <= bound, "{name}, {arithmetic:?}: images differ by {off_by:e}");
        assert!(worst <= bound, "{name}, {arithmetic:?}: losses differ by {worst:e}");
    }
}

/// The largest difference of a channel, relative to the brightest one of both images.
pub fn difference(a: &Image, b: &Image) -> f64 {
    let channels = |image: &Image| image.pixels.as_flattened().to_vec();
    let brightest = channels(a).into_iter().chain(channels(b)).fold(0.0_f32, f32::max);
    let differences = channels(a).into_iter().zip(channels(b)).map(|(a, b)| (a - b).abs());
    let largest = differences.fold(0.0, f32::max);
    if largest == 0.0 { 0.0 } else { f64::from(largest / brightest) }
}
