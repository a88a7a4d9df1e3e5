//! A loss of some of the pixels.

use glam::DVec3;
use renderer::{ImageLoss, PixelLoss};

/// A loss over the pixels that see the same thing, in the same light, all around the point at which
/// the derivative is checked: where visibility changes, finite differences measure a jump that the
/// interior term does not contain, and rounding another surface.
pub struct AwayFromEdges<'a> {
    pub loss: ImageLoss<'a>,
    /// By pixel.
    pub keep: Vec<bool>,
    pub width: u32,
}

impl PixelLoss for AwayFromEdges<'_> {
    fn evaluate(&self, x: u32, y: u32, radiance: DVec3) -> (f64, DVec3) {
        match self.keep[y as usize * self.width as usize + x as usize] {
            true => self.loss.evaluate(x, y, radiance),
            false => (0.0, DVec3::ZERO),
        }
    }
}
