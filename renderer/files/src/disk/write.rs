//! Files and folders, written.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use renderer_core::Error;

/// Writes `bytes` to `path` such that, killed or out of power at any moment, the file holds either
/// all of them or what it held before.
///
/// The bytes go to a hidden file in the same folder (`.NAME.partial`), reach the disk, and take the
/// name of `path` by a rename. What a killed process left of a hidden file is overwritten by the
/// next write. Two writers must not write the same path at once.
///
/// # Errors
///
/// If the file cannot be written; the place is `path`. Nothing of the attempt is left.
pub fn write_atomically(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    check_writable(path)?;
    // A link goes on to point where it pointed; what it points to is replaced.
    let place = match fs::symlink_metadata(path) {
        Ok(found) if found.is_symlink() => fs::canonicalize(path).unwrap_or(path.to_owned()),
        _ => path.to_owned(),
    };
    replace(&place, bytes)
        .map_err(|error| Error::io(path, format!("cannot be written: {error}"), error))
}

/// Writes files that were not there, in their order: all of them, or, where one cannot be written, none.
///
/// # Errors
///
/// If a file is there, or cannot be written; the place is that file.
pub fn write_together(files: &[(PathBuf, Vec<u8>)]) -> Result<(), Error> {
    if let Some((path, _)) = files.iter().find(|(path, _)| path.exists()) {
        let problem = "exists, and would be replaced: choose another name, or remove it";
        return Err(Error::new(path.display(), problem));
    }
    let write = |(place, (path, bytes)): (usize, &(PathBuf, Vec<u8>))| {
        write_atomically(path, bytes).inspect_err(|_| {
            // The first failure is the one to report.
            files[..place].iter().for_each(|(path, _)| drop(fs::remove_file(path)));
        })
    };
    files.iter().enumerate().try_for_each(write)
}

/// Makes a folder and those above it.
pub fn create_folder(path: &Path) -> Result<(), Error> {
    fs::create_dir_all(path)
        .map_err(|error| Error::io(path, format!("the folder cannot be made: {error}"), error))
}

/// Whether there may be a file at `path`: the folder exists, and `path` is none itself.
///
/// # Errors
///
/// If not; the place is `path`.
pub fn check_writable(path: &Path) -> Result<(), Error> {
    if path.is_dir() {
        return Err(Error::new(path.display(), "is a directory, not a file"));
    }
    if !folder_of(path).is_dir() {
        return Err(Error::new(path.display(), "the folder to write it to does not exist"));
    }
    Ok(())
}

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}

fn replace(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let Some(name) = path.file_name() else {
        return Err(io::Error::new(io::ErrorKind::InvalidInput, "the path names no file"));
    };
    let mut partial = OsString::from(".");
    partial.push(name);
    partial.push(".partial");
    let temporary = path.with_file_name(partial);

    let written = File::create(&temporary)
        .and_then(|mut file| {
            file.write_all(bytes)?;
            file.sync_all()
        })
        .and_then(|()| fs::rename(&temporary, path));
    if written.is_err() {
        // The first failure is the one to report, whether or not there is a file to remove.
        let _ = fs::remove_file(&temporary);
        return written;
    }
    sync_folder(path)
}

/// Makes the rename itself last: on Unix a directory is flushed like a file.
#[cfg(unix)]
fn sync_folder(path: &Path) -> io::Result<()> {
    match File::open(folder_of(path))?.sync_all() {
        // Some network file systems cannot flush a directory; the file itself is in place.
        Err(error) if error.kind() == io::ErrorKind::InvalidInput => Ok(()),
        result => result,
    }
}

#[cfg(not(unix))]
fn sync_folder(_path: &Path) -> io::Result<()> {
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        fs::read_dir(folder)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect()
    }

    #[test]
    fn replaces_the_content_and_leaves_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        write_atomically(&path, b"a long first version").unwrap();
        write_atomically(&path, b"second").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"second");
        assert_eq!(names(folder.path()), ["a.txt"]);
    }

    #[cfg(unix)]
    #[test]
    fn links_are_followed() {
        let folder = tempfile::tempdir().unwrap();
        let (file, link) = (folder.path().join("a.txt"), folder.path().join("b.txt"));
        fs::write(&file, "old").unwrap();
        std::os::unix::fs::symlink(&file, &link).unwrap();
        write_atomically(&link, b"new").unwrap();
        assert_eq!(fs::read(&file).unwrap(), b"new");
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    }

    #[test]
    fn failure_names_the_file_and_leaves_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let occupied = folder.path().join("occupied");
        fs::create_dir(&occupied).unwrap();
        let error = write_atomically(&occupied, b"x").unwrap_err();
        assert_eq!(error.place, occupied.display().to_string());
        assert_eq!(names(folder.path()), ["occupied"]);

        let missing = folder.path().join("missing/a.txt");
        assert!(write_atomically(&missing, b"x").is_err());
        assert!(write_atomically(Path::new("/"), b"x").is_err());
    }

    #[test]
    fn files_are_written_together_or_not_at_all() {
        let folder = tempfile::tempdir().unwrap();
        let file = |name: &str| (folder.path().join(name), name.as_bytes().to_vec());
        let error = write_together(&[file("a"), file("b"), file("missing/c")]).unwrap_err();
        assert_eq!(error.place, folder.path().join("missing/c").display().to_string());
        assert!(names(folder.path()).is_empty());
        write_together(&[file("a"), file("b")]).unwrap();
        let error = write_together(&[file("c"), file("b")]).unwrap_err();
        assert_eq!(error.place, folder.path().join("b").display().to_string());
        let mut left = names(folder.path());
        left.sort();
        assert_eq!(left, ["a", "b"]);
    }
}
