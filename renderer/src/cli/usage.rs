//! Arguments that cannot be used: one line, as for every other bad input.

use std::process::ExitCode;

use clap::error::ErrorKind;
use clap::{Arg, Command};

use super::output::{failure, is_silent, print_error};
use crate::Error;

/// A command and its subcommands with numbers below 0 as values of options: what is wrong with one is for its
/// option to say.
pub(super) fn with_negative_numbers(command: Command) -> Command {
    let is_option =
        |argument: &Arg| argument.get_action().takes_values() && !argument.is_positional();
    command
        .mut_args(|argument| match is_option(&argument) {
            true => argument.allow_negative_numbers(true),
            false => argument,
        })
        .mut_subcommands(with_negative_numbers)
}

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
