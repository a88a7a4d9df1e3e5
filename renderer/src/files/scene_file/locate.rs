//! From a path such as `light.key.position` to the line of the scene file that it comes from.

use std::ops::Range;

use toml::de::{DeArray, DeTable, DeValue};

use crate::scene::Invalid;
use crate::{Error, one_line};

/// What serde calls by the names of Rust, and what people call it.
const NAMES: [(&str, &str); 6] = [
    ("` as i128", "`"),
    ("` as u128", "`"),
    ("expected f64", "expected a number"),
    ("expected u32", "expected a whole number from 0 to 4294967295"),
    ("expected u64", "expected a whole number, 0 or more"),
    ("expected usize", "expected a whole number, 0 or more"),
];

/// Knows where in the text of a scene file things stand.
pub(super) struct Locator<'a> {
    text: &'a str,
    name: &'a str,
}

impl<'a> Locator<'a> {
    /// A locator for the text of the file `name`.
    pub fn new(text: &'a str, name: &'a str) -> Self {
        Self { text, name }
    }

    /// What the TOML parser or serde found.
    pub fn syntax_error(&self, mut error: toml::de::Error) -> Error {
        let span = error.span();
        // Without the text, the error prints its message and then the keys that lead to it.
        error.set_input(None);
        let message = error.to_string();
        let parts: Vec<&str> = message.split('\n').filter(|part| !part.is_empty()).collect();
        let mut problem = parts.join(" ");
        for (name, meaning) in NAMES {
            problem = problem.replace(name, meaning);
        }
        if error.message() == "duplicate key"
            && let Some(key) = span.clone().and_then(|span| self.text.get(span))
        {
            problem = format!("`{key}` is given twice");
        }
        let line = span.map(|span| self.line(span.start));
        Error::new(self.at(line), problem)
    }

    /// What is wrong with the scene.
    pub fn place(&self, Invalid { path, problem }: Invalid) -> Error {
        Error::new(self.field(&path), problem)
    }

    /// The file, the line and the path of a field.
    pub fn field(&self, path: &str) -> String {
        let line = self.span(path).map(|span| self.line(span.start));
        one_line(format!("{}: {path}", self.at(line)))
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
        within_table(document.get_ref(), path)
    }
}

/// Where as much of `path` as there is stands in `table`.
fn within_table(table: &DeTable<'_>, path: &str) -> Option<Range<usize>> {
    // Keys may hold dots and so may begin with another key: the longest wins.
    let matching = table.iter().filter_map(|(key, value)| {
        let key_text: &str = key.get_ref();
        Some((key_text.len(), key.span(), value, after_name(path, key_text)?))
    });
    let (_, span, value, rest) = matching.max_by_key(|(length, ..)| *length)?;
    let inner = match value.get_ref() {
        DeValue::Table(table) => within_table(table, rest),
        DeValue::Array(objects) => within_array(objects, rest),
        _ => None,
    };
    Some(inner.unwrap_or(span))
}

/// Where as much of `path` as there is stands in an array of objects that have names or paths.
fn within_array(objects: &DeArray<'_>, path: &str) -> Option<Range<usize>> {
    let named = objects.iter().filter_map(|object| {
        let table = object.get_ref().as_table()?;
        let name = table.get("name").or_else(|| table.get("path"))?.get_ref().as_str()?;
        Some((name.len(), object.span(), table, after_name(path, name)?))
    });
    // Of several objects of one name, the last is the one to complain about.
    let (_, span, table, rest) = named.max_by_key(|(length, ..)| *length)?;
    Some(within_table(table, rest).unwrap_or(span))
}

/// What follows `name` and a dot at the beginning of `path`.
fn after_name<'a>(path: &'a str, name: &str) -> Option<&'a str> {
    let rest = path.strip_prefix(name)?;
    rest.strip_prefix('.').or(rest.is_empty().then_some(""))
}
