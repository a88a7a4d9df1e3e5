//! Arguments that cannot be used: one line, as for every other bad input.

use std::process::ExitCode;

use clap::error::ErrorKind;

use super::output::{failure, is_silent, print_error};
use crate::Error;

/// Prints what `clap` has to say: help and version as they are, errors in one line.
pub(super) fn explain(error: &clap::Error) -> ExitCode {
    if matches!(error.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion) {
        if !is_silent() {
            // Whoever closed the stream does not want to know.
            let _ = error.print();
        }
        return ExitCode::SUCCESS;
    }
    print_error(&Error::new("arguments", problem(&error.to_string())));
    failure()
}

/// What is wrong and what would be right, without the usage.
fn problem(text: &str) -> String {
    let parts = text.split("\n\n").filter(|part| {
        !part.starts_with("Usage:") && !part.trim_start().starts_with("For more information")
    });
    let words: Vec<&str> = parts.flat_map(str::split_whitespace).collect();
    let line = words.join(" ");
    format!("{} (--help shows all)", line.strip_prefix("error: ").unwrap_or(&line))
}

#[cfg(test)]
mod tests {
    use super::problem;

    #[test]
    fn usage_is_left_out() {
        let text = "error: unexpected argument '--out' found\n\n  tip: a similar argument exists: \
                    '--output'\n\nUsage: renderer render\n\nFor more information, try '--help'.\n";
        assert_eq!(
            problem(text),
            "unexpected argument '--out' found tip: a similar argument exists: '--output' (--help \
             shows all)"
        );
    }
}
