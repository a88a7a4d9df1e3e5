//! The derivative of every pixel by one number of a scene: by forward mode, and by differences.

use renderer::demo::demo_experiment;
use renderer::experiment::Target;
use renderer::{Edges, Error, Image, ParameterId, Scene, Settings, render, render_jvp};

/// The tree of the demo under its true light, in an image of `size` by `size` pixels.
pub fn scene(size: u32) -> Result<Scene, Error> {
    let experiment = demo_experiment()?;
    let mut scene = experiment.scene;
    (scene.width, scene.height) = (size, size);
    scene.camera.film_scale = 0.4;
    if let Some(Target::Values(truth)) = experiment.optimize.and_then(|optimize| optimize.target) {
        for (id, values) in truth {
            scene.set(id, &values)?;
        }
    }
    Ok(scene)
}

fn settings() -> Settings {
    Settings { edges: Edges::On, ..Settings::default() }.in_double_precision()
}

/// By central differences of two images in double precision. The images see edges move.
pub fn by_differences(scene: &Scene, id: ParameterId, element: usize) -> Result<Image, Error> {
    let step = 1e-3 * scene.natural_scale(id);
    let image = |offset: f64| {
        let mut moved = scene.clone();
        let mut numbers = scene.get(id).into_owned();
        numbers[element] += offset;
        moved.set(id, &numbers)?;
        render(&moved, &settings())
    };
    let (mut difference, below) = (image(step)?, image(-step)?);
    let pairs = difference.pixels.as_flattened_mut().iter_mut().zip(below.pixels.as_flattened());
    for (above, below) in pairs {
        *above = (f64::from(*above - below) / (2.0 * step)) as f32;
    }
    Ok(difference)
}

/// By forward mode, with edges.
pub fn by_forward_mode(scene: &Scene, id: ParameterId, element: usize) -> Result<Image, Error> {
    let unit = |index: usize| f64::from(u8::from(index == element));
    let direction = (id, (0..scene.get(id).len()).map(unit).collect());
    Ok(render_jvp(scene, &settings(), &[direction])?.1)
}

/// The largest derivative of a channel, without its sign; no number if one is none.
pub fn largest(derivatives: &Image) -> f32 {
    let sizes = derivatives.pixels.as_flattened().iter().map(|d| d.abs());
    sizes.max_by(f32::total_cmp).unwrap_or(0.0)
}

/// The part of the pixels at which two images of derivatives differ by more than `tolerance` times
/// the largest derivative of the first.
pub fn different(derivatives: &Image, others: &Image, tolerance: f32) -> f64 {
    let limit = tolerance * largest(derivatives);
    let pairs = derivatives.pixels.iter().zip(&others.pixels);
    let is_different =
        |(a, b): &(&[f32; 3], &[f32; 3])| a.iter().zip(*b).any(|(a, b)| (a - b).abs() > limit);
    pairs.filter(is_different).count() as f64 / derivatives.pixels.len() as f64
}
