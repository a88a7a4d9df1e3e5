//! Training by the loss of images alone: it never sees the lamps that images were rendered with.

use std::f64::consts::PI;

use candle_core::{Device, Result, Tensor};
use candle_nn::{AdamW, Optimizer, ParamsAdamW};

use crate::layer::RenderLayer;
use crate::network::Network;
use crate::random::Random;
use crate::scene::Lamp;

/// How training goes.
#[derive(Clone, Copy, Debug)]
pub struct Schedule {
    /// How many images a step takes.
    pub batch: usize,
    /// How many steps.
    pub steps: usize,
    /// The learning rate of Adam at first; it falls to zero along a cosine.
    pub learning_rate: f64,
}

/// Images, and the lamps that they were rendered with.
pub struct Views {
    /// The lamp of each image.
    pub lamps: Vec<Lamp>,
    /// `[count, height, width, 3]`
    pub images: Tensor,
}

impl Views {
    /// Images with random lamps.
    pub fn random(layer: &RenderLayer, count: usize, random: &mut Random) -> Result<Self> {
        let lamps: Vec<Lamp> = (0..count).map(|_| Lamp::random(random)).collect();
        let images = layer.images(&tensor(&lamps)?)?;
        Ok(Self { lamps, images })
    }
}

/// Lamps as the input of the layer that renders.
pub fn tensor(lamps: &[Lamp]) -> Result<Tensor> {
    let numbers = lamps.iter().flat_map(Lamp::numbers).collect();
    Tensor::from_vec(numbers, (lamps.len(), Lamp::NUMBERS), &Device::Cpu)
}

/// Trains with images chosen at random, and calls `after_step` with the count of steps so far and the
/// loss before the last one.
///
/// # Errors
///
/// If an answer of the network is not a number, or `after_step` fails.
pub fn train(
    network: &Network,
    layer: &RenderLayer,
    images: &Tensor,
    schedule: Schedule,
    random: &mut Random,
    mut after_step: impl FnMut(usize, f32) -> Result<()>,
) -> Result<()> {
    let Schedule { batch, steps, learning_rate } = schedule;
    let parameters = ParamsAdamW { weight_decay: 0.0, ..ParamsAdamW::default() };
    let mut optimizer = AdamW::new(network.variables(), parameters)?;
    let count = images.dim(0)?;
    for step in 0..steps {
        let angle = PI * step as f64 / steps as f64;
        optimizer.set_learning_rate(learning_rate * 0.5 * (1.0 + angle.cos()));
        let chosen = (0..batch).map(|_| random.between(0.0, count as f64) as u32).collect();
        let chosen = Tensor::from_vec(chosen, batch, &Device::Cpu)?;
        let targets = images.index_select(&chosen, 0)?;
        let rendered = layer.images(&network.lamps(&targets)?)?;
        let loss = errors(&rendered, &targets)?.mean_all()?;
        optimizer.backward_step(&loss)?;
        after_step(step + 1, loss.to_scalar()?)?;
    }
    Ok(())
}

/// The mean squared error of each image, relative to the mean square of what it should be: lights
/// that are weak or far count as much as others.
pub fn errors(images: &Tensor, targets: &Tensor) -> Result<Tensor> {
    let mean = |x: Tensor| x.sqr()?.flatten_from(1)?.mean(1);
    mean((images - targets)?)? / mean(targets.clone())?
}

/// How far the lamps that a network finds are from the true ones, on average over images.
#[derive(Clone, Copy, Debug)]
pub struct Accuracy {
    /// The root of the mean of [`errors`] of the images that they make.
    pub image: f64,
    /// How far they are from where the true ones are.
    pub distance: f64,
    /// The same as an angle, seen from the middle of the floor, in degrees.
    pub degrees: f64,
    /// The error of the intensity, relative to the true one.
    pub intensity: f64,
}

impl Accuracy {
    /// That of the lamps `found` in `views`.
    pub fn of(found: &[Lamp], layer: &RenderLayer, views: &Views) -> Result<Self> {
        let images = layer.images(&tensor(found)?)?;
        let image = errors(&images, &views.images)?.mean_all()?.to_scalar::<f32>()?;
        let mean = |error: fn(&Lamp, &Lamp) -> f64| {
            let pairs = found.iter().zip(&views.lamps);
            pairs.map(|(found, truth)| error(found, truth)).sum::<f64>() / found.len() as f64
        };
        Ok(Self {
            image: f64::from(image).sqrt(),
            distance: mean(|a, b| a.position.distance(b.position)),
            degrees: mean(|a, b| a.position.angle_between(b.position).to_degrees()),
            intensity: mean(|a, b| (a.intensity / b.intensity - 1.0).abs()),
        })
    }
}

/// The lamps that a network finds in images.
pub fn find(network: &Network, images: &Tensor) -> Result<Vec<Lamp>> {
    let numbers = network.lamps(images)?.flatten_all()?.to_vec1::<f32>()?;
    Ok(numbers.as_chunks().0.iter().map(|&numbers| Lamp::from_numbers(numbers)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::network::SIZE;
    use crate::scene::{PATHS, scene};

    #[test]
    fn the_light_of_images_not_trained_with_is_found() {
        let random = &mut Random(1);
        let layer = RenderLayer::new(scene(SIZE as u32).unwrap(), &PATHS).unwrap();
        let [views, held_back] =
            [300, 100].map(|count| Views::random(&layer, count, random).unwrap());
        let network = Network::new(random).unwrap();
        let accuracy = |network: &Network| {
            let found = find(network, &held_back.images).unwrap();
            Accuracy::of(&found, &layer, &held_back).unwrap()
        };
        let before = accuracy(&network);
        let schedule = Schedule { batch: 16, steps: 250, learning_rate: 3e-3 };
        train(&network, &layer, &views.images, schedule, random, |_, _| Ok(())).unwrap();
        let after = accuracy(&network);
        assert!(before.image > 0.6 && before.degrees > 15.0, "{before:?}");
        assert!(after.image < 0.25 && after.degrees < 5.0, "{after:?}");
        assert!(after.distance < 1.5 && after.intensity < 0.3, "{after:?}");
    }
}
