//! Whole optimisations.

mod change;
mod convergence;
#[cfg(feature = "argmin")]
mod lbfgs;
mod levels;
mod resume;
mod samples;
mod scale;
mod validation;

use std::ops::ControlFlow;
use std::path::Path;
use std::time::Duration;

use super::*;

fn quadratic(x: &[f64]) -> Evaluation {
    let loss = x.iter().zip(1..).map(|(x, i)| f64::from(i) * (x - 1.0) * (x - 1.0)).sum();
    let gradient = x.iter().zip(1..).map(|(x, i)| 2.0 * f64::from(i) * (x - 1.0)).collect();
    Evaluation { loss, gradient }
}

fn rosenbrock(x: &[f64]) -> Evaluation {
    let (a, b) = (x[0], x[1]);
    Evaluation {
        loss: (1.0 - a).powi(2) + 100.0 * (b - a * a).powi(2),
        gradient: vec![-2.0 * (1.0 - a) - 400.0 * a * (b - a * a), 200.0 * (b - a * a)],
    }
}

fn iterations(iterations: u64) -> Settings {
    Settings { iterations, ..Settings::default() }
}

/// The methods that make do with a gradient: all but least squares.
fn methods() -> impl Iterator<Item = Optimizer> {
    Optimizer::all().into_iter().filter(|optimizer| !matches!(optimizer, Optimizer::Lm(_)))
}

/// The schedules that a method can have.
fn schedules(optimizer: &Optimizer) -> Vec<Schedule> {
    let mut schedules = Schedule::all().to_vec();
    schedules.truncate(if optimizer.finds_step_lengths() { 1 } else { schedules.len() });
    schedules
}

fn in_folder(folder: &Path, resume: bool, settings: Settings) -> Settings {
    let checkpointing = Checkpointing {
        folder: folder.to_owned(),
        every: Duration::ZERO,
        resume,
        problem: Fingerprint::new().text("a problem"),
    };
    Settings { checkpointing: Some(checkpointing), ..settings }
}

fn run(
    variables: &[Variable],
    settings: &Settings,
    mut objective: impl FnMut(&[f64]) -> Evaluation,
) -> Result<Outcome, renderer_core::Error> {
    Optimization::start(variables, settings)?.run(&mut objective, &mut Quiet)
}

/// Interrupts after the evaluation of one iteration.
struct InterruptAt(u64);

impl Observer for InterruptAt {
    fn step(&mut self, step: &Step) -> ControlFlow<()> {
        if step.record.iteration == self.0 {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }
}
