//! The folder for the results.

use std::fs;
use std::io::ErrorKind;
use std::path::Path;

use super::strip::STRIP_FOLDER;
use crate::Error;

/// What an optimisation writes that could also be what it reads.
const RESULTS: [&str; 7] = [
    "scene.toml",
    "meshes",
    "target.png",
    "initial.png",
    "final.png",
    "difference.png",
    STRIP_FOLDER,
];

/// Whether the results may go to `out`: it is no file, and no file that is read would be replaced.
///
/// # Errors
///
/// If not; the place is the file in the way.
pub(super) fn check_out_folder<'a>(
    out: &Path,
    inputs: impl Iterator<Item = &'a Path>,
) -> Result<(), Error> {
    if out.exists() && !out.is_dir() {
        return Err(Error::new(out.display(), "is a file; the results need a folder"));
    }
    for input in inputs {
        if let Some(result) = RESULTS.iter().find(|result| is_within(input, &out.join(result))) {
            let problem = format!(
                "is read by this run, whose result {result} would replace it; choose another \
                 folder with --out"
            );
            return Err(Error::new(input.display(), problem));
        }
    }
    Ok(())
}

/// What a run writes at its end and [`report`](super::report) reads, but for the scene, which may be
/// read again.
const AT_THE_END: [&str; 6] =
    ["summary.json", "history.csv", "trajectory.json", "loss.svg", "final.png", "difference.png"];

/// Removes what an earlier run has left in `out`: until this one ends, it would be taken for its result.
///
/// # Errors
///
/// If a file cannot be removed.
pub(super) fn remove_earlier_results(out: &Path) -> Result<(), Error> {
    for name in AT_THE_END {
        let path = out.join(name);
        match fs::remove_file(&path) {
            Err(error) if error.kind() != ErrorKind::NotFound => {
                let problem = format!("the result of an earlier run cannot be removed: {error}");
                return Err(Error::new(path.display(), problem));
            }
            _ => {}
        }
    }
    Ok(())
}

/// Whether a path is `other` or inside it, links resolved. What does not exist is nowhere.
fn is_within(path: &Path, other: &Path) -> bool {
    match (path.canonicalize(), other.canonicalize()) {
        (Ok(path), Ok(other)) => path.starts_with(other),
        _ => false,
    }
}
