//! Whether a gradient is right, beside differences that share nothing with it but the rays.
//!
//! Where a parameter moves no edges, the loss itself is smooth, and its differences are exact. Where it
//! does, the differences are of finely sampled images without edges, weighted with the cotangents of the
//! pixels: nothing of the search for edges is in them, and they are the derivative of the true image but
//! for the noise of samples that edges move across. The step is the one whose neighbours agree best, and
//! how much they disagree is the uncertainty.
//!
//! A parameter of a few numbers is compared number by number. One of many is compared along random
//! directions of signs: the mean square of the derivative of an error along such directions is the square
//! of its norm (Hutchinson, "A Stochastic Estimator of the Trace of the Influence Matrix", 1989), so
//! nothing hides in numbers that were left out.

use std::hash::{DefaultHasher, Hash, Hasher};

use ad::check;
use glam::DVec3;

use super::{Recovery, TargetImage};
use crate::loss::PixelLoss;
use crate::render::Renderer;
use crate::scene::ParameterId;
use crate::settings::{Edges, GradientSamples, Samples, Sampling, Settings};

/// The most numbers that are compared one by one.
const MOST_NUMBERS: usize = 4;

/// How many random directions stand for more.
const DIRECTIONS: usize = 4;

/// How many rays a finely sampled image has, and the bounds of that for each pixel.
const FINE_RAYS: u32 = 1 << 22;
const RAYS_OF_PIXEL: [u32; 2] = [16, 1024];

/// How many steps are tried, each twice as long as the one before.
const STEPS: usize = 6;

/// The gradient by a parameter beside differences.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// What was compared.
    pub compared: Vec<Compared>,
    /// The norm of the gradient less the differences over the larger of their norms: measured for a few
    /// numbers, estimated along random directions for more.
    pub error: f64,
    /// How exactly that is known.
    pub uncertainty: f64,
}

/// A derivative of the loss beside a difference.
#[derive(Clone, Copy, Debug)]
pub struct Compared {
    /// The number of the parameter; nothing if along a random direction.
    pub element: Option<usize>,
    /// The derivative along the direction, by the gradient.
    pub gradient: f64,
    /// The derivative along the direction, by finite differences.
    pub difference: f64,
    /// How exactly the difference is known.
    pub uncertainty: f64,
}

impl Verdict {
    /// Whether the gradient is off by no more than a tolerance, as far as the differences can tell.
    pub fn is_within(&self, tolerance: f64) -> bool {
        self.error <= tolerance + self.uncertainty
    }
}

impl Recovery<'_> {
    /// Compares the gradient by a parameter at the scene as it stands with differences. Seven pairs of images
    /// or fewer are rendered for each derivative that is compared.
    pub fn check(&self, id: ParameterId, gradient: &[f64]) -> Verdict {
        let one_by_one = gradient.len() <= MOST_NUMBERS;
        let count = if one_by_one { gradient.len() } else { DIRECTIONS };
        let compared: Vec<Compared> = (0..count)
            .map(|index| {
                let direction: Vec<f64> = match one_by_one {
                    true => (0..gradient.len()).map(|at| f64::from(at == index)).collect(),
                    false => (0..gradient.len()).map(|at| sign(index, at)).collect(),
                };
                let along = gradient.iter().zip(&direction).map(|(a, b)| a * b).sum();
                let of_images = self.difference_along(id, &direction);
                let of_terms = self.terms_along(id, &direction);
                let value = of_images.value + of_terms.value;
                let error = of_images.error + of_terms.error;
                Compared {
                    element: one_by_one.then_some(index),
                    gradient: along,
                    difference: value,
                    uncertainty: error,
                }
            })
            .collect();
        let norm = |of: &dyn Fn(&Compared) -> f64| {
            compared.iter().map(|compared| of(compared).powi(2)).sum::<f64>().sqrt()
        };
        // The norm of all numbers stands for that along as many directions.
        let whole = gradient.iter().map(|number| number * number).sum::<f64>().sqrt()
            * if one_by_one { 1.0 } else { (count as f64).sqrt() };
        let scale = norm(&|compared| compared.difference).max(whole).max(f64::MIN_POSITIVE);
        let error = norm(&|compared| compared.gradient - compared.difference) / scale;
        let uncertainty = norm(&|compared| compared.uncertainty) / scale;
        Verdict { compared, error, uncertainty }
    }

    /// The derivative of the terms of the loss that are not of images, likewise.
    fn terms_along(&self, id: ParameterId, direction: &[f64]) -> check::Estimate {
        if self.regularizers.is_empty() {
            return check::Estimate { value: 0.0, error: 0.0 };
        }
        let mut x = Vec::new();
        let mut start = 0;
        for &other in &self.ids {
            if other == id {
                start = x.len();
            }
            x.extend_from_slice(&self.scene.get(other));
        }
        let value = |by: f64| -> f64 {
            let mut x = x.clone();
            x[start..].iter_mut().zip(direction).for_each(|(x, along)| *x += by * along);
            self.regularizers.iter().map(|term| term.value(&x)).sum()
        };
        check::derivative(value, 0.0, 1e-4 * self.scene.natural_scale(id))
    }

    /// The derivative of the loss of images along a direction of a parameter, by differences.
    fn difference_along(&self, id: ParameterId, direction: &[f64]) -> check::Estimate {
        let scale = self.scene.natural_scale(id);
        if !self.scene.moves_edges(id) {
            // A bilinear texture has a kink at every texel: places on it move by so little that few
            // pixels come across one.
            let step = if id.field == "texture_coordinates" { 1e-6 } else { 1e-3 * scale };
            let settings = self.settings.in_double_precision();
            let losses: Vec<_> = self.matched().map(|of| of.loss(self.loss_kind())).collect();
            let losses: Vec<&dyn PixelLoss> = losses.iter().map(|loss| loss as _).collect();
            return check::derivative(self.along(id, direction, &settings, &losses), 0.0, step);
        }
        let [width, height] = self.scene.size();
        let pixels = width * height;
        let [least, most] = RAYS_OF_PIXEL;
        let count = (FINE_RAYS / pixels.max(1)).clamp(least, most);
        let settings = Settings {
            edges: Edges::Off,
            sampling: Sampling::Sobol(Samples { count, seed: 0, gradient: GradientSamples::Same }),
            ..self.settings.in_double_precision()
        };
        let weighted: Vec<Weighted> = self.matched().map(|of| self.weighted(of)).collect();
        let weighted: Vec<&dyn PixelLoss> = weighted.iter().map(|loss| loss as _).collect();
        let mut value = self.along(id, direction, &settings, &weighted);
        let slopes: Vec<f64> = (0..STEPS)
            .map(|index| {
                let step = 1e-3 * scale * f64::powi(2.0, index as i32);
                (value(step) - value(-step)) / (2.0 * step)
            })
            .collect();
        let agreeing = slopes.windows(3).map(|near| {
            let error = (near[0] - near[1]).abs().max((near[1] - near[2]).abs());
            check::Estimate { value: near[1], error }
        });
        agreeing
            .min_by(|a, b| a.error.total_cmp(&b.error))
            .unwrap_or(check::Estimate { value: f64::NAN, error: f64::INFINITY })
    }

    /// The sum of the losses of what is matched, rendered by these settings, as a function of how far a
    /// parameter has moved along a direction. The scene is prepared once for all values.
    fn along<'b>(
        &'b self,
        id: ParameterId,
        direction: &'b [f64],
        settings: &Settings,
        losses: &'b [&'b dyn PixelLoss],
    ) -> impl FnMut(f64) -> f64 + 'b {
        let start = self.scene.get(id);
        let mut scene = self.scene().clone();
        let mut renderer = Renderer::unchecked(&scene, settings);
        move |by| {
            let moved: Vec<f64> =
                start.iter().zip(direction).map(|(value, along)| value + by * along).collect();
            scene.assign(id, &moved);
            renderer.update(&scene);
            let mut sum = 0.0;
            for (target, loss) in self.matched().zip(losses) {
                target.show(&mut scene, &mut renderer);
                sum += renderer.loss(*loss);
            }
            sum
        }
    }

    /// The pixels weighted with the cotangents that the loss of a target gives them. Those that are left out
    /// weigh nothing.
    fn weighted(&self, target: &TargetImage) -> Weighted {
        let image = self.render_target(target, &self.scene);
        let (loss, width) = (target.loss(self.loss_kind()), image.width);
        let cotangents = image.pixels.iter().enumerate().map(|(index, &pixel)| {
            let (x, y) = (index as u32 % width, index as u32 / width);
            let (_, cotangent) = loss.evaluate(x, y, DVec3::from_array(pixel.map(f64::from)));
            if cotangent.is_finite() { cotangent } else { DVec3::ZERO }
        });
        Weighted { cotangents: cotangents.collect(), width }
    }
}

/// A linear loss.
struct Weighted {
    cotangents: Vec<DVec3>,
    width: u32,
}

impl PixelLoss for Weighted {
    fn evaluate(&self, x: u32, y: u32, radiance: DVec3) -> (f64, DVec3) {
        let cotangent = self.cotangents[y as usize * self.width as usize + x as usize];
        (cotangent.dot(radiance), cotangent)
    }
}

/// 1 or -1, as if at random.
fn sign(direction: usize, element: usize) -> f64 {
    let mut hasher = DefaultHasher::new();
    (direction, element).hash(&mut hasher);
    if hasher.finish() & 1 == 0 { 1.0 } else { -1.0 }
}
