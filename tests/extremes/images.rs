//! Images and gradients of whole scenes.

use glam::DVec3;
use renderer::experiment::{Experiment, OptimizeSection, Target, TunedParameter};
use renderer::optimize::Evaluation;
use renderer::recovery::Recovery;
use renderer::scene::Object;
use renderer::{Arithmetic, Image, ParameterId, Scene, Settings};

pub const ARITHMETICS: [Arithmetic; 4] =
    [Arithmetic::F32, Arithmetic::F32x16, Arithmetic::F64, Arithmetic::F64x8];

pub fn settings(arithmetic: Arithmetic) -> Settings {
    Settings { arithmetic, ..crate::without_edges() }
}

/// The scene `scale` times as large, then moved. The light that arrives stays the same.
pub fn placed(scene: &Scene, scale: f64, offset: DVec3) -> Scene {
    let mut scene = scene.clone();
    let place = |v: DVec3| v * scale + offset;
    for id in scene.parameters() {
        let numbers = scene.get(id);
        let moved: Vec<f64> = match id.field {
            "position" | "center" | "vertices" => {
                let points = numbers.as_chunks().0.iter();
                points.flat_map(|&point| place(point.into()).to_array()).collect()
            }
            "radius" => vec![numbers[0] * scale],
            "radiant_intensity" => vec![numbers[0] * scale * scale],
            _ => continue,
        };
        scene.set(id, &moved).unwrap();
    }
    scene.camera.look_from = place(scene.camera.look_from);
    scene.camera.look_at = place(scene.camera.look_at);
    scene
}

/// [`placed`] by the transforms of meshes: their vertices stay what they are.
pub fn placed_by_transforms(scene: &Scene, scale: f64, offset: DVec3) -> Scene {
    let mut moved = placed(scene, scale, offset);
    for id in scene.parameters() {
        match (id.object, id.field) {
            (Object::Mesh(_), "vertices") => moved.set(id, &scene.get(id)).unwrap(),
            (Object::Mesh(_), "translation") => moved.set(id, &offset.to_array()).unwrap(),
            (Object::Mesh(_), "scale") => moved.set(id, &[scale; 3]).unwrap(),
            _ => {}
        }
    }
    moved
}

/// The scene has to be valid.
#[track_caller]
pub fn render(scene: &Scene, arithmetic: Arithmetic) -> Image {
    let image = renderer::render(scene, &settings(arithmetic)).unwrap();
    assert!(image.is_finite(), "not finite");
    image
}

/// The mean squared difference to an image with other light, and its gradient by every parameter.
#[track_caller]
pub fn evaluate(scene: &Scene, arithmetic: Arithmetic) -> (f64, Vec<(ParameterId, Vec<f64>)>) {
    evaluate_with(scene, &settings(arithmetic))
}

/// [`evaluate`] with these settings.
#[track_caller]
pub fn evaluate_with(scene: &Scene, settings: &Settings) -> (f64, Vec<(ParameterId, Vec<f64>)>) {
    let ids = scene.parameters();
    let is_power = |id: &&ParameterId| ["radiant_intensity", "irradiance"].contains(&id.field);
    let values = ids.iter().filter(is_power).map(|&id| (id, vec![0.7 * scene.get(id)[0]]));
    let tuned = |&id: &ParameterId| TunedParameter::new(id);
    let optimize = OptimizeSection {
        target: Some(Target::Values(values.collect())),
        parameters: ids.iter().map(tuned).collect(),
        ..OptimizeSection::default()
    };
    let experiment = Experiment::new(scene.clone(), Some(optimize));
    let recovery = Recovery::new(&experiment, "scene", settings).unwrap();
    let Evaluation { loss, gradient } = recovery.evaluate().unwrap();
    let mut rest = &gradient[..];
    let blocks = ids.into_iter().map(|id| {
        let (block, others) = rest.split_at(scene.get(id).len());
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
            if !scene.moves_edges(*id) && largest > 0.0 {
                let errors = block.iter().zip(other).map(|(a, b)| (a - b).abs() / largest);
                let error = errors.fold(0.0, crate::larger);
                assert!(
                    error <= bound,
                    "{name}, {arithmetic:?}: gradients by {path} differ by {error:e}: {block:?}, {other:?}"
                );
                worst = crate::larger(worst, error);
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
    let largest = differences.max_by(f32::total_cmp).unwrap_or(f32::NAN);
    if largest == 0.0 { 0.0 } else { f64::from(largest / brightest) }
}
