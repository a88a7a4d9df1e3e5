//! The folder for the results.

use std::fs::{self, DirEntry};
#[cfg(unix)]
use std::fs::{File, TryLockError};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

use super::inputs::is_same;
use super::strip::STRIP_FOLDER;
use super::views::VIEWS_FOLDER;
use crate::Error;
use crate::optimize::CHECKPOINT_FILE;

/// What an optimisation writes, but for [pictures](is_result) of textures and shapes.
const RESULTS: [&str; 14] = [
    "scene.toml",
    "meshes",
    "textures",
    "target.png",
    "initial.png",
    "final.png",
    "difference.png",
    "history.csv",
    "trajectory.json",
    "loss.svg",
    SUMMARY_FILE,
    CHECKPOINT_FILE,
    STRIP_FOLDER,
    VIEWS_FOLDER,
];

/// Whether a file or a folder of this name is one that an optimisation writes.
fn is_result(name: &str) -> bool {
    let is_digit = |c: char| c.is_ascii_digit();
    let is_picture = name.strip_prefix("picture").is_some_and(|rest| rest.starts_with(is_digit));
    is_picture || RESULTS.contains(&name)
}

/// The files in `out` that an optimisation could replace.
fn replaceable(out: &Path) -> Vec<PathBuf> {
    let entries = |folder: &Path| fs::read_dir(folder).into_iter().flatten().flatten();
    let is_meant = |entry: &DirEntry| entry.file_name().to_str().is_some_and(is_result);
    let mut found = Vec::new();
    for path in entries(out).filter(is_meant).map(|entry| entry.path()) {
        match path.is_dir() {
            true => found.extend(entries(&path).map(|entry| entry.path())),
            false => found.push(path),
        }
    }
    found
}

/// Whether the results may go to `out`: it is no file, and none of the `inputs`, files and what names each,
/// would be replaced.
///
/// # Errors
///
/// If not; the place is the file in the way.
pub(super) fn check_out_folder<'a>(
    out: &Path,
    inputs: impl Iterator<Item = (&'a Path, &'a str)>,
) -> Result<(), Error> {
    if out.exists() && !out.is_dir() {
        return Err(Error::new(out.display(), "is a file; the results need a folder"));
    }
    let replaceable = replaceable(out);
    for (input, by) in inputs {
        if let Some(result) = replaceable.iter().find(|result| is_same(input, result)) {
            let problem = format!(
                "would be replaced by the result {}, though {by} names it as an input: choose \
                 another folder with --out",
                result.display()
            );
            return Err(Error::new(input.display(), problem));
        }
    }
    Ok(())
}

/// # Errors
///
/// If `output` is a file of the results in `folder`, links resolved.
pub(super) fn check_no_result(output: &Path, folder: &Path) -> Result<(), Error> {
    match replaceable(folder).iter().any(|result| is_same(output, result)) {
        false => Ok(()),
        true => {
            let problem = "is a result of the run, and would be replaced: choose another name";
            Err(Error::new(output.display(), problem))
        }
    }
}

/// What goes on with a run, and what it writes at its end and [`report`](super::report) reads, but for the
/// scene, which may be read again.
const OF_ONE_RUN: [&str; 7] = [
    CHECKPOINT_FILE,
    SUMMARY_FILE,
    "history.csv",
    "trajectory.json",
    "loss.svg",
    "final.png",
    "difference.png",
];

/// The file that a finished run leaves.
const SUMMARY_FILE: &str = "summary.json";

/// # Errors
///
/// If `out` holds the results of a finished run.
pub(super) fn check_unfinished(out: &Path) -> Result<(), Error> {
    if !out.join(SUMMARY_FILE).exists() {
        return Ok(());
    }
    let problem = "holds the results of a finished run: choose another folder with --out, or replace them \
                   with --overwrite";
    Err(Error::new(out.display(), problem))
}

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
    for name in OF_ONE_RUN {
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
