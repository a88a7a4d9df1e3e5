//! Watching an optimisation.

use std::ops::ControlFlow;

use super::{Outcome, Record, Start, Topology};

/// Watches an optimisation while it runs, and may interrupt it.
pub trait Observer {
    /// Before the first evaluation.
    fn start(&mut self, start: Start) {
        let _ = start;
    }

    /// Before the first iteration after what is optimised has [changed](super::Objective::change), or a run was resumed
    /// that had changed before.
    fn changed(&mut self, topologies: &[Topology]) {
        let _ = topologies;
    }

    /// Where the iteration is that [`step`](Self::step) is told of next: the elements of all variables.
    fn parameters(&mut self, x: &[f64]) {
        let _ = x;
    }

    /// After each iteration; the time that it takes is none of the run's. `Break` interrupts: the run writes a checkpoint and returns.
    fn step(&mut self, step: &Step) -> ControlFlow<()>;

    /// What learning rates are multiplied by from the step after this iteration on, beside the
    /// [`Schedule`](super::Schedule), if that is to change. A checkpoint keeps it. Methods that find the lengths
    /// of their steps themselves have no learning rate.
    fn learning_rate_factor(&mut self) -> Option<f64> {
        None
    }

    /// At the end.
    fn finish(&mut self, outcome: &Outcome) {
        let _ = outcome;
    }
}

/// The progress of a run after an iteration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// The iteration.
    pub record: Record,
    /// How many [levels](super::Settings::coarse_to_fine) coarser than the finest its loss is.
    pub level: u32,
    /// The loss at the initial parameters; with [levels](super::Settings::coarse_to_fine) that of the finest.
    pub initial_loss: f64,
    /// The number of iterations at the most.
    pub iterations: u64,
    /// The latest [factor](Observer::learning_rate_factor) on learning rates; 1 if there was none.
    pub learning_rate_factor: f64,
}

impl Step {
    /// Loss over initial loss; nothing if the initial loss was 0, or is of a finer level.
    pub fn loss_ratio(&self) -> Option<f64> {
        (self.level == 0 && self.initial_loss != 0.0).then(|| self.record.loss / self.initial_loss)
    }
}

/// Watches in silence.
#[derive(Clone, Copy, Debug, Default)]
pub struct Quiet;

impl Observer for Quiet {
    fn step(&mut self, _step: &Step) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}
