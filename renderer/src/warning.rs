//! What is not used of an input, and what stands in for something missing.

use std::fmt;

use crate::one_line;

/// A part of a file that is left out, because nothing here shows it, or that something else stands in
/// for, because it is missing. Displays as one line: where, then what.
///
/// Loaders return warnings as values, with what they load: who asks for a file decides whether to
/// print them. A logger for the whole process was turned down, which would decide that for every
/// program, and could not tell one file's warnings from another's.
#[derive(Clone, Debug, PartialEq)]
pub struct Warning {
    /// The file, and within it the line or the part of the document.
    pub place: String,
    /// What is left out or missing, and where it helps what to do.
    pub problem: String,
}

impl Warning {
    pub(crate) fn new(place: impl fmt::Display, problem: impl fmt::Display) -> Self {
        Self { place: one_line(place), problem: one_line(problem) }
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.place, self.problem)
    }
}
