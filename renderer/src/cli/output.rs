//! What the commands print.

use std::fmt::Display;
use std::io::{self, ErrorKind, Write};
use std::path::Path;
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

use serde_json::Value;

use crate::Error;
use crate::Warning;
use crate::counts::Counts;

/// Whether another process speaks for this one.
static IS_SILENT: AtomicBool = AtomicBool::new(false);

/// From now on nothing is printed: another process speaks for this one.
pub(super) fn silence() {
    IS_SILENT.store(true, Relaxed);
}

/// What a process ends with that has failed. `mpirun` ends all others as soon as one does: who speaks for them is
/// to say why before.
pub(super) fn failure() -> ExitCode {
    if is_silent() { ExitCode::SUCCESS } else { ExitCode::from(2) }
}

/// Whether nothing is to be printed.
pub(super) fn is_silent() -> bool {
    IS_SILENT.load(Relaxed)
}

/// Writes to the standard error stream.
fn tell(text: impl Display) {
    if !is_silent() {
        // There is nobody left to tell about a failure here.
        let _ = write!(io::stderr().lock(), "{text}");
    }
}

/// Writes a text and a line break to the standard output. Whoever reads it may have heard enough,
/// as `head` does: that is no error.
pub(super) fn print(text: impl Display) -> Result<(), Error> {
    if is_silent() {
        return Ok(());
    }
    match writeln!(io::stdout().lock(), "{text}") {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Error::io(Path::new("standard output"), error.to_string(), error))
        }
        _ => Ok(()),
    }
}

/// One line on the standard error stream.
pub(super) fn print_error(error: &Error) {
    tell(format_args!("error: {error}\n"));
}

/// One line for each warning on the standard error stream.
pub(super) fn print_warnings(warnings: &[Warning]) {
    warnings.iter().for_each(print_warning);
}

/// One line on the standard error stream, about what went on.
pub(super) fn print_warning(warning: impl Display) {
    tell(format_args!("warning: {warning}\n"));
}

/// Prints how much work the process has done so far, beside what the command prints.
pub(super) fn print_stats() {
    tell(Counts::total());
}

/// What a user should know beside the results, on the standard error stream.
pub(super) fn print_note(note: impl Display) {
    tell(format_args!("{note}\n"));
}

/// Numbers as people read them: at most a handful, six digits each.
pub(super) fn abbreviate(values: &[f64]) -> String {
    const MOST: usize = 6;
    let shown: Vec<_> = values.iter().take(MOST).map(|value| short(*value)).collect();
    let more = if values.len() > MOST { ", .." } else { "" };
    match values.len() {
        1 => shown[0].clone(),
        _ => format!("[{}{more}]", shown.join(", ")),
    }
}

/// A number with six significant digits.
pub(super) fn short(value: f64) -> String {
    // An exact zero may carry a sign from the reverse sweep, which means nothing to a reader.
    if value == 0.0 {
        return "0".into();
    }
    let magnitude = value.abs().log10().floor();
    if !(-4.0..7.0).contains(&magnitude) {
        return format!("{value:.5e}");
    }
    let decimals = (5.0 - magnitude).max(0.0) as usize;
    let text = format!("{value:.decimals$}");
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').into(),
        false => text,
    }
}

/// The numbers of a parameter as JSON: a number, a list, or a list of points.
pub(super) fn json_numbers(values: &[f64], shape: &[usize]) -> Value {
    match shape {
        [] => values.first().copied().into(),
        [_] => values.iter().copied().collect(),
        [_, row @ ..] => {
            let width = row.iter().product();
            values.chunks(width).map(|values| json_numbers(values, row)).collect()
        }
    }
}
