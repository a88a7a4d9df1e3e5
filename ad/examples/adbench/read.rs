//! The published files.

use std::fs;
use std::path::{Path, PathBuf};

/// The inputs in a folder.
pub fn inputs(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder of inputs");
    let paths = entries.map(|entry| entry.expect("a readable folder").path());
    let mut inputs: Vec<_> =
        paths.filter(|path| path.extension().is_some_and(|extension| extension == "txt")).collect();
    inputs.sort();
    inputs
}

/// The numbers of a file, one after the other.
pub struct Numbers(std::vec::IntoIter<f64>);

impl Numbers {
    /// Those of a file, between which stands white space.
    pub fn of_file(path: &Path) -> Self {
        let text = fs::read_to_string(path).expect("a readable input");
        let numbers = text.split_whitespace().map(|word| word.parse().expect("a number"));
        Self(numbers.collect::<Vec<_>>().into_iter())
    }

    /// The next `count`.
    pub fn take(&mut self, count: usize) -> Vec<f64> {
        self.0.by_ref().take(count).collect()
    }

    /// The next `rows` rows of `columns` each.
    pub fn rows(&mut self, rows: usize, columns: usize) -> Vec<Vec<f64>> {
        (0..rows).map(|_| self.take(columns)).collect()
    }

    /// The next `N` as sizes.
    pub fn sizes<const N: usize>(&mut self) -> [usize; N] {
        std::array::from_fn(|_| self.take(1)[0] as usize)
    }
}

/// The number or the numbers that stand at a key of the reference beside an input.
pub fn reference(input: &Path, key: &str) -> Vec<f64> {
    let path = input.with_extension("manual.json");
    let text = fs::read_to_string(path).expect("a reference beside the input");
    let start = text.find(&format!("\"{key}\"")).expect("the key") + key.len() + 3;
    let rest = text[start..].trim_start();
    let end = match rest.starts_with('[') {
        true => rest.find(']').expect("the end of a list"),
        false => rest.find([',', '}']).expect("the end of a number"),
    };
    let numbers = rest[..end].trim_start_matches('[').split(',');
    numbers.map(|number| number.trim().parse().expect("a number")).collect()
}
