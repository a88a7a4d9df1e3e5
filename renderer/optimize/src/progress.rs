//! Progress on the terminal or in a log.

use std::io::{self, IsTerminal, Write};
use std::ops::ControlFlow;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::{Observer, Outcome, Record, Start, Step};

/// Seconds between two lines in a log.
const LINE_INTERVAL: f64 = 2.0;

/// Shows progress on the standard error stream: a bar on a terminal, plain lines elsewhere.
pub fn progress() -> Box<dyn Observer> {
    if io::stderr().is_terminal() {
        Box::new(Bar::new())
    } else {
        Box::new(Lines::new(io::stderr()))
    }
}

/// A progress bar on the standard error stream: iteration, loss, loss over initial loss, time left.
pub struct Bar {
    bar: ProgressBar,
    started: bool,
}

impl Default for Bar {
    fn default() -> Self {
        Self::new()
    }
}

impl Bar {
    /// A bar that appears with the first iteration, and makes room for a line at the end.
    pub fn new() -> Self {
        Self::on(ProgressDrawTarget::stderr())
    }

    fn on(target: ProgressDrawTarget) -> Self {
        let bar = ProgressBar::with_draw_target(None, target);
        // Short enough for 80 columns.
        let template = "{bar:20} {pos}/{len}  {msg}  {elapsed} spent, {eta} left";
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style);
        }
        Self { bar, started: false }
    }
}

impl Observer for Bar {
    fn start(&mut self, start: Start) {
        if let Some(line) = describe(start) {
            eprintln!("{line}");
        }
    }

    fn step(&mut self, step: &Step) -> ControlFlow<()> {
        if !self.started {
            // The time left is estimated from the iterations of this process alone.
            self.bar.set_length(step.iterations);
            self.bar.set_position(step.record.iteration);
            self.bar.reset_eta();
            self.started = true;
        }
        self.bar.set_message(losses(step));
        self.bar.set_position(step.record.iteration);
        ControlFlow::Continue(())
    }

    fn finish(&mut self, outcome: &Outcome) {
        self.bar.finish_and_clear();
        eprintln!("{}", conclusion(outcome));
    }
}

/// Plain lines: the first and the last iteration, and one about every two seconds between them.
pub struct Lines<W: Write> {
    out: W,
    first: Option<Record>,
    /// The latest iteration that got a line.
    shown: Option<Record>,
    latest: Option<Step>,
}

impl<W: Write> Lines<W> {
    /// Lines written to `out`. A line that cannot be written is lost; the optimisation goes on.
    pub fn new(out: W) -> Self {
        Self { out, first: None, shown: None, latest: None }
    }

    fn show(&mut self, step: &Step, first: Record) {
        let Step { record, iterations, .. } = *step;
        let done = record.iteration - first.iteration;
        let left = if done > 0 && record.iteration < iterations {
            let per_iteration = (record.seconds - first.seconds) / done as f64;
            let remaining = iterations.saturating_sub(record.iteration) as f64;
            format!(", {:.0} s left", per_iteration * remaining)
        } else {
            String::new()
        };
        let losses = losses(step);
        self.line(format_args!(
            "iteration {}/{iterations}  {losses}  {:.1} s spent{left}",
            record.iteration, record.seconds
        ));
        self.shown = Some(record);
    }

    fn line(&mut self, line: std::fmt::Arguments) {
        let _ = writeln!(self.out, "{line}");
    }
}

impl<W: Write> Observer for Lines<W> {
    fn start(&mut self, start: Start) {
        if let Some(line) = describe(start) {
            self.line(format_args!("{line}"));
        }
    }

    fn step(&mut self, step: &Step) -> ControlFlow<()> {
        let first = *self.first.get_or_insert(step.record);
        let due =
            self.shown.is_none_or(|shown| step.record.seconds - shown.seconds >= LINE_INTERVAL);
        if due {
            self.show(step, first);
        }
        self.latest = Some(*step);
        ControlFlow::Continue(())
    }

    fn finish(&mut self, outcome: &Outcome) {
        if let (Some(latest), Some(first)) = (self.latest, self.first)
            && self.shown != Some(latest.record)
        {
            self.show(&latest, first);
        }
        self.line(format_args!("{}", conclusion(outcome)));
    }
}

fn losses(step: &Step) -> String {
    let loss = step.record.loss;
    match step.loss_ratio() {
        Some(ratio) => format!("loss {loss:.4e}  ratio {ratio:.3e}"),
        None if step.level > 0 => format!("coarse loss {loss:.4e}"),
        None => format!("loss {loss:.4e}"),
    }
}

fn describe(start: Start) -> Option<String> {
    match start {
        Start::Fresh => None,
        Start::Resumed { iteration } => Some(format!("resumed at iteration {iteration}")),
        Start::Finished { iteration } => {
            Some(format!("the run was already finished, at iteration {iteration}"))
        }
    }
}

fn conclusion(outcome: &Outcome) -> String {
    let Outcome { best, stop, seconds, .. } = outcome;
    format!(
        "stopped after {seconds:.1} s: {}; result of loss {:.4e} at iteration {}",
        stop.detail, best.loss, best.iteration
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Point, Stop, StopReason};

    fn step(iteration: u64, seconds: f64) -> Step {
        let record = Record { iteration, loss: 0.5, gradient_norm: 1.0, seconds };
        Step { record, level: 0, initial_loss: 2.0, iterations: 100, learning_rate_factor: 1.0 }
    }

    fn outcome() -> Outcome {
        let best = Point { iteration: 4, loss: 0.25, x: vec![1.0] };
        let stop = Stop { reason: StopReason::Iterations, detail: "all done".to_owned() };
        let (last, history) = (best.clone(), vec![step(0, 0.0).record]);
        Outcome {
            best,
            last,
            history,
            trajectory: vec![],
            stop,
            topologies: vec![],
            initial_loss: 0.5,
            evaluations: 1,
            seconds: 5.0,
            start: Start::Fresh,
        }
    }

    #[test]
    fn lines_come_first_then_every_two_seconds_then_last() {
        let mut out = Vec::new();
        let mut lines = Lines::new(&mut out);
        lines.start(Start::Resumed { iteration: 50 });
        for i in 0..6 {
            assert!(lines.step(&step(50 + i, 10.0 + 0.5 * i as f64)).is_continue());
        }
        lines.finish(&outcome());
        let text = String::from_utf8(out).unwrap();
        let starts: Vec<&str> = text.lines().filter_map(|line| line.split("  ").next()).collect();
        assert_eq!(
            starts[..4],
            ["resumed at iteration 50", "iteration 50/100", "iteration 54/100", "iteration 55/100",]
        );
        assert_eq!(starts.len(), 5, "{text}");
        assert!(text.contains("loss 5.0000e-1  ratio 2.500e-1  12.0 s spent, 23 s left"), "{text}");
        assert!(text.contains("all done; result of loss 2.5000e-1 at iteration 4"), "{text}");
    }

    #[test]
    fn bar_shows_iteration_and_loss() {
        let mut bar = Bar::on(ProgressDrawTarget::hidden());
        bar.start(Start::Fresh);
        let _ = bar.step(&step(7, 1.0));
        assert_eq!((bar.bar.position(), bar.bar.length()), (7, Some(100)));
        assert_eq!(bar.bar.message(), "loss 5.0000e-1  ratio 2.500e-1");
        bar.finish(&outcome());
        assert!(bar.bar.is_finished());
    }
}
