//! What is behind an image, a loss or a gradient that is not finite.
//!
//! Rendering does not look for infinities and NaN: they spread, so that a sum that is finite says
//! that all its terms were. Kernels keep them (`positive_part` instead of `max`), and only when a sum
//! is not finite the pixels behind it are searched for, by rendering again. Turned down: tests in the
//! kernels and counters beside the sums, for which every image would pay.

mod cause;

use std::fmt;
use std::sync::atomic::{AtomicBool, Ordering};

use glam::DVec3;

use crate::adjoint::{LossAndGradient, Request, Scaled, loss_and_gradient, sweep};
use crate::loss::PixelLoss;
use crate::number::Plain;
use crate::primal::image::loss;
use crate::primal::integrator::Prepared;
use crate::scene::{ParameterId, Scene};
use crate::trace::tile::strip_index;
use cause::cause;

/// The pixels whose radiance, loss or gradient is not finite. Displays as one line.
#[derive(Clone, Debug, PartialEq)]
pub struct NonFinite {
    /// By pixel, row by row: whether it is finite.
    finite: Vec<bool>,
    /// How many are not.
    pub count: usize,
    /// The column and the row of the first of them.
    pub first: (u32, u32),
    /// What is not finite there first: the kernel or the derivative, with the object.
    pub cause: String,
}

impl fmt::Display for NonFinite {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ((x, y), pixels) = (self.first, self.finite.len());
        let Self { count, cause, .. } = self;
        write!(f, "{count} of {pixels} pixels are not finite; at column {x}, row {y} {cause}")
    }
}

/// Searches for what makes an image not finite.
pub fn find_non_finite_radiance<L: Plain>(
    prepared: &Prepared<L>,
    scene: &Scene,
) -> Option<NonFinite> {
    /// Infinite for radiances that an image cannot hold.
    struct InImage;

    impl PixelLoss for InImage {
        fn evaluate(&self, _: u32, _: u32, radiance: DVec3) -> (f64, DVec3) {
            let value = if radiance.as_vec3().is_finite() { 0.0 } else { f64::INFINITY };
            (value, DVec3::ZERO)
        }
    }

    find_non_finite(prepared, scene, &InImage, &[])
}

/// Searches for what makes a loss, or its gradient by the given parameters, not finite.
pub fn find_non_finite<L: Plain>(
    prepared: &Prepared<L>,
    scene: &Scene,
    loss: &dyn PixelLoss,
    ids: &[ParameterId],
) -> Option<NonFinite> {
    let mut finite = finite_losses(prepared, loss);
    let request = Request::new(scene, &prepared.layout, ids);
    // Without the pixels that are found, the range may be another, and others may leave it.
    while !ids.is_empty()
        && exclude_non_finite_gradients(prepared, scene, loss, &request, &mut finite)
    {}
    let pixel = finite.iter().position(|finite| !finite)?;
    let width = prepared.layout.width as usize;
    let first = ((pixel % width) as u32, (pixel / width) as u32);
    Some(NonFinite {
        count: finite.iter().filter(|finite| !**finite).count(),
        cause: cause(prepared, scene, loss, &request, first),
        first,
        finite,
    })
}

/// Loss and gradient of the pixels that are finite alone; the others bring nothing to the loss.
pub fn gradient_of_finite<L: Plain>(
    prepared: &Prepared<L>,
    scene: &Scene,
    loss: &dyn PixelLoss,
    request: &Request,
    found: &NonFinite,
) -> LossAndGradient {
    let width = prepared.layout.width;
    let chosen = Chosen { loss, chosen: &found.finite, width };
    loss_and_gradient(prepared, scene, &chosen, request)
}

/// A loss of some pixels.
pub(super) struct Chosen<'a> {
    pub loss: &'a dyn PixelLoss,
    /// Whether each pixel counts, row by row.
    pub chosen: &'a [bool],
    pub width: u32,
}

impl PixelLoss for Chosen<'_> {
    fn evaluate(&self, x: u32, y: u32, radiance: DVec3) -> (f64, DVec3) {
        match self.chosen[y as usize * self.width as usize + x as usize] {
            true => self.loss.evaluate(x, y, radiance),
            false => (0.0, DVec3::ZERO),
        }
    }
}

/// By pixel: whether radiance, loss and its derivative are finite.
fn finite_losses<L: Plain>(prepared: &Prepared<L>, pixel_loss: &dyn PixelLoss) -> Vec<bool> {
    struct Watched<'a> {
        loss: &'a dyn PixelLoss,
        finite: Vec<AtomicBool>,
        width: u32,
    }

    impl PixelLoss for Watched<'_> {
        fn evaluate(&self, x: u32, y: u32, radiance: DVec3) -> (f64, DVec3) {
            let (value, derivative) = self.loss.evaluate(x, y, radiance);
            let finite = radiance.is_finite() && value.is_finite() && derivative.is_finite();
            let pixel = y as usize * self.width as usize + x as usize;
            self.finite[pixel].store(finite, Ordering::Relaxed);
            (0.0, DVec3::ZERO)
        }
    }

    let (width, height) = (prepared.layout.width, prepared.layout.height);
    let pixels = width as usize * height as usize;
    let finite = (0..pixels).map(|_| AtomicBool::new(true)).collect();
    let watched = Watched { loss: pixel_loss, finite, width };
    loss(prepared.integrator(), &watched);
    watched.finite.into_iter().map(AtomicBool::into_inner).collect()
}

/// Clears the pixels that bring no finite gradient although their loss is finite, in the range that
/// the gradient of all finite ones is computed in: by halves, in all strips at once. Whether there
/// were any.
fn exclude_non_finite_gradients<L: Plain>(
    prepared: &Prepared<L>,
    scene: &Scene,
    pixel_loss: &dyn PixelLoss,
    request: &Request,
    finite: &mut [bool],
) -> bool {
    let width = prepared.layout.width;
    let all = Chosen { loss: pixel_loss, chosen: finite, width };
    let scaled = Scaled::to_fit(prepared, &all, loss(prepared.integrator(), &all));
    let factor = scaled.map_or(1.0, |scaled| scaled.factor);
    let scaled = Scaled { loss: pixel_loss, factor };
    let mut found = false;
    // By strip: sets of pixels that may hold one whose gradient is not finite.
    let mut suspects: Vec<Vec<Vec<usize>>> = Vec::new();
    for (pixel, _) in finite.iter().enumerate().filter(|(_, finite)| **finite) {
        let (x, y) = (pixel % width as usize, pixel / width as usize);
        let strip = strip_index(width, x, y);
        suspects.resize_with(suspects.len().max(strip + 1), || vec![Vec::new()]);
        suspects[strip][0].push(pixel);
    }
    while suspects.iter().any(|sets| !sets.is_empty()) {
        let sets: Vec<Vec<usize>> =
            suspects.iter_mut().map(|sets| sets.pop().unwrap_or_default()).collect();
        let mut chosen = vec![false; finite.len()];
        sets.iter().flatten().for_each(|&pixel| chosen[pixel] = true);
        let chosen = Chosen { loss: &scaled, chosen: &chosen, width };
        let strips = sweep(prepared.integrator(), scene, &chosen, request);
        for ((mut set, sums), suspects) in sets.into_iter().zip(strips).zip(&mut suspects) {
            match set[..] {
                _ if sums.is_finite() => {}
                [] => {}
                [pixel] => {
                    finite[pixel] = false;
                    found = true;
                }
                _ => {
                    suspects.push(set.split_off(set.len() / 2));
                    suspects.push(set);
                }
            }
        }
    }
    found
}
