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
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum LossKind {
    /// The mean over pixels and channels of the squared difference.
    #[default]
    MeanSquared,
    /// The sum over pixels and channels of the squared difference.
    SumSquared,
    /// The mean over pixels and channels of the absolute difference. Where the difference is 0,
    /// its derivative counts as 0.
    L1,
}

/// The loss of an image against a target of the same size.
pub struct ImageLoss<'a> {
    kind: LossKind,
    target: &'a Image,
    saturates: bool,
    /// One over what the kind divides by.
    scale: f64,
}

impl<'a> ImageLoss<'a> {
    /// The loss against `target`.
    ///
    /// If the target `saturates`, its values are clipped at 1, as those of a photograph: 1 says no
    /// more than "at least 1", and a rendered value above it counts as equal.
    pub fn new(kind: LossKind, target: &'a Image, saturates: bool) -> Self {
        let scale = match kind {
            LossKind::MeanSquared | LossKind::L1 => 1.0 / (3.0 * target.pixels.len() as f64),
            LossKind::SumSquared => 1.0,
        };
        Self { kind, target, saturates, scale }
    }
}

impl PixelLoss for ImageLoss<'_> {
    #[inline]
    fn evaluate(&self, x: u32, y: u32, radiance: DVec3) -> (f64, DVec3) {
        let index = y as usize * self.target.width as usize + x as usize;
        let target = glam::Vec3::from(self.target.pixels[index]).as_dvec3();
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
                (self.scale * difference.length_squared(), difference * (2.0 * self.scale))
            }
            LossKind::L1 => {
                let sign =
                    DVec3::select(difference.cmpeq(DVec3::ZERO), DVec3::ZERO, difference.signum());
                (self.scale * difference.abs().element_sum(), sign * self.scale)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clipped_targets_hide_what_is_brighter_and_nothing_infinite() {
        let target = Image { width: 1, height: 1, pixels: vec![[1.0; 3]] };
        let loss = ImageLoss::new(LossKind::MeanSquared, &target, true);
        assert_eq!(loss.evaluate(0, 0, DVec3::splat(7.0)), (0.0, DVec3::ZERO));
        assert!(loss.evaluate(0, 0, DVec3::INFINITY).0.is_infinite());
        assert!(loss.evaluate(0, 0, DVec3::NAN).0.is_nan());
    }
}
