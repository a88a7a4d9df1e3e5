//! Other random numbers in each iteration.
//!
//! A squared difference from an image with noise is larger by the variance of that noise, so a run that always takes
//! the same numbers ends at parameters whose images have little noise, or whose noise fits the target: too dark where
//! few paths tell what is bright. Two things together leave nothing of it on average. Each
//! iteration takes numbers of its own, and half of its paths are
//! [independent](GradientSamples::Independent) of the others.

use super::{Recovery, compares_losses};
use crate::Error;
use crate::experiment::{OptimizeSection, Target};
use crate::loss::LossKind;
use crate::scene::{Integrator, Scene};
use crate::settings::{GradientSamples, Sampling};

impl Recovery<'_> {
    /// The paths whose random numbers a run takes anew in each iteration, if it does. It does not unless told to where
    /// the target is rendered with the same random numbers, where steps are compared by their losses, and where the
    /// derivative of the loss is not in proportion to the difference, so that noise does not leave it on average.
    pub(super) fn resampling(&self) -> Option<Sampling> {
        let Integrator::Path(paths) = self.scene.integrator else { return None };
        let optimizer = self.section.optimizer.unwrap_or_default();
        let is_rendered = matches!(self.section.target, Some(Target::Values(_)));
        let is_square = match self.loss_kind() {
            LossKind::MeanSquared | LossKind::SumSquared | LossKind::RelativeSquared => true,
            LossKind::L1 | LossKind::Huber { .. } => false,
        };
        let by_default = is_square && !is_rendered && !optimizer.finds_step_lengths();
        let resamples = self.section.resample.unwrap_or(by_default);
        let sampling = paths.sampling(self.settings.sampling);
        resamples.then(|| sampling.with_gradient(GradientSamples::Independent))
    }
}

/// Whether there are random numbers to take anew, and a method that compares losses gets the same loss each time.
pub(super) fn check_resampling(
    scene: &Scene,
    section: &OptimizeSection,
    place: &str,
) -> Result<(), Error> {
    let optimizer = section.optimizer.unwrap_or_default();
    let problem = match scene.integrator {
        _ if section.resample != Some(true) => return Ok(()),
        Integrator::Direct => {
            "takes other random numbers in each iteration, and there are none without \
             `[integrator] type = \"path\"`"
                .to_owned()
        }
        Integrator::Path(_) if optimizer.finds_step_lengths() => {
            compares_losses(optimizer, "random numbers", "resample")
        }
        Integrator::Path(_) => return Ok(()),
    };
    Err(Error::new(format_args!("{place}: optimize.resample"), problem))
}
