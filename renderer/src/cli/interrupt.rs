//! Signals that ask a run to end.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

use signal_hook::consts::signal;
use signal_hook::flag;

use crate::Error;
use crate::optimize::{Observer, Outcome, Start, Step, Topology};

/// What asks a run to end.
const SIGNALS: &[i32] = &[
    signal::SIGINT,
    signal::SIGTERM,
    #[cfg(unix)]
    signal::SIGHUP,
];

/// Whether the process is asked to end.
#[derive(Clone)]
pub(super) struct Interrupt(Arc<AtomicBool>);

impl Interrupt {
    /// From now on a first signal is a wish; a second one ends the process at once.
    pub fn new() -> Result<Self, Error> {
        let asked = Arc::new(AtomicBool::new(false));
        for &signal in SIGNALS {
            // The order counts: at the first signal nobody has asked yet.
            flag::register_conditional_shutdown(signal, 128 + signal, asked.clone())
                .and_then(|_| flag::register(signal, asked.clone()))
                .map_err(|error| Error::new("signals", error))?;
        }
        Ok(Self(asked))
    }

    /// Ends a loop if somebody asked.
    pub fn flow(&self) -> ControlFlow<()> {
        if self.0.load(Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

/// Watches a run for another observer, and interrupts it when the process is asked to end, so that it
/// leaves a checkpoint.
pub(super) struct Interruptible {
    pub observer: Box<dyn Observer>,
    pub interrupt: Interrupt,
}

impl Observer for Interruptible {
    fn start(&mut self, start: Start) {
        self.observer.start(start);
    }

    fn changed(&mut self, topologies: &[Topology]) {
        self.observer.changed(topologies);
    }

    fn parameters(&mut self, x: &[f64]) {
        self.observer.parameters(x);
    }

    fn step(&mut self, step: &Step) -> ControlFlow<()> {
        let go_on = self.observer.step(step);
        if go_on.is_break() { go_on } else { self.interrupt.flow() }
    }

    fn learning_rate_factor(&mut self) -> Option<f64> {
        self.observer.learning_rate_factor()
    }

    fn finish(&mut self, outcome: &Outcome) {
        self.observer.finish(outcome);
    }
}
