//! The lines of OBJ and MTL files.

use std::borrow::Cow;

/// A line: a keyword and what follows it.
pub(super) struct Statement<'a> {
    /// Counted from 1.
    pub line: usize,
    pub keyword: &'a str,
    /// Trimmed.
    pub rest: Cow<'a, str>,
}

/// The statements of an OBJ or MTL file, without empty lines and comments. Those that hold numbers
/// may go on over several lines, each but the last of which ends in a backslash; names may end in
/// one.
pub(super) fn statements(text: &str) -> impl Iterator<Item = Statement<'_>> {
    let mut lines = text.lines().map(str::trim).enumerate();
    std::iter::from_fn(move || {
        let (index, first) = lines.find(|(_, line)| !line.is_empty() && !line.starts_with('#'))?;
        let (keyword, rest) = first.split_once(char::is_whitespace).unwrap_or((first, ""));
        let mut rest = Cow::Borrowed(rest.trim());
        while matches!(keyword, "v" | "vt" | "vn" | "f" | "l" | "p") && rest.ends_with('\\') {
            let begun = rest.to_mut();
            begun.pop();
            begun.push(' ');
            begun.push_str(lines.next().map_or("", |(_, line)| line));
        }
        Some(Statement { line: index + 1, keyword, rest })
    })
}

/// The words up to a comment.
pub(super) fn words(rest: &str) -> impl Iterator<Item = &str> {
    rest.split_whitespace().take_while(|word| !word.starts_with('#'))
}

/// A finite number.
pub(super) fn number(word: &str) -> Result<f64, String> {
    match word.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(_) => Err(format!("`{word}` is not a finite number")),
        Err(_) => Err(format!("`{word}` is not a number")),
    }
}
