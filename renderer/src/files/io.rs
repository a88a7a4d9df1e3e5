//! Whole files, read with a clear error.

use std::fs;
use std::io::ErrorKind;
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
    let bytes = read(path)?;
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        return Err(Error::new(path.display(), "is text in UTF-16; save it as UTF-8"));
    }
    let text = String::from_utf8(bytes)
        .unwrap_or_else(|error| String::from_utf8_lossy(error.as_bytes()).into_owned());
    Ok(match text.strip_prefix('\u{feff}') {
        Some(rest) => rest.to_owned(),
        None => text,
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
    fn missing_files_and_directories_are_told_apart() {
        let folder = tempfile::tempdir().unwrap();
        assert_eq!(read(&folder.path().join("x")).unwrap_err().problem, "no such file");
        assert_eq!(read(folder.path()).unwrap_err().problem, "is a directory, not a file");
    }
}
