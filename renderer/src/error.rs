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
        Self { place: escaped(place.to_string()), problem: escaped(problem.to_string()) }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.place, self.problem)
    }
}

impl std::error::Error for Error {}

fn escaped(text: String) -> String {
    if !text.contains(char::is_control) {
        return text;
    }
    let escape =
        |c: char| if c.is_control() { c.escape_default().collect() } else { c.to_string() };
    text.chars().map(escape).collect::<Vec<String>>().concat()
}

#[cfg(test)]
mod tests {
    use super::Error;

    #[test]
    fn every_error_is_one_line() {
        let error = Error::new("a\nb.obj", "`\u{1b}[31m\r` is no täxt");
        assert_eq!(error.to_string(), "a\\nb.obj: `\\u{1b}[31m\\r` is no täxt");
    }
}
