//! Material libraries, beside a mesh that names them.

#![no_main]

use std::path::PathBuf;
use std::sync::LazyLock;

use libfuzzer_sys::fuzz_target;
use renderer_fuzz::{folder, read};

static FOLDER: LazyLock<PathBuf> = LazyLock::new(folder);

fuzz_target!(|content: &[u8]| read(&FOLDER, "seed.mtl", content, "seed.obj"));
