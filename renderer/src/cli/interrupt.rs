//! Signals that ask a run to end.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

use signal_hook::consts::signal;
use signal_hook::flag;

use crate::Error;

/// What asks a run to end.
const SIGNALS: &[i32] = &[
    signal::SIGINT,
    signal::SIGTERM,
    #[cfg(unix)]
    signal::SIGHUP,
];

/// Whether the process is asked to end.
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
