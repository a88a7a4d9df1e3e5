//! Names of objects.

use std::collections::{HashMap, HashSet};
use std::path::Path;

/// Names that are taken.
#[derive(Default)]
pub struct Names {
    taken: HashSet<String>,
    /// For each name that was asked for more than once, the number of the latest one.
    numbers: HashMap<String, u64>,
}

impl Names {
    /// Takes `name`, or the first of `name_2`, `name_3`, ... that is free.
    pub fn take(&mut self, name: String) -> String {
        if self.taken.insert(name.clone()) {
            return name;
        }
        let number = self.numbers.entry(name.clone()).or_insert(1);
        loop {
            *number += 1;
            let numbered = format!("{name}_{number}");
            if self.taken.insert(numbered.clone()) {
                return numbered;
            }
        }
    }
}

impl<'a> FromIterator<&'a str> for Names {
    /// All of them are taken.
    fn from_iter<I: IntoIterator<Item = &'a str>>(names: I) -> Self {
        let taken = names.into_iter().map(str::to_owned).collect();
        Self { taken, numbers: HashMap::new() }
    }
}

/// The name of an object whose file gives none: that of the file.
pub fn file_stem(path: &Path) -> String {
    let stem = path.file_stem().map(|stem| clean_name(&stem.to_string_lossy()));
    stem.filter(|stem| !stem.is_empty()).unwrap_or_else(|| "mesh".to_owned())
}

/// Names of files for objects of these names, which may hold what those may not, or differ only in case.
pub fn file_stems<'a>(names: impl Iterator<Item = &'a str>) -> Vec<String> {
    let allowed = |c: char| if c.is_alphanumeric() || "-_".contains(c) { c } else { '_' };
    let mut stems = Names::default();
    let stem = |name: &str| name.chars().map(allowed).collect::<String>().to_lowercase();
    names.map(|name| stems.take(stem(name))).collect()
}

/// A name without what names may not hold: control characters, spaces at the ends. It may be
/// empty.
pub fn clean_name(name: &str) -> String {
    name.replace(char::is_control, "_").trim().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_names_are_numbered() {
        let mut names: Names = ["b_2"].into_iter().collect();
        let given = ["a", "b", "a", "b", "a_2", "a"].map(|name| names.take(name.to_owned()));
        assert_eq!(given, ["a", "b", "a_2", "b_3", "a_2_2", "a_3"]);
    }
}
