//! The one error that bad input leads to.

use std::fmt;

/// Input that cannot be used. Displays as one line: where, then what is wrong.
#[derive(Clone, Debug, PartialEq)]
pub struct Error {
    /// The file, and within it the line, field or parameter path.
    pub place: String,
    /// What is wrong there, and where it helps what would be right.
    pub problem: String,
}

impl Error {
    /// An error at `place`. Control characters, which names and broken files may bring along, are
    /// written as escapes, so that it stays one line.
    pub fn new(place: impl ToString, problem: impl ToString) -> Self {
        Self { place: one_line(place), problem: one_line(problem) }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.place, self.problem)
    }
}

impl std::error::Error for Error {}

/// The most letters of a place or a problem: broken files hold long words.
const MOST: usize = 1000;

/// A text as part of a message: control characters are written as escapes, and what is too long to
/// be read is cut.
pub(crate) fn one_line(text: impl ToString) -> String {
    let text = text.to_string();
    if text.len() <= MOST && !text.contains(char::is_control) {
        return text;
    }
    let escape =
        |c: char| if c.is_control() { c.escape_default().collect() } else { c.to_string() };
    let mut line: String = text.chars().take(MOST).map(escape).collect();
    if text.chars().nth(MOST).is_some() {
        line.push_str(" ...");
    }
    line
}

#[cfg(test)]
mod tests {
    use super::Error;

    #[test]
    fn every_error_is_one_line() {
        let error = Error::new("a\nb.obj", "`\u{1b}[31m\r` is no täxt");
        assert_eq!(error.to_string(), "a\\nb.obj: `\\u{1b}[31m\\r` is no täxt");
        let long = Error::new("a.obj", "ä".repeat(2000)).problem;
        assert!(long.ends_with("ä ...") && long.chars().count() == 1004, "{long}");
    }
}
