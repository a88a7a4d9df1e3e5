//! What files hold that is left out, and what they lack.

use std::collections::HashSet;
use std::fmt;

use crate::warning::Warning;

/// So many warnings tell what kind of file it is.
const MOST: usize = 20;

/// The warnings about one file: one for each subject, and not too many.
#[derive(Default)]
pub(super) struct Warnings {
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

    /// In the order of the file.
    pub fn finish(mut self) -> Vec<Warning> {
        if let Some((place, count)) = self.unlisted {
            let problem = format!("{count} more kinds of warnings");
            self.list.push(Warning { place, problem });
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
