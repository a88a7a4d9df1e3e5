//! When and why an optimisation stops.

use serde::{Deserialize, Serialize};

use super::{Evaluation, Record, Settings, Variable};
use crate::variable::element_path;

/// Why an optimisation stopped. Serialises to a string in snake case.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum StopReason {
    /// The loss reached the tolerance.
    Tolerance,
    /// The norm of the gradient reached the gradient tolerance: a minimum, or a plateau.
    GradientTolerance,
    /// All the iterations that were asked for are done.
    Iterations,
    /// A line search found no lower loss: a minimum, as far as the precision of the loss tells, or
    /// an edge or the noise of it.
    LineSearch,
    /// The loss was infinite or not a number.
    NonFiniteLoss,
    /// An element of the gradient was infinite or not a number.
    NonFiniteGradient,
    /// The observer asked for it. The run is not finished: it can be resumed.
    Interrupted,
}

impl StopReason {
    /// Whether there was nothing to go on with: a loss or a gradient was not finite.
    pub fn is_failure(self) -> bool {
        matches!(self, Self::NonFiniteLoss | Self::NonFiniteGradient)
    }
}

/// How an optimisation stopped.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Stop {
    /// Why.
    pub reason: StopReason,
    /// The reason in words for people, with the figures.
    pub detail: String,
}

impl Stop {
    /// The criterion of `settings` that the latest of some iterations of one level meets.
    pub(super) fn at(history: &[Record], settings: &Settings) -> Option<Self> {
        let iteration = history.last()?.iteration;
        let epoch = history.len().checked_sub(settings.epoch.max(1)).map(|start| &history[start..]);
        let mean = |of: fn(&Record) -> f64| {
            let mean = |epoch: &[Record]| epoch.iter().map(of).sum::<f64>() / epoch.len() as f64;
            epoch.map_or(f64::INFINITY, mean)
        };
        let loss = mean(|record| record.loss);
        let gradient_norm = mean(|record| record.gradient_norm);
        let (reason, detail) = if loss <= settings.tolerance {
            let detail =
                format!("the loss {loss:.4e} reached the tolerance {}", settings.tolerance);
            (StopReason::Tolerance, detail)
        } else if gradient_norm <= settings.gradient_tolerance {
            let tolerance = settings.gradient_tolerance;
            let detail = if gradient_norm == 0.0 {
                "the gradient vanished: within its bounds, no parameter changes the loss here"
                    .to_owned()
            } else {
                format!("the gradient norm {gradient_norm:.4e} reached the tolerance {tolerance}")
            };
            (StopReason::GradientTolerance, detail)
        } else if iteration >= settings.iterations {
            (StopReason::Iterations, format!("all {} iterations are done", settings.iterations))
        } else {
            return None;
        };
        Some(Self { reason, detail })
    }

    /// What makes an evaluation unusable, if it is.
    pub(super) fn at_non_finite(
        evaluation: &Evaluation,
        iteration: u64,
        variables: &[Variable],
    ) -> Option<Self> {
        if !evaluation.loss.is_finite() {
            let detail = format!("the loss is {} at iteration {iteration}", evaluation.loss);
            return Some(Self { reason: StopReason::NonFiniteLoss, detail });
        }
        let index = evaluation.gradient.iter().position(|g| !g.is_finite())?;
        let path = element_path(variables, index);
        let value = evaluation.gradient[index];
        let detail = format!("the gradient of {path} is {value} at iteration {iteration}");
        Some(Self { reason: StopReason::NonFiniteGradient, detail })
    }

    /// With what is behind it, if that is known.
    pub(super) fn explained(self, why: Option<String>) -> Self {
        let Self { reason, detail } = self;
        let detail = why.map_or(detail.clone(), |why| format!("{detail}: {why}"));
        Self { reason, detail }
    }

    pub(super) fn line_search(iteration: u64, why: &str) -> Self {
        let detail = format!("iteration {iteration} finds no lower loss: {why}");
        Self { reason: StopReason::LineSearch, detail }
    }

    pub(super) fn interrupted(iteration: u64) -> Self {
        let detail = format!("interrupted after iteration {iteration}");
        Self { reason: StopReason::Interrupted, detail }
    }
}
