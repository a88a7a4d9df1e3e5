//! A run as the page sees it.

use std::ops::ControlFlow;
use std::sync::Arc;

use super::state::State;
use crate::cli::interrupt::Interrupt;
use crate::optimize::{Observer, Outcome, Start, Step, Topology};

/// Watches a run for another observer, and lets the page see and steer it.
pub(in crate::cli) struct Watched {
    pub observer: Box<dyn Observer>,
    pub state: Arc<State>,
    /// Ends pauses, too.
    pub interrupt: Interrupt,
}

impl Observer for Watched {
    fn start(&mut self, start: Start) {
        self.observer.start(start);
    }

    fn changed(&mut self, topologies: &[Topology]) {
        self.observer.changed(topologies);
        self.state.change(topologies);
    }

    fn parameters(&mut self, x: &[f64]) {
        self.state.move_to(x);
    }

    fn step(&mut self, step: &Step) -> ControlFlow<()> {
        self.observer.step(step)?;
        self.state.record(step, || self.interrupt.flow().is_continue())
    }

    fn learning_rate_factor(&mut self) -> Option<f64> {
        self.state.take_factor()
    }

    fn finish(&mut self, outcome: &Outcome) {
        self.state.finish(&outcome.stop);
        self.observer.finish(outcome);
    }
}
