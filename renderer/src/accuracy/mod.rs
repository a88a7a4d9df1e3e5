//! The accuracy dial: the cheapest settings whose gradient is as accurate as asked.
//!
//! [`pick`] tries settings on the scene itself and takes the one with the least [work](Pilot::work)
//! whose estimated error stays within the accuracy that is asked for. If none does, it takes the most
//! accurate one and says so ([`Pick::is_within`]).
//!
//! The error is that of the whole gradient ([`GradientMetric`]), relative to the gradient in double
//! precision with all mirrors that the scene asks for. What every setting shares it does not see:
//! which primitive a ray meets is always decided in single precision, and silhouettes and shadow
//! edges that move are missing from every gradient
//! ([`Differentiability`](crate::scene::Differentiability)).
//!
//! Work is counted, not timed: rays and shaded points, weighted by what the scalar costs. So the same
//! scene always gets the same settings, and an optimisation that is resumed goes on with those it
//! began with. Turned down: the time of the pilots, which another program on the machine changes.

mod metric;
mod pilots;
#[cfg(all(test, feature = "cli"))]
mod tests;

use std::fmt;

pub use metric::GradientMetric;
#[cfg(feature = "cli")]
pub(crate) use metric::image_error;

use crate::arithmetic::Arithmetic;
use crate::integrator::RenderSettings;
use crate::recovery::Recovery;

/// What a gradient is computed with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Setting {
    /// The scalar of the kernels.
    pub arithmetic: Arithmetic,
    /// How many mirrors light meets at most.
    pub bounces: u32,
}

impl Setting {
    /// The same problem, with the same target, in this setting.
    pub fn apply<'a>(&self, recovery: &Recovery<'a>) -> Recovery<'a> {
        let settings =
            RenderSettings { bounces: Some(self.bounces), ..*recovery.render_settings() };
        recovery.computed(self.arithmetic, settings)
    }
}

/// A setting that was tried.
#[derive(Clone, Debug, PartialEq)]
pub struct Pilot {
    /// The setting.
    pub setting: Setting,
    /// The estimated relative error of its gradient.
    pub error: f64,
    /// What a gradient costs, in units of one ray from the camera in single precision.
    pub work: f64,
}

/// What was picked, and from what.
#[derive(Clone, Debug, PartialEq)]
pub struct Pick {
    /// The relative error that was asked for.
    pub accuracy: f64,
    /// What was picked.
    pub best: Pilot,
    /// All settings that were tried.
    pub pilots: Vec<Pilot>,
}

impl Pick {
    /// Whether the estimated error is within what was asked for. If it is not, no setting has a
    /// smaller one.
    pub fn is_within(&self) -> bool {
        self.best.error <= self.accuracy
    }
}

/// The cheapest setting whose estimated relative error of the gradient is at most `accuracy`, or the
/// most accurate one if there is none. `recovery` is the problem; its target should have been
/// rendered in double precision, if it is rendered at all.
pub fn pick(recovery: &Recovery<'_>, accuracy: f64) -> Pick {
    let pilots = pilots::pilots(recovery, &GradientMetric::new(recovery.scene(), recovery.ids()));
    let within = pilots.iter().filter(|pilot| pilot.error <= accuracy);
    let cheapest = within.min_by(|a, b| a.work.total_cmp(&b.work));
    let most_accurate = pilots.iter().min_by(|a, b| a.error.total_cmp(&b.error));
    let best = cheapest.or(most_accurate).expect("there is always a setting").clone();
    Pick { accuracy, best, pilots }
}

impl fmt::Display for Setting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, {} bounces", self.arithmetic.name(), self.bounces)
    }
}

/// What was picked and why, one line for each setting that was tried.
impl fmt::Display for Pick {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { accuracy, best, pilots } = self;
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
        for (index, Pilot { setting, error, work }) in pilots.iter().enumerate() {
            let end = if index + 1 < pilots.len() { "\n" } else { "" };
            let relative = work / best.work;
            write!(
                f,
                "  {:<24} error {error:>8.1e}  work {relative:>5.2}{end}",
                setting.to_string()
            )?;
        }
        Ok(())
    }
}
