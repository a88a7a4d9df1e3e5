//! Files that are read when images are compared with them, and not with the scene.

use std::path::{Path, PathBuf};

use super::format::SceneFile;

/// The fields that name such files, and the files. Those of a file of cameras it names itself.
pub(super) fn files(file: &SceneFile, folder: &Path) -> Vec<(String, PathBuf)> {
    let mut named: Vec<(String, &PathBuf)> = Vec::new();
    if let Some(entry) = &file.optimize {
        named.extend(entry.target.iter().map(|file| ("optimize.target".to_owned(), file)));
        named.extend(entry.mask.iter().map(|file| ("optimize.mask".to_owned(), file)));
    }
    for entry in &file.views {
        let Some(name) = &entry.name else { continue };
        let field = |key: &str| format!("view.{name}.{key}");
        named.extend(entry.target.iter().map(|file| (field("target"), file)));
        named.extend(entry.passes().map(|(pass, matched)| (field(pass.name()), &matched.path)));
        named.extend(entry.mask.iter().map(|file| (field("mask"), file)));
    }
    named.into_iter().map(|(field, file)| (field, folder.join(file))).collect()
}
