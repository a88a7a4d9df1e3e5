//! Watching an optimisation.

use std::ops::ControlFlow;

use super::{Outcome, Record, Start};

/// Watches an optimisation while it runs, and may interrupt it.
pub trait Observer {
    /// Before the first evaluation.
    fn start(&mut self, start: Start) {
        let _ = start;
    }

    /// After each iteration. `Break` interrupts: the run writes a checkpoint and returns.
    fn step(&mut self, step: &Step) -> ControlFlow<()>;

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
    /// The loss at the initial parameters; with [levels](super::Settings::coarse_to_fine) that of the finest.
    pub initial_loss: f64,
    /// The number of iterations at the most.
    pub iterations: u64,
}

impl Step {
    /// Loss over initial loss; nothing if the initial loss was 0.
    pub fn loss_ratio(&self) -> Option<f64> {
        (self.initial_loss != 0.0).then(|| self.record.loss / self.initial_loss)
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
