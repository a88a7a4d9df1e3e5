//! The folder for the results.

use std::fs;
#[cfg(unix)]
use std::fs::{File, TryLockError};
use std::io::{self, ErrorKind};
use std::path::Path;

use super::strip::STRIP_FOLDER;
use super::views::VIEWS_FOLDER;
use crate::Error;

/// What an optimisation writes that could also be what it reads.
const RESULTS: [&str; 8] = [
    "scene.toml",
    "meshes",
    "target.png",
    "initial.png",
    "final.png",
    "difference.png",
    STRIP_FOLDER,
    VIEWS_FOLDER,
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
    [SUMMARY_FILE, "history.csv", "trajectory.json", "loss.svg", "final.png", "difference.png"];

/// The file that a finished run leaves.
pub(super) const SUMMARY_FILE: &str = "summary.json";

/// Keeps other runs out of a folder until the file is dropped.
///
/// # Errors
///
/// If another run is in it.
#[cfg(unix)]
pub(super) fn lock(out: &Path) -> Result<File, Error> {
    let cannot = |error: io::Error| Error::io(out, format!("cannot be locked: {error}"), error);
    // The folder itself is locked, so that there is no file to be left behind.
    let folder = File::open(out).map_err(cannot)?;
    match folder.try_lock() {
        Ok(()) => Ok(folder),
        Err(TryLockError::WouldBlock) => {
            Err(Error::new(out.display(), "another run writes into this folder; choose another"))
        }
        // Some network file systems have no locks.
        Err(TryLockError::Error(error)) if error.kind() == ErrorKind::Unsupported => Ok(folder),
        Err(TryLockError::Error(error)) => Err(cannot(error)),
    }
}

/// Only Unix opens folders as files.
#[cfg(not(unix))]
pub(super) fn lock(_: &Path) -> Result<(), Error> {
    Ok(())
}

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
