//! How far an image is from another: the losses that are minimised.

use glam::DVec3;

use crate::image::Image;

/// A loss that is a sum over pixels.
pub trait PixelLoss: Sync {
    /// What the pixel in column `x` and row `y` adds to the loss if it has this radiance, and the
    /// derivative of that by the radiance.
    fn evaluate(&self, x: u32, y: u32, radiance: DVec3) -> (f64, DVec3);

    /// What several pixels add to the loss; their radiance is replaced by its cotangents.
    #[doc(hidden)]
    fn evaluate_all(&self, pixels: &mut [PixelRadiance]) -> f64 {
        let mut sum = 0.0;
        for pixel in pixels {
            let (value, derivative) = self.evaluate(pixel.x, pixel.y, pixel.radiance);
            sum += value;
            pixel.radiance = derivative;
        }
        sum
    }
}

/// A pixel and its radiance.
#[derive(Clone, Copy, Debug, Default)]
#[doc(hidden)]
pub struct PixelRadiance {
    pub x: u32,
    pub y: u32,
    pub radiance: DVec3,
}

/// How the difference between two images becomes one number.
///
/// "The mean over pixels" is that by their [weights](ImageLoss::weighted), if they have any.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(tag = "type", rename_all = "snake_case", deny_unknown_fields))]
pub enum LossKind {
    /// The mean over pixels and channels of the squared difference.
    #[default]
    MeanSquared,
    /// The sum over pixels and channels of the squared difference.
    SumSquared,
    /// The mean over pixels and channels of the absolute difference. Where the difference is 0,
    /// its derivative counts as 0.
    L1,
    /// The mean over pixels and channels of half the squared difference where it is at most `delta`, and of
    /// `delta` times the absolute difference less half of `delta` beyond: squared near the target, without
    /// being ruled by what no parameter explains (Huber, "Robust Estimation of a Location Parameter", 1964).
    Huber {
        /// Where it goes from squared to absolute; above 0.
        #[cfg_attr(feature = "serde", serde(default = "usual_delta"))]
        delta: f64,
    },
    /// The mean over pixels and channels of the squared difference over the square of the target plus
    /// [`RELATIVE_FLOOR`]: dark parts of a high dynamic range count as much as bright ones.
    RelativeSquared,
}

/// Where [`LossKind::Huber`] goes from squared to absolute, if nobody says.
const USUAL_DELTA: f64 = 0.1;

#[cfg(feature = "serde")]
fn usual_delta() -> f64 {
    USUAL_DELTA
}

/// What [`LossKind::RelativeSquared`] adds to the square of the target, so that black ones can be divided by.
pub const RELATIVE_FLOOR: f64 = 0.01;

impl LossKind {
    /// All kinds with their usual numbers, by the names that files and the command line have for them.
    pub const ALL: [(&str, Self); 5] = [
        ("mean_squared", Self::MeanSquared),
        ("sum_squared", Self::SumSquared),
        ("l1", Self::L1),
        ("huber", Self::Huber { delta: USUAL_DELTA }),
        ("relative_squared", Self::RelativeSquared),
    ];

    /// The kind `name`.
    ///
    /// # Errors
    ///
    /// If there is none of this name; the text says which there are.
    pub fn named(name: &str) -> Result<Self, String> {
        let found = Self::ALL.iter().find(|(other, _)| *other == name);
        found.map(|(_, kind)| *kind).ok_or_else(|| {
            let names = Self::ALL.map(|(name, _)| name);
            format!("no loss `{name}`; there is {}", names.join(", "))
        })
    }
}

/// The loss of an image against a target of the same size.
pub struct ImageLoss<'a> {
    kind: LossKind,
    target: &'a Image,
    saturates: bool,
    /// One for each pixel, if they do not all count the same.
    weights: Option<&'a [f32]>,
    /// One over what the kind divides by.
    scale: f64,
}

impl<'a> ImageLoss<'a> {
    /// The loss against `target`.
    ///
    /// If the target `saturates`, its values are clipped at 1, as those of a photograph: 1 says no
    /// more than "at least 1", and a rendered value above it counts as equal.
    pub fn new(kind: LossKind, target: &'a Image, saturates: bool) -> Self {
        let scale = scale(kind, target.pixels.len() as f64);
        Self { kind, target, saturates, weights: None, scale }
    }

    /// The loss whose pixels, row by row, count by these weights, 0 or more: what a mean divides by is their
    /// sum. Pixels of weight 0 count as equal, whatever they are.
    ///
    /// # Panics
    ///
    /// If there is not one for each pixel, or their sum is not above 0.
    #[must_use]
    pub fn weighted(self, weights: &'a [f32]) -> Self {
        assert_eq!(weights.len(), self.target.pixels.len(), "a weight for each pixel");
        let sum: f64 = weights.iter().map(|&weight| f64::from(weight)).sum();
        assert!(sum > 0.0, "some pixel counts");
        Self { weights: Some(weights), scale: scale(self.kind, sum), ..self }
    }

    /// The loss times a factor.
    #[must_use]
    pub fn times(self, factor: f64) -> Self {
        Self { scale: self.scale * factor, ..self }
    }
}

impl LossKind {
    /// Whether its second derivative says where the minimum is: a least-squares method needs that.
    pub fn is_curved(self) -> bool {
        self != Self::L1
    }
}

/// One over what a kind divides by where weights add up to `sum`.
fn scale(kind: LossKind, sum: f64) -> f64 {
    match kind {
        LossKind::SumSquared => 1.0,
        _ => 1.0 / (3.0 * sum),
    }
}

impl ImageLoss<'_> {
    /// The second derivative of what a pixel adds to the loss by each channel of its radiance: 0 where the loss
    /// is flat or straight. Nothing of [`LossKind::L1`], which is straight everywhere.
    pub fn curvature(&self, x: u32, y: u32, radiance: DVec3) -> Option<DVec3> {
        let index = y as usize * self.target.width as usize + x as usize;
        let target = glam::Vec3::from(self.target.pixels[index]).as_dvec3();
        let weight = self.weights.map_or(1.0, |weights| f64::from(weights[index]));
        let scale = DVec3::splat(self.scale * weight);
        let curvature = match self.kind {
            LossKind::MeanSquared | LossKind::SumSquared => 2.0 * scale,
            LossKind::L1 => return None,
            LossKind::Huber { delta } => {
                let is_near = (radiance - target).abs().cmple(DVec3::splat(delta));
                DVec3::select(is_near, scale, DVec3::ZERO)
            }
            LossKind::RelativeSquared => 2.0 * scale / (target * target + RELATIVE_FLOOR),
        };
        let hidden = target.cmpge(DVec3::ONE) & radiance.cmpge(DVec3::ONE);
        Some(if self.saturates { DVec3::select(hidden, DVec3::ZERO, curvature) } else { curvature })
    }
}

impl PixelLoss for ImageLoss<'_> {
    #[inline]
    fn evaluate(&self, x: u32, y: u32, radiance: DVec3) -> (f64, DVec3) {
        let index = y as usize * self.target.width as usize + x as usize;
        let target = glam::Vec3::from(self.target.pixels[index]).as_dvec3();
        let mut scale = self.scale;
        if let Some(weights) = self.weights {
            scale *= f64::from(weights[index]);
            if scale == 0.0 {
                return (0.0, DVec3::ZERO);
            }
        }
        let mut difference = radiance - target;
        if self.saturates {
            // What is infinite equals nothing: it has to show in the loss.
            let equal = target.cmpge(DVec3::ONE)
                & radiance.cmpge(DVec3::ONE)
                & radiance.cmplt(DVec3::INFINITY);
            difference = DVec3::select(equal, DVec3::ZERO, difference);
        }
        match self.kind {
            LossKind::MeanSquared | LossKind::SumSquared => {
                (scale * difference.length_squared(), difference * (2.0 * scale))
            }
            LossKind::L1 => {
                let sign =
                    DVec3::select(difference.cmpeq(DVec3::ZERO), DVec3::ZERO, difference.signum());
                (scale * difference.abs().element_sum(), sign * scale)
            }
            LossKind::Huber { delta } => {
                let clamped = difference.clamp(DVec3::splat(-delta), DVec3::splat(delta));
                // Of each channel: within, d^2 / 2; beyond, delta |d| - delta^2 / 2.
                (scale * clamped.dot(difference - 0.5 * clamped), clamped * scale)
            }
            LossKind::RelativeSquared => {
                let relative = difference / (target * target + RELATIVE_FLOOR);
                (scale * relative.dot(difference), relative * (2.0 * scale))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_are_those_of_the_losses() {
        let target = Image { width: 1, height: 1, pixels: vec![[0.3, 0.0, 4.0]] };
        for (name, kind) in LossKind::ALL {
            let loss = ImageLoss::new(kind, &target, false).weighted(&[0.7]).times(3.0);
            for radiance in [DVec3::new(0.35, 0.5, 1.0), DVec3::new(0.0, 0.02, 9.0)] {
                let (_, cotangent) = loss.evaluate(0, 0, radiance);
                for axis in DVec3::AXES {
                    let value = |by: f64| loss.evaluate(0, 0, radiance + axis * by).0;
                    let difference = (value(1e-6) - value(-1e-6)) / 2e-6;
                    let error = (cotangent.dot(axis) - difference).abs();
                    assert!(error < 1e-7, "{name} {radiance} {axis}: {error}");
                    let slope = |by: f64| loss.evaluate(0, 0, radiance + axis * by).1.dot(axis);
                    let second = (slope(1e-6) - slope(-1e-6)) / 2e-6;
                    if let Some(curvature) = loss.curvature(0, 0, radiance) {
                        let error = (curvature.dot(axis) - second).abs();
                        assert!(error < 1e-6, "{name} {radiance} {axis}: {error}");
                    }
                }
            }
        }
    }

    #[test]
    fn pixels_without_weight_do_not_count() {
        let pixels = vec![[1.0; 3], [2.0; 3]];
        let target = Image { width: 2, height: 1, pixels };
        let loss = ImageLoss::new(LossKind::MeanSquared, &target, false).weighted(&[0.0, 0.5]);
        assert_eq!(loss.evaluate(0, 0, DVec3::splat(f64::NAN)), (0.0, DVec3::ZERO));
        let (value, _) = loss.evaluate(1, 0, DVec3::splat(5.0));
        assert!((value - 9.0).abs() < 1e-12, "{value}");
    }

    #[test]
    fn clipped_targets_hide_what_is_brighter_and_nothing_infinite() {
        let target = Image { width: 1, height: 1, pixels: vec![[1.0; 3]] };
        let loss = ImageLoss::new(LossKind::MeanSquared, &target, true);
        assert_eq!(loss.evaluate(0, 0, DVec3::splat(7.0)), (0.0, DVec3::ZERO));
        assert!(loss.evaluate(0, 0, DVec3::INFINITY).0.is_infinite());
        assert!(loss.evaluate(0, 0, DVec3::NAN).0.is_nan());
    }
}
