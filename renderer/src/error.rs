//! The one error that bad input leads to.

/// Input that cannot be used. Displays as one line: where, then what is wrong.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{place}: {problem}")]
pub struct Error {
    /// The file, and within it the line, field or parameter path.
    pub place: String,
    /// What is wrong there, and where it helps what would be right.
    pub problem: String,
}

impl Error {
    /// An error at `place`.
    pub fn new(place: impl ToString, problem: impl ToString) -> Self {
        Self { place: place.to_string(), problem: problem.to_string() }
    }
}
