//! What the targets share: a folder for the file that is read, and what reading it may end in.

use std::fs;
use std::path::{Path, PathBuf};

use renderer::Error;
use renderer::experiment::Experiment;

/// A folder of this process, with what files may name: `seed.obj`, `seed.mtl` and `seed.png`. It is
/// left behind: libFuzzer ends the process without a word.
pub fn folder() -> PathBuf {
    let folder = std::env::temp_dir().join(format!("renderer-fuzz-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder for what is read");
    let seeds: [(&str, &[u8]); 3] = [
        ("seed.obj", include_bytes!("../seeds/obj/seed.obj")),
        ("seed.mtl", include_bytes!("../seeds/mtl/seed.mtl")),
        ("seed.png", include_bytes!("../seeds/image/seed.png")),
    ];
    for (name, content) in seeds {
        fs::write(folder.join(name), content).expect("the folder can be written to");
    }
    folder
}

/// Reads `content` as the file `name` in `folder`, by way of the file `entry`, which names it or is
/// it.
///
/// # Panics
///
/// If the file is refused with anything but one line that a person can read.
pub fn read(folder: &Path, name: &str, content: &[u8], entry: &str) {
    fs::write(folder.join(name), content).expect("the folder can be written to");
    check(Experiment::load(&folder.join(entry)).map(|_| ()))
}

/// Whether the end of reading a file is one that a person can use.
///
/// # Panics
///
/// If it is an error of several lines, without a problem, or too long to read.
pub fn check(result: Result<(), Error>) {
    if let Err(error) = result {
        let line = error.to_string();
        let is_clear = !error.problem.trim().is_empty()
            && !line.contains(char::is_control)
            && line.len() < 10_000;
        assert!(is_clear, "no clear line: {line:?}");
    }
}
