//! The one error that bad input leads to.

use std::path::Path;
use std::sync::Arc;
use std::{fmt, io};

/// Input that cannot be used. It displays as one line: where, then what is wrong.
///
/// ```
/// use renderer::{Camera, ErrorKind, Scene};
/// use renderer::glam::DVec3;
///
/// let scene = Scene::new(8, 8, Camera::looking(DVec3::Z, DVec3::ZERO));
/// let error = scene.parameter("light.key.color").unwrap_err();
/// assert_eq!((error.kind, error.place.as_str()), (ErrorKind::Input, "light.key.color"));
/// ```
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Error {
    /// What kind of failure it is.
    pub kind: ErrorKind,
    /// The file, and within it the line, field or parameter path.
    pub place: String,
    /// What is wrong there, and where it helps what would be right.
    pub problem: String,
    source: Option<Arc<io::Error>>,
}

/// The kinds of failures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ErrorKind {
    /// A file, a scene or a setting says something that cannot be used.
    Input,
    /// A file cannot be read or written; the [source](std::error::Error::source) is what the operating
    /// system says.
    Io,
    /// An image, a loss or a gradient is infinite or no number.
    NotFinite,
}

impl Error {
    /// Input at `place` that cannot be used. Control characters, which names and broken files may
    /// bring along, are written as escapes, so that it stays one line.
    pub fn new(place: impl ToString, problem: impl ToString) -> Self {
        let (place, problem) = (one_line(place), one_line(problem));
        Self { kind: ErrorKind::Input, place, problem, source: None }
    }

    /// A file that cannot be read or written.
    #[doc(hidden)]
    pub fn io(path: &Path, problem: impl ToString, source: io::Error) -> Self {
        let error = Self::new(path.display(), problem);
        Self { kind: ErrorKind::Io, source: Some(Arc::new(source)), ..error }
    }

    /// Numbers that are not finite.
    #[doc(hidden)]
    pub fn not_finite(place: impl ToString, problem: impl ToString) -> Self {
        Self { kind: ErrorKind::NotFinite, ..Self::new(place, problem) }
    }
}

/// Whatever their sources are.
impl PartialEq for Error {
    fn eq(&self, other: &Self) -> bool {
        (self.kind, &self.place, &self.problem) == (other.kind, &other.place, &other.problem)
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.place, self.problem)
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        self.source.as_deref().map(|source| source as _)
    }
}

/// The most letters of a place or a problem: broken files hold long words.
const MOST: usize = 1000;

/// A text as part of a message: control characters are written as escapes, and what is too long to
/// be read is cut.
#[doc(hidden)]
pub fn one_line(text: impl ToString) -> String {
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
