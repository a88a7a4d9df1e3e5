//! PNG, JPEG and OpenEXR: as target images, and as textures of a mesh.

#![no_main]

use std::path::PathBuf;
use std::sync::LazyLock;

use libfuzzer_sys::fuzz_target;
use renderer::files::load_image;
use renderer_fuzz::{check, folder, read};

static FOLDER: LazyLock<PathBuf> = LazyLock::new(folder);

fuzz_target!(|content: &[u8]| {
    read(&FOLDER, "seed.png", content, "seed.obj");
    check(load_image(&FOLDER.join("seed.png")).map(|_| ()));
});
