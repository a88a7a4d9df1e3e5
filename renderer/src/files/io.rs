//! Whole files: read with a clear error, written atomically.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, ErrorKind, Write};
use std::path::Path;

use crate::Error;

/// The bytes of a file.
pub(super) fn read(path: &Path) -> Result<Vec<u8>, Error> {
    if path.is_dir() {
        return Err(Error::new(path.display(), "is a directory, not a file"));
    }
    fs::read(path).map_err(|error| {
        let problem = match error.kind() {
            ErrorKind::NotFound => "no such file".to_owned(),
            _ => format!("cannot be read: {error}"),
        };
        Error::new(path.display(), problem)
    })
}

/// The text of a file, without the byte order mark that some editors put first.
///
/// Bytes that are not UTF-8 are replaced: they stand in comments and names of old files, which
/// should not make a mesh unreadable.
pub(super) fn read_text(path: &Path) -> Result<String, Error> {
    let text = String::from_utf8_lossy(&read(path)?).into_owned();
    Ok(match text.strip_prefix('\u{feff}') {
        Some(rest) => rest.to_owned(),
        None => text,
    })
}

/// Writes a file such that at any moment, even if the process is killed, `path` holds either what
/// it held before or all of `bytes`.
///
/// The bytes go to a hidden file beside `path` (`.NAME.partial`), which then takes its name.
///
/// # Errors
///
/// If the folder does not exist, or the file cannot be written. The hidden file is then removed.
pub fn write_atomically(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    let refuse = |problem: String| Error::new(path.display(), problem);
    let Some(name) = path.file_name() else {
        return Err(refuse("does not name a file".to_owned()));
    };
    if path.is_dir() {
        return Err(refuse("is a directory, not a file".to_owned()));
    }
    let mut partial_name = OsString::from(".");
    partial_name.push(name);
    partial_name.push(".partial");
    let partial = path.with_file_name(partial_name);

    let write = || -> io::Result<()> {
        let mut file = File::create(&partial)?;
        file.write_all(bytes)?;
        file.sync_all()?;
        drop(file);
        fs::rename(&partial, path)
    };
    write().map_err(|error| {
        // The file may not even exist; the first error is the one to report.
        let _ = fs::remove_file(&partial);
        match error.kind() {
            ErrorKind::NotFound => refuse("the folder to write it to does not exist".to_owned()),
            _ => refuse(format!("cannot be written: {error}")),
        }
    })
}

/// Makes a folder and those above it.
pub(super) fn create_folder(path: &Path) -> Result<(), Error> {
    fs::create_dir_all(path)
        .map_err(|error| Error::new(path.display(), format!("cannot be created: {error}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_write_replaces_the_file_and_leaves_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        write_atomically(&path, b"one").unwrap();
        write_atomically(&path, b"two").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"two");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn a_failed_write_leaves_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let taken = folder.path().join("taken");
        fs::create_dir(&taken).unwrap();
        let error = write_atomically(&taken, b"one").unwrap_err();
        assert!(error.to_string().ends_with("taken: is a directory, not a file"), "{error}");
        let error = write_atomically(&folder.path().join("no/a.txt"), b"one").unwrap_err();
        assert!(error.problem.contains("folder"), "{error}");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn missing_files_and_directories_are_told_apart() {
        let folder = tempfile::tempdir().unwrap();
        assert_eq!(read(&folder.path().join("x")).unwrap_err().problem, "no such file");
        assert_eq!(read(folder.path()).unwrap_err().problem, "is a directory, not a file");
    }
}
