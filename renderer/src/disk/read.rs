//! Whole files, read.

use std::fs;
use std::io::ErrorKind;
use std::path::Path;

use crate::Error;

/// The bytes of a file.
pub(crate) fn read(path: &Path) -> Result<Vec<u8>, Error> {
    if path.is_dir() {
        return Err(Error::new(path.display(), "is a directory, not a file"));
    }
    fs::read(path).map_err(|error| match error.kind() {
        ErrorKind::NotFound => Error::io(path, "no such file", error),
        _ => Error::io(path, format!("cannot be read: {error}"), error),
    })
}

/// The text of a file, without the byte order mark that some editors put first.
///
/// Bytes that are not UTF-8 are replaced: they stand in comments and names of old files, which
/// should not make a mesh unreadable.
pub(crate) fn read_text(path: &Path) -> Result<String, Error> {
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
