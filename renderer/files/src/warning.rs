//! What is not used of an input, and what stands in for something missing.

use std::collections::HashSet;
use std::fmt;

use renderer_core::one_line;

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
    /// Whether it is of [radiance](renderer_core::Pass::Radiance) alone: other passes show the same without it.
    pub is_of_radiance: bool,
}

impl Warning {
    #[doc(hidden)]
    pub fn new(place: impl fmt::Display, problem: impl fmt::Display) -> Self {
        Self { place: one_line(place), problem: one_line(problem), is_of_radiance: false }
    }

    #[doc(hidden)]
    pub fn of_radiance(self) -> Self {
        Self { is_of_radiance: true, ..self }
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.place, self.problem)
    }
}

/// So many warnings tell what kind of file it is.
const MOST: usize = 20;

/// The warnings about one file: one for each subject, and not too many.
#[derive(Default)]
pub struct Warnings {
    list: Vec<Warning>,
    subjects: HashSet<String>,
    /// Where the first one stands that is not listed, and how many there are.
    unlisted: Option<(String, usize)>,
}

impl Warnings {
    /// Warns about `subject`, a kind of statement, where it first stands.
    pub fn add(&mut self, subject: &str, place: impl fmt::Display, problem: impl fmt::Display) {
        if self.subjects.contains(subject) {
            return;
        }
        self.subjects.insert(subject.to_owned());
        self.push(Warning::new(place, problem));
    }

    /// Adds a warning, unless it has been given.
    pub fn add_new(&mut self, warning: &Warning) {
        if self.subjects.insert(warning.to_string()) {
            self.push(warning.clone());
        }
    }

    fn push(&mut self, warning: Warning) {
        if self.list.len() < MOST {
            self.list.push(warning);
        } else {
            self.unlisted.get_or_insert((warning.place, 0)).1 += 1;
        }
    }

    /// The warnings, in the order of the file.
    pub fn finish(mut self) -> Vec<Warning> {
        if let Some((place, count)) = self.unlisted {
            let problem = format!("{count} more kinds of warnings");
            self.list.push(Warning::new(place, problem));
        }
        self.list
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_subject_is_told_once_and_not_too_many() {
        let mut warnings = Warnings::default();
        for line in 0..100 {
            warnings.add(&format!("s{}", line % 30), format_args!("a:{line}"), "a\nb");
        }
        let list = warnings.finish();
        assert_eq!(list.len(), MOST + 1);
        assert_eq!(list[1].to_string(), "a:1: a\\nb");
        assert_eq!(list[MOST].to_string(), "a:20: 10 more kinds of warnings");
    }
}
