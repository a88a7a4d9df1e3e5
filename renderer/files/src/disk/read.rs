//! Whole files, read.

use std::fs;
use std::io::{self, ErrorKind};
use std::path::Path;

use renderer_core::{Error, memory};

/// What a byte of a file takes once it is read: itself, and what it becomes.
const FILE_BYTES: u64 = 4;

/// The bytes of a file.
pub fn read(path: &Path) -> Result<Vec<u8>, Error> {
    let failed = |error: io::Error| match error.kind() {
        ErrorKind::NotFound => Error::io(path, "no such file", error),
        _ => Error::io(path, format!("cannot be read: {error}"), error),
    };
    // Devices and pipes may never end, or never begin.
    let found = fs::metadata(path).map_err(failed)?;
    if found.is_dir() {
        return Err(Error::new(path.display(), "is a directory, not a file"));
    }
    if !found.is_file() {
        return Err(Error::new(path.display(), "is no regular file, but a device or a pipe"));
    }
    memory::ask(found.len().saturating_mul(FILE_BYTES))
        .map_err(|problem| Error::new(path.display(), problem))?;
    fs::read(path).map_err(failed)
}

/// The text of a file, without the byte order mark that some editors put first.
///
/// Bytes that are not UTF-8 are replaced: they stand in comments and names of old files, which
/// should not make a mesh unreadable.
pub fn read_text(path: &Path) -> Result<String, Error> {
    let bytes = read(path)?;
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        return Err(Error::new(path.display(), "is text in UTF-16; save it as UTF-8"));
    }
    let text = String::from_utf8(bytes)
        .unwrap_or_else(|error| String::from_utf8_lossy(error.as_bytes()).into_owned());
    let text = match text.strip_prefix('\u{feff}') {
        Some(rest) => rest.to_owned(),
        None => text,
    };
    // Old systems ended lines by a carriage return alone.
    Ok(if text.contains('\r') && !text.contains('\n') { text.replace('\r', "\n") } else { text })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn missing_files_and_directories_are_told_apart() {
        let folder = tempfile::tempdir().unwrap();
        assert_eq!(read(&folder.path().join("x")).unwrap_err().problem, "no such file");
        assert_eq!(read(folder.path()).unwrap_err().problem, "is a directory, not a file");
        if cfg!(unix) {
            let error = read(Path::new("/dev/zero")).unwrap_err();
            assert_eq!(error.problem, "is no regular file, but a device or a pipe");
        }
    }
}
