//! The gradient of a loss by one parameter, and central differences beside it.

use renderer::{PixelLoss, Renderer, Scene, Settings};

pub fn gradient(scene: &Scene, settings: &Settings, loss: &dyn PixelLoss, path: &str) -> Vec<f64> {
    let id = scene.parameter(path).unwrap();
    let renderer = Renderer::new(scene, settings).unwrap();
    renderer.loss_and_gradient(scene, loss, &[id]).gradient.concat()
}

/// Central differences of a loss.
pub fn differences(
    scene: &Scene,
    settings: &Settings,
    loss: &dyn PixelLoss,
    path: &str,
    step: f64,
) -> Vec<f64> {
    let id = scene.parameter(path).unwrap();
    let values = scene.get(id).into_owned();
    let loss = |index: usize, by: f64| {
        let (mut moved, mut values) = (scene.clone(), values.clone());
        values[index] += by;
        moved.set(id, &values).unwrap();
        Renderer::new(&moved, settings).unwrap().loss(loss)
    };
    let count = values.len();
    (0..count).map(|index| (loss(index, step) - loss(index, -step)) / (2.0 * step)).collect()
}

/// The norm of the error over the norm.
pub fn relative_error(found: &[f64], expected: &[f64]) -> f64 {
    let norm = |numbers: &mut dyn Iterator<Item = f64>| numbers.map(|x| x * x).sum::<f64>().sqrt();
    let mut off = found.iter().zip(expected).map(|(found, expected)| found - expected);
    norm(&mut off) / norm(&mut expected.iter().copied())
}
