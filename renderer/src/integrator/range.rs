//! Gradients whose cotangents do not fit into single precision.
//!
//! A squared difference of two radiances of 1e-30 has derivatives of 1e-60, which an `f32` takes for
//! zero; one of 1e30 has some of 1e60, which are infinite. A pullback is linear in its cotangent, so
//! these are divided by a power of two and the sums, in double precision, are multiplied by it. Only a
//! loss that is far from 1 says that this may be needed, and only then it is done: all over again.

use std::ops::RangeInclusive;
use std::sync::atomic::{AtomicU64, Ordering};

use ad::lanes::Lanes;
use ad::{Real, Scalar};
use glam::DVec3;

use super::gradient::{GradientResult, Wanted, reduce};
use super::prepared::Prepared;
use super::radiance::{PixelLoss, loss};
use super::sweep::sweep;

/// Losses between these leave enough range on both sides.
const ORDINARY: RangeInclusive<f64> = 1e-20..=1e20;

/// The gradient again, if it may have left the range of the kernels' scalar.
pub(super) fn with_range<L: Lanes>(
    prepared: &Prepared<'_, L>,
    pixel_loss: &impl PixelLoss,
    wanted: Wanted<'_>,
    result: GradientResult,
) -> GradientResult {
    let Some(scaled) = Scaled::to_fit(prepared, pixel_loss, result.loss) else { return result };
    let mut again = reduce(prepared, sweep(prepared, &scaled, wanted), wanted);
    again.gradient.scale(&prepared.scene.parameter_ids(), scaled.factor);
    GradientResult { loss: result.loss, ..again }
}

/// A loss divided by a factor.
pub(super) struct Scaled<'a, P> {
    pub loss: &'a P,
    pub factor: f64,
}

impl<'a, P: PixelLoss> Scaled<'a, P> {
    /// A loss whose sum over the pixels is `sum`, so that its largest derivative by a channel of a
    /// pixel is between 1 and 2; nothing if it fits into the range of the kernels' scalar as it is.
    pub fn to_fit<L: Lanes>(prepared: &Prepared<'_, L>, loss: &'a P, sum: f64) -> Option<Self> {
        let has_range = L::Element::MIN_POSITIVE.to_f64() < 1e-100;
        if has_range || sum == 0.0 || ORDINARY.contains(&sum) {
            return None;
        }
        let largest = largest_derivative(prepared, loss);
        let is_usable = largest > 0.0 && largest.is_finite();
        let factor = || 2.0_f64.powi(largest.log2().floor() as i32);
        is_usable.then(|| Self { loss, factor: factor() })
    }
}

impl<P: PixelLoss> PixelLoss for Scaled<'_, P> {
    fn evaluate(&self, x: u32, y: u32, radiance: DVec3) -> (f64, DVec3) {
        let (value, derivative) = self.loss.evaluate(x, y, radiance);
        (value / self.factor, derivative / self.factor)
    }
}

/// The largest derivative of the loss by a channel of a pixel.
fn largest_derivative<L: Lanes>(prepared: &Prepared<'_, L>, pixel_loss: &impl PixelLoss) -> f64 {
    struct Largest<'a, P> {
        loss: &'a P,
        /// Its bits, which are in the order of the numbers where these are not negative.
        bits: AtomicU64,
    }

    impl<P: PixelLoss> PixelLoss for Largest<'_, P> {
        fn evaluate(&self, x: u32, y: u32, radiance: DVec3) -> (f64, DVec3) {
            let (_, derivative) = self.loss.evaluate(x, y, radiance);
            let size = derivative.abs().max_element();
            self.bits.fetch_max(size.to_bits(), Ordering::Relaxed);
            (0.0, DVec3::ZERO)
        }
    }

    let largest = Largest { loss: pixel_loss, bits: AtomicU64::new(0) };
    loss(prepared, &largest);
    f64::from_bits(largest.bits.into_inner())
}
