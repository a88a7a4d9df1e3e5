//! Accuracy targets: the cheapest settings whose gradient is as accurate as asked.
//!
//! [`select`] tries settings on the scene itself and takes the one with the least [work](Trial::work)
//! whose estimated error stays within the accuracy that is asked for. If none does, it takes the most
//! accurate one and says so ([`Selection::is_within`]).
//!
//! The error is that of the whole gradient ([`GradientMetric`]), relative to the gradient in double
//! precision with all mirrors that the scene asks for, and with [edges](crate::Settings::edges) wherever
//! the problem has them. What every setting shares it does not see: which primitive a ray meets is always
//! decided in single precision, and where edges are turned off, silhouettes and shadow edges that move are
//! missing from every gradient.
//!
//! Rays through pixels are as given, or chosen too ([`Rays`]). Which of it means something depends on
//! the target. One that the same renderer made from the same rays is matched by these rays exactly,
//! and more would aim at another image. The pixels of a photo are integrals: more rays come closer to
//! their gradient. The error is then the root mean square over several seeds, against the mean of several
//! gradients of more rays.
//!
//! Work is counted, not timed: rays and shaded points, weighted by what the scalar costs. So the same
//! scene always gets the same settings, and an optimisation that is resumed goes on with those it
//! began with. Turned down: the time of the trials, which another program on the machine changes.

mod evaluator;
mod metric;
mod rays;
mod reference;
mod sampler;
#[cfg(all(test, feature = "cli"))]
mod tests;
mod trials;
mod work;

use std::fmt;

pub(crate) use evaluator::Evaluator;
pub use metric::GradientMetric;
#[cfg(feature = "cli")]
pub(crate) use metric::image_error;
#[cfg(feature = "cli")]
pub(crate) use reference::{IntegralGradient, grids};
pub use sampler::Sampler;
use work::Work;

use crate::arithmetic::Arithmetic;
use crate::recovery::Recovery;
use crate::settings::{Sampling, Settings};

/// What a gradient is computed with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Setting {
    /// The scalar of the kernels.
    pub arithmetic: Arithmetic,
    /// How many mirrors light meets at most.
    pub bounces: u32,
    /// The rays through a pixel.
    pub sampling: Sampling,
}

/// Whether the selection chooses the rays through pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rays {
    /// They are those of the problem's [settings](Recovery::render_settings), and so are those of the
    /// gradient that errors are relative to.
    Given,
    /// One through the middle of each pixel, or so many as suit a sampler. Errors are relative to the
    /// gradient of pixels that are integrals.
    Chosen {
        /// Where in the pixel they go.
        sampler: Sampler,
        /// More rays through a pixel are not tried, nor more than 2^24 in the image.
        most: u32,
    },
}

/// What of a setting is not its rays through a pixel: its scalar and how many mirrors light meets at most.
type Kind = (Arithmetic, u32);

impl Setting {
    fn kind(&self) -> Kind {
        (self.arithmetic, self.bounces)
    }

    /// The recovery with the same target, rendered with this setting.
    pub fn apply<'a>(&self, recovery: &Recovery<'a>) -> Recovery<'a> {
        let &Self { arithmetic, bounces, sampling } = self;
        let settings = *recovery.render_settings();
        let bounces = Some(bounces);
        recovery.with_settings(&Settings { arithmetic, bounces, sampling, ..settings })
    }
}

/// A setting that was tried.
#[derive(Clone, Debug, PartialEq)]
pub struct Trial {
    /// The setting.
    pub setting: Setting,
    /// The estimated relative error of its gradient. If rays were chosen: the root mean square over
    /// seeds, plus its standard error.
    pub error: f64,
    /// What a gradient costs, in units of one ray from the camera in single precision.
    pub work: f64,
}

/// What was selected, and from what.
#[derive(Clone, Debug, PartialEq)]
pub struct Selection {
    /// The relative error that was asked for.
    pub accuracy: f64,
    /// What was selected.
    pub best: Trial,
    /// All settings that were tried; if rays were chosen, from cheap ones on to the first that is
    /// within.
    pub trials: Vec<Trial>,
}

impl Selection {
    /// Whether the estimated error is within what was asked for. If it is not, no setting that was
    /// tried has a smaller one.
    pub fn is_within(&self) -> bool {
        self.best.error <= self.accuracy
    }
}

/// The cheapest setting whose estimated relative error of the gradient is at most `accuracy`, or the
/// most accurate one if there is none. `recovery` is the problem; its target should have been
/// rendered in double precision, if it is rendered at all.
pub fn select(recovery: &Recovery<'_>, accuracy: f64, rays: Rays) -> Selection {
    let metric = GradientMetric::new(recovery.scene(), recovery.ids());
    let work = Work::new(recovery);
    let mut evaluator = Evaluator::new(recovery);
    let trials = match rays {
        Rays::Given => {
            trials::trials(&mut evaluator, &metric, &work, recovery.render_settings().sampling)
        }
        Rays::Chosen { sampler, most } => {
            rays::trials_with_rays(&mut evaluator, &metric, &work, (sampler, most), accuracy)
        }
    };
    let within = trials.iter().filter(|trial| trial.error <= accuracy);
    let cheapest = within.min_by(|a, b| a.work.total_cmp(&b.work));
    let best = cheapest.or(most_accurate(&trials)).expect("there is always a setting").clone();
    Selection { accuracy, best, trials }
}

fn most_accurate(trials: &[Trial]) -> Option<&Trial> {
    trials.iter().min_by(|a, b| a.error.total_cmp(&b.error))
}

impl fmt::Display for Setting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { arithmetic, bounces, sampling } = self;
        let rays = sampling.count();
        let plural = |count: u32| if count == 1 { "" } else { "s" };
        write!(
            f,
            "{}, {bounces} bounce{}, {rays} ray{} per pixel",
            arithmetic.name(),
            plural(*bounces),
            plural(rays)
        )
    }
}

/// What was selected and why, one line for each setting that was tried.
impl fmt::Display for Selection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { accuracy, best, trials } = self;
        match self.is_within() {
            true => writeln!(
                f,
                "accuracy {accuracy:e}: {}, the cheapest within it (estimated error {:.1e})",
                best.setting, best.error
            )?,
            false => writeln!(
                f,
                "accuracy {accuracy:e} cannot be met: {} is the most accurate (estimated error {:.1e})",
                best.setting, best.error
            )?,
        }
        for (index, Trial { setting, error, work }) in trials.iter().enumerate() {
            let end = if index + 1 < trials.len() { "\n" } else { "" };
            let relative = work / best.work;
            write!(
                f,
                "  {:<38} error {error:>8.1e}  work {relative:>5.2}{end}",
                setting.to_string()
            )?;
        }
        Ok(())
    }
}
