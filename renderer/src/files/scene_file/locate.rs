//! From a path such as `light.key.position` to the line of the scene file that it comes from.

use std::ops::Range;

use toml::de::{DeTable, DeValue};

use crate::Error;
use crate::scene::Invalid;

/// Knows where in the text of a scene file things stand.
pub(super) struct Locator<'a> {
    text: &'a str,
    name: &'a str,
}

impl<'a> Locator<'a> {
    /// For the text of the file `name`.
    pub fn new(text: &'a str, name: &'a str) -> Self {
        Self { text, name }
    }

    /// What the TOML parser or serde found.
    pub fn syntax_error(&self, mut error: toml::de::Error) -> Error {
        let line = error.span().map(|span| self.line(span.start));
        // Without the text, the error prints its message and then the keys that lead to it.
        error.set_input(None);
        let message = error.to_string();
        let problem = message.split('\n').filter(|part| !part.is_empty()).collect::<Vec<_>>();
        Error::new(self.at(line), problem.join(" "))
    }

    /// What is wrong with the scene.
    pub fn place(&self, Invalid { path, problem }: Invalid) -> Error {
        let line = self.span(&path).map(|span| self.line(span.start));
        Error::new(format!("{}: {path}", self.at(line)), problem)
    }

    fn at(&self, line: Option<usize>) -> String {
        match line {
            Some(line) => format!("{}:{line}", self.name),
            None => self.name.to_owned(),
        }
    }

    /// The line, counted from 1, of a byte of the text.
    fn line(&self, byte: usize) -> usize {
        1 + self.text.bytes().take(byte).filter(|&b| b == b'\n').count()
    }

    /// Where the closest thing to `path` stands that the file mentions.
    fn span(&self, path: &str) -> Option<Range<usize>> {
        let document = DeTable::parse(self.text).ok()?;
        let (kind, rest) = path.split_once('.').unwrap_or((path, ""));
        let (key, value) = document.get_ref().get_key_value(kind)?;
        let object = match value.get_ref() {
            DeValue::Array(objects) => {
                // An object's name may hold dots and so may begin with another's: the longest wins.
                let named = objects.iter().filter_map(|object| {
                    let table = object.get_ref().as_table()?;
                    let name = table.get("name").or_else(|| table.get("path"))?.get_ref().as_str()?;
                    let rest = rest.strip_prefix(name)?;
                    let field = rest.strip_prefix('.').or(rest.is_empty().then_some(""))?;
                    Some((name.len(), table, object.span(), field))
                });
                let (_, table, span, field) = named.max_by_key(|(length, ..)| *length)?;
                return Some(field_span(table, field).unwrap_or(span));
            }
            DeValue::Table(table) => table,
            _ => return Some(key.span()),
        };
        Some(field_span(object, rest).unwrap_or(key.span()))
    }
}

/// Where the field `rest` of `table` stands, or as much of it as there is.
fn field_span(table: &DeTable<'_>, rest: &str) -> Option<Range<usize>> {
    // Keys may hold dots themselves, as those of `[optimize.target_values]` do.
    let matching = table.iter().filter_map(|(key, value)| {
        let rest = rest.strip_prefix(key.get_ref().as_ref())?;
        let field = rest.strip_prefix('.').or(rest.is_empty().then_some(""))?;
        Some((key, value, field))
    });
    let (key, value, field) = matching.max_by_key(|(key, ..)| key.get_ref().len())?;
    let inner = value.get_ref().as_table().and_then(|table| field_span(table, field));
    Some(inner.unwrap_or(key.span()))
}
