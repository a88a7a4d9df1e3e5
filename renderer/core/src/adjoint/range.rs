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

use super::chain::sweep;
use super::edges::sweep_with_edges;
use super::gradient::LossAndGradient;
use super::reduce::Totals;
use super::request::Request;
use super::scattered_edges::sweep_paths_with_edges;
use crate::loss::PixelLoss;
use crate::number::Plain;
use crate::primal::image::loss;
use crate::primal::integrator::Prepared;
use crate::scene::Scene;

/// Losses between these leave enough range on both sides.
const ORDINARY: RangeInclusive<f64> = 1e-20..=1e20;

/// The loss of the image of a prepared scene, and its gradient.
pub fn loss_and_gradient<L: Plain>(
    prepared: &Prepared<L>,
    scene: &Scene,
    loss: &dyn PixelLoss,
    request: &Request,
) -> LossAndGradient {
    let result = in_range_of_scalar(prepared, scene, loss, request);
    with_range(prepared, scene, loss, request, result)
}

/// The same, of cotangents that fit into the kernels' scalar.
fn in_range_of_scalar<L: Plain>(
    prepared: &Prepared<L>,
    scene: &Scene,
    loss: &dyn PixelLoss,
    request: &Request,
) -> LossAndGradient {
    let has_edges = request.has_edges(prepared.settings.edges);
    let integrator = prepared.integrator();
    let mut totals = Totals::zero(request);
    match prepared.layout.path_tracing {
        Some(_) if has_edges => {
            sweep_paths_with_edges(prepared, scene, loss, request, &mut totals);
        }
        None if has_edges => totals.add_all(sweep_with_edges(integrator, scene, loss, request)),
        _ => totals.add_all(sweep(integrator, scene, loss, request)),
    }
    totals.reduce(prepared, scene, request)
}

/// The gradient again, if it may have left the range of the kernels' scalar.
fn with_range<L: Plain>(
    prepared: &Prepared<L>,
    scene: &Scene,
    pixel_loss: &dyn PixelLoss,
    request: &Request,
    result: LossAndGradient,
) -> LossAndGradient {
    let Some(scaled) = Scaled::to_fit(prepared, pixel_loss, result.loss) else { return result };
    let mut again = in_range_of_scalar(prepared, scene, &scaled, request);
    again.gradient.scale(scaled.factor);
    LossAndGradient { loss: result.loss, ..again }
}

/// A loss divided by a factor.
pub struct Scaled<'a> {
    pub loss: &'a dyn PixelLoss,
    pub factor: f64,
}

impl<'a> Scaled<'a> {
    /// A loss whose sum over the pixels is `sum`, so that its largest derivative by a channel of a
    /// pixel is between 1 and 2; nothing if it fits into the range of the kernels' scalar as it is.
    pub fn to_fit<L: Plain>(
        prepared: &Prepared<L>,
        loss: &'a dyn PixelLoss,
        sum: f64,
    ) -> Option<Self> {
        let has_range = <L as Lanes>::Element::MIN_POSITIVE.to_f64() < 1e-100;
        if has_range || sum == 0.0 || ORDINARY.contains(&sum) {
            return None;
        }
        let largest = largest_derivative(prepared, loss);
        let is_usable = largest > 0.0 && largest.is_finite();
        let factor = || 2.0_f64.powi(largest.log2().floor() as i32);
        is_usable.then(|| Self { loss, factor: factor() })
    }
}

impl PixelLoss for Scaled<'_> {
    fn evaluate(&self, x: u32, y: u32, radiance: DVec3) -> (f64, DVec3) {
        let (value, derivative) = self.loss.evaluate(x, y, radiance);
        (value / self.factor, derivative / self.factor)
    }
}

/// The largest derivative of the loss by a channel of a pixel.
fn largest_derivative<L: Plain>(prepared: &Prepared<L>, pixel_loss: &dyn PixelLoss) -> f64 {
    struct Largest<'a> {
        loss: &'a dyn PixelLoss,
        /// Its bits, which are in the order of the numbers where these are not negative.
        bits: AtomicU64,
    }

    impl PixelLoss for Largest<'_> {
        fn evaluate(&self, x: u32, y: u32, radiance: DVec3) -> (f64, DVec3) {
            let (_, derivative) = self.loss.evaluate(x, y, radiance);
            let size = derivative.abs().max_element();
            self.bits.fetch_max(size.to_bits(), Ordering::Relaxed);
            (0.0, DVec3::ZERO)
        }
    }

    let largest = Largest { loss: pixel_loss, bits: AtomicU64::new(0) };
    loss(prepared.integrator(), &largest);
    f64::from_bits(largest.bits.into_inner())
}
