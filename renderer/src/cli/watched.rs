//! A run as signals and the page see it.

use std::ops::ControlFlow;
use std::sync::Arc;

use super::interrupt::Interrupt;
use super::live::State;
use crate::optimize::{Observer, Outcome, Start, Step, Topology};

/// Watches a run for another observer, lets the page see and steer it, if there is one, and interrupts it
/// when the process is asked to end, so that it leaves a checkpoint.
pub(super) struct Watched {
    pub observer: Box<dyn Observer>,
    pub page: Option<Arc<State>>,
    /// Ends pauses, too.
    pub interrupt: Interrupt,
}

impl Observer for Watched {
    fn start(&mut self, start: Start) {
        self.observer.start(start);
    }

    fn changed(&mut self, topologies: &[Topology]) {
        self.observer.changed(topologies);
        if let Some(page) = &self.page {
            page.change(topologies);
        }
    }

    fn parameters(&mut self, x: &[f64]) {
        self.observer.parameters(x);
        if let Some(page) = &self.page {
            page.move_to(x);
        }
    }

    fn step(&mut self, step: &Step) -> ControlFlow<()> {
        self.observer.step(step)?;
        if let Some(page) = &self.page {
            page.record(step, || self.interrupt.flow().is_continue())?;
        }
        self.interrupt.flow()
    }

    fn learning_rate_factor(&mut self) -> Option<f64> {
        self.page.as_ref()?.take_factor()
    }

    fn finish(&mut self, outcome: &Outcome) {
        if let Some(page) = &self.page {
            page.finish(&outcome.stop);
        }
        self.observer.finish(outcome);
    }
}
