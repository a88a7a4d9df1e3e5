//! Whether a gradient is right, beside differences that share nothing with it but the rays.
//!
//! Where a parameter moves no edges, the loss itself is smooth, and its differences are exact. Where it
//! does, the differences are of finely sampled images without edges, weighted with the cotangents of the
//! pixels: nothing of the search for edges is in them, and they are the derivative of the true image but
//! for the noise of samples that edges move across. That noise is seen from several seeds, and samples are added
//! until the difference is known well enough; the step is the one at which the noise and the change from
//! smaller steps are the least, and these are the uncertainty.
//!
//! Paths are chosen at random, and so are gradients of what they show by parameters that move edges: they are
//! compared as the mean over several seeds. So are those by other parameters where differences of the loss disagree: what
//! paths are chosen by, such as a [rounded](crate::transport::microfacet::sampling()) roughness, changes in steps, and a
//! difference over one of them is that of other paths.
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
use crate::optimize::Evaluation;
use crate::render::Renderer;
use crate::scene::{Integrator, ParameterId, Scene};
use crate::settings::{Edges, GradientSamples, Samples, Sampling, Settings};

/// The most numbers that are compared one by one.
const MOST_NUMBERS: usize = 4;

/// How many random directions stand for more.
const DIRECTIONS: usize = 4;

/// How many rays finely sampled images have at first, at last, and at last where light takes all paths.
const FEWEST_RAYS: u32 = 1 << 16;
const MOST_RAYS: u32 = 1 << 21;
const MOST_RAYS_OF_PATHS: u32 = 1 << 19;

/// The bounds of that for each pixel at first, and how many any image may have at last.
const RAYS_OF_PIXEL: [u32; 2] = [4, 1 << 16];
const RAYS_OF_LARGE: u32 = 16;

/// Of how many seeds there are images.
const SEEDS: u32 = 4;

/// A difference is known well enough up to this part of how far the gradient may be off, of how far it is off, or of
/// the uncertainty of the gradient.
const ENOUGH_OF_TOLERANCE: f64 = 0.2;
const ENOUGH_OF_ERROR: f64 = 0.25;
const ENOUGH_OF_NOISE: f64 = 0.5;

/// How many steps are tried, each twice as long as the one before.
const STEPS: usize = 6;

/// Of how many seeds the gradient is compared where it is random.
const SEEDS_OF_GRADIENT: u32 = 8;

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
    /// How exactly both are known.
    pub uncertainty: f64,
}

/// What a comparison says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Finding {
    /// The gradient is off by no more than a tolerance.
    Agrees,
    /// The differences, or the gradient itself, are not known as exactly as the tolerance.
    Unknown,
    /// The gradient is off by more than the tolerance and what is not known.
    Disagrees,
}

impl Verdict {
    /// What is found about a gradient that may be off by so much of its norm.
    pub fn at(&self, tolerance: f64) -> Finding {
        let Self { error, uncertainty, .. } = *self;
        if error <= tolerance && uncertainty <= tolerance {
            Finding::Agrees
        } else if error > tolerance + uncertainty {
            Finding::Disagrees
        } else {
            Finding::Unknown
        }
    }
}

impl Recovery<'_> {
    /// Compares the gradient by a parameter at the scene as it stands with differences, as exactly as it takes to
    /// tell whether it is off by more than a part `tolerance` of its norm.
    pub fn check(&self, id: ParameterId, gradient: &[f64], tolerance: f64) -> Verdict {
        if !self.scene.moves_edges(id) {
            let of_loss = self.compare(id, gradient, |direction, _| {
                let along = check::Estimate { value: dot(gradient, direction), error: 0.0 };
                (along, self.difference(id, direction))
            });
            if !self.is_random() || of_loss.at(tolerance) != Finding::Disagrees {
                return of_loss;
            }
        }
        let random = self.gradients_of_seeds(id);
        let gradients = if random.is_empty() { vec![gradient.to_vec()] } else { random };
        let enough = ENOUGH_OF_TOLERANCE * tolerance * norm_of(gradient.iter().copied());
        self.compare(id, gradient, |direction, of_terms| {
            let along = mean(gradients.iter().map(|gradient| dot(gradient, direction)));
            let enough = enough.max(ENOUGH_OF_NOISE * along.error);
            let of_images = along.value - of_terms;
            (along, self.sampled_difference(id, direction, of_images, enough))
        })
    }

    /// Compares a gradient with differences by what `derivatives` gives along a direction: the derivative by the
    /// gradient, and the difference of images, which lacks the derivative of other terms, its second argument.
    fn compare(
        &self,
        id: ParameterId,
        gradient: &[f64],
        derivatives: impl Fn(&[f64], f64) -> (check::Estimate, check::Estimate),
    ) -> Verdict {
        let one_by_one = gradient.len() <= MOST_NUMBERS;
        let count = if one_by_one { gradient.len() } else { DIRECTIONS };
        let compared: Vec<Compared> = (0..count)
            .map(|index| {
                let direction: Vec<f64> = match one_by_one {
                    true => (0..gradient.len()).map(|at| f64::from(at == index)).collect(),
                    false => (0..gradient.len()).map(|at| sign(index, at)).collect(),
                };
                let of_terms = self.terms_along(id, &direction);
                let (along, of_images) = derivatives(&direction, of_terms.value);
                Compared {
                    element: one_by_one.then_some(index),
                    gradient: along.value,
                    difference: of_images.value + of_terms.value,
                    uncertainty: along.error + of_images.error + of_terms.error,
                }
            })
            .collect();
        let norm = |of: &dyn Fn(&Compared) -> f64| norm_of(compared.iter().map(of));
        // The norm of all numbers stands for that along as many directions.
        let whole = norm_of(gradient.iter().copied())
            * if one_by_one { 1.0 } else { (count as f64).sqrt() };
        let scale = norm(&|compared| compared.difference).max(whole).max(f64::MIN_POSITIVE);
        let error = norm(&|compared| compared.gradient - compared.difference) / scale;
        let uncertainty = norm(&|compared| compared.uncertainty) / scale;
        Verdict { compared, error, uncertainty }
    }

    /// All numbers that vary, and where those of a parameter start.
    fn numbers(&self, id: ParameterId) -> (Vec<f64>, usize) {
        let before = self.ids.iter().take_while(|&&other| other != id);
        let start = before.map(|&other| self.scene.count(other)).sum();
        (self.ids.iter().flat_map(|&other| self.scene.get(other).into_owned()).collect(), start)
    }

    /// The gradient of the terms of the loss that are not of images.
    fn gradient_of_terms(&self, id: ParameterId) -> Vec<f64> {
        let (x, start) = self.numbers(id);
        let mut sum = Evaluation { loss: 0.0, gradient: vec![0.0; x.len()] };
        self.regularizers.iter().for_each(|term| term.add(&x, &mut sum));
        sum.gradient[start..start + self.scene.count(id)].to_vec()
    }

    /// The derivative of these terms along a direction, by differences.
    fn terms_along(&self, id: ParameterId, direction: &[f64]) -> check::Estimate {
        if self.regularizers.is_empty() {
            return check::Estimate { value: 0.0, error: 0.0 };
        }
        let (x, start) = self.numbers(id);
        let value = |by: f64| -> f64 {
            let mut x = x.clone();
            x[start..].iter_mut().zip(direction).for_each(|(x, along)| *x += by * along);
            self.regularizers.iter().map(|term| term.value(&x)).sum()
        };
        check::derivative(value, 0.0, 1e-4 * self.scene.natural_scale(id))
    }

    /// The derivative of the loss of images along a direction of a parameter that moves no edges, by its differences.
    fn difference(&self, id: ParameterId, direction: &[f64]) -> check::Estimate {
        // A bilinear texture has a kink at every texel, and paths end at random in steps: places and colours move
        // by so little that few pixels come across one.
        let has_steps = id.field == "texture_coordinates" || self.is_random();
        let step = self.scene.natural_scale(id) * if has_steps { 1e-6 } else { 1e-3 };
        let settings = self.settings.in_double_precision();
        let losses: Vec<_> = self.matched().map(|of| of.loss(self.loss_kind())).collect();
        let losses: Vec<&dyn PixelLoss> = losses.iter().map(|loss| loss as _).collect();
        let mut moved = Moved::new(self, id, direction, &settings, &losses);
        check::derivative(|by| moved.loss(by), 0.0, step)
    }

    /// The same by differences of finely sampled images, until it is known to so much, or well beside how far it is
    /// from the gradient along that direction.
    fn sampled_difference(
        &self,
        id: ParameterId,
        direction: &[f64],
        gradient: f64,
        enough: f64,
    ) -> check::Estimate {
        let [width, height] = self.scene.size();
        let pixels = (width * height).max(1);
        let [least, most] = RAYS_OF_PIXEL;
        let mut count = (FEWEST_RAYS / pixels).clamp(least, most);
        let most = if self.is_random() { MOST_RAYS_OF_PATHS } else { MOST_RAYS } / pixels;
        let most = most.max(RAYS_OF_LARGE);
        let sampling =
            |count, seed| Sampling::Sobol(Samples { count, seed, gradient: GradientSamples::Same });
        let settings = Settings {
            edges: Edges::Off,
            sampling: sampling(count, 0),
            ..self.settings.in_double_precision()
        };
        let weighted: Vec<Weighted> = self.matched().map(|of| self.weighted(of)).collect();
        let weighted: Vec<&dyn PixelLoss> = weighted.iter().map(|loss| loss as _).collect();
        let mut moved = Moved::new(self, id, direction, &settings, &weighted);
        let mut steps = STEPS;
        loop {
            let of_seeds = |index: usize| {
                let step = 1e-3 * self.scene.natural_scale(id) * f64::powi(2.0, index as i32);
                let samplings = (0..SEEDS).map(|seed| sampling(count, seed));
                let [after, before] = [step, -step].map(|by| moved.losses(by, samplings.clone()));
                let slopes = after.iter().zip(before);
                mean(slopes.map(|(after, before)| (after - before) / (2.0 * step)))
            };
            let slopes: Vec<check::Estimate> = (0..steps).map(of_seeds).collect();
            let (index, found) = best_known(&slopes);
            let off = (found.value - gradient).abs();
            if found.error <= enough.max(ENOUGH_OF_ERROR * off) || count.saturating_mul(4) > most {
                return found;
            }
            // With less noise the best step is no longer, though noise may have made another look the best.
            steps = (index + 2).min(steps);
            count *= 4;
        }
    }

    /// Whether gradients by what moves edges depend on the seed.
    fn is_random(&self) -> bool {
        matches!(self.scene().integrator, Integrator::Path(_))
    }

    /// The gradients of other seeds, where they differ.
    fn gradients_of_seeds(&self, id: ParameterId) -> Vec<Vec<f64>> {
        let Integrator::Path(paths) = self.scene().integrator else { return Vec::new() };
        let sampling = paths.sampling(self.settings.sampling);
        if let Sampling::Grid(_) = sampling {
            return Vec::new();
        }
        let mut scene = self.scene().clone();
        let mut renderer = Renderer::unchecked(&scene, &self.settings);
        let weighted: Vec<Weighted> = self.matched().map(|of| self.weighted(of)).collect();
        // Not the seed of the cotangents.
        (0..SEEDS_OF_GRADIENT)
            .map(|seed| {
                renderer.resample(sampling.batch(sampling.count(), u32::MAX - seed));
                let mut sum = self.gradient_of_terms(id);
                for (target, loss) in self.matched().zip(&weighted) {
                    target.show(&mut scene, &mut renderer);
                    let of_target = renderer.loss_and_gradient(&scene, loss, &[id]);
                    sum.iter_mut().zip(of_target.gradient.get(id)).for_each(|(sum, x)| *sum += x);
                }
                sum
            })
            .collect()
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

/// The slope that is known best of those at rising steps, and its index: by its noise, and one and a half times how
/// far it is from those at a half and a quarter of the step. Slopes change with a power of the step, two where images
/// are smooth and down to a half at small facets: that at no step is 1.1 to 2 times as far as that at a quarter.
fn best_known(slopes: &[check::Estimate]) -> (usize, check::Estimate) {
    let known = slopes.windows(3).enumerate().map(|(index, near)| {
        let change = |other: usize| (near[2].value - near[other].value).abs();
        let error = near[2].error + 1.5 * change(0).max(change(1));
        (index + 2, check::Estimate { error, ..near[2] })
    });
    let unknown = (slopes.len(), check::Estimate { value: f64::NAN, error: f64::INFINITY });
    known.min_by(|a, b| a.1.error.total_cmp(&b.1.error)).unwrap_or(unknown)
}

/// The mean of numbers, and twice its standard error; one number is known.
fn mean(numbers: impl ExactSizeIterator<Item = f64> + Clone) -> check::Estimate {
    let count = numbers.len() as f64;
    let value = numbers.clone().sum::<f64>() / count;
    let variance =
        numbers.map(|number| (number - value).powi(2)).sum::<f64>() / (count - 1.0).max(1.0);
    check::Estimate { value, error: 2.0 * (variance / count).sqrt() }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn norm_of(numbers: impl Iterator<Item = f64>) -> f64 {
    numbers.map(|number| number * number).sum::<f64>().sqrt()
}

/// The loss of images as a function of how far a parameter has moved along a direction. The scene is prepared
/// once for all.
struct Moved<'a> {
    recovery: &'a Recovery<'a>,
    id: ParameterId,
    direction: &'a [f64],
    start: Vec<f64>,
    scene: Scene,
    renderer: Renderer,
    losses: &'a [&'a dyn PixelLoss],
}

impl<'a> Moved<'a> {
    fn new(
        recovery: &'a Recovery<'a>,
        id: ParameterId,
        direction: &'a [f64],
        settings: &Settings,
        losses: &'a [&'a dyn PixelLoss],
    ) -> Self {
        let scene = recovery.scene().clone();
        let renderer = Renderer::unchecked(&scene, settings);
        let start = scene.get(id).to_vec();
        Self { recovery, id, direction, start, scene, renderer, losses }
    }

    fn go(&mut self, by: f64) {
        let along = self.start.iter().zip(self.direction);
        let numbers: Vec<f64> = along.map(|(value, along)| value + by * along).collect();
        self.scene.assign(self.id, &numbers);
        self.renderer.update(&self.scene);
    }

    /// The sum of the losses of what is matched.
    fn sum(&mut self) -> f64 {
        let Self { recovery, scene, renderer, .. } = self;
        let mut sum = 0.0;
        for (target, loss) in recovery.matched().zip(self.losses) {
            target.show(scene, renderer);
            sum += renderer.loss(*loss);
        }
        sum
    }

    fn loss(&mut self, by: f64) -> f64 {
        self.go(by);
        self.sum()
    }

    /// One loss for each way to sample.
    fn losses(&mut self, by: f64, samplings: impl Iterator<Item = Sampling>) -> Vec<f64> {
        self.go(by);
        let of = |sampling| {
            self.renderer.resample(sampling);
            self.sum()
        };
        samplings.map(of).collect()
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

#[cfg(test)]
mod tests {
    use ad::check;

    use super::{Finding, Verdict, best_known, mean};

    #[test]
    fn findings() {
        let at = |error, uncertainty| Verdict { compared: Vec::new(), error, uncertainty }.at(0.02);
        assert_eq!(at(0.01, 0.01), Finding::Agrees);
        assert_eq!(at(0.1, 0.01), Finding::Disagrees);
        for (error, uncertainty) in [(0.1, 0.2), (0.01, 0.2), (0.025, 0.01), (f64::NAN, 0.01)] {
            assert_eq!(at(error, uncertainty), Finding::Unknown, "{error} {uncertainty}");
        }
    }

    #[test]
    fn uncertainties() {
        let found = mean([1.0, 3.0].into_iter());
        assert_eq!((found.value, found.error), (2.0, 2.0));
        assert_eq!(mean([5.0].into_iter()).error, 0.0);
        let noisy = |value, error| check::Estimate { value, error };
        let slopes =
            [noisy(5.0, 4.0), noisy(3.0, 2.0), noisy(2.0, 1.0), noisy(2.5, 0.5), noisy(7.0, 0.1)];
        let (index, found) = best_known(&slopes);
        assert_eq!((index, found.value, found.error), (3, 2.5, 1.25));
        assert_eq!(best_known(&slopes[..2]).1.error, f64::INFINITY);
    }
}
