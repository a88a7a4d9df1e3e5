//! The files that a scene file names.

use std::path::{Path, PathBuf};

use super::format::SceneFile;

/// The fields that name files, and the files. What these name in turn is not among them.
pub(super) fn files(file: &SceneFile, folder: &Path) -> Vec<(String, PathBuf)> {
    let mut named: Vec<(String, &PathBuf)> = Vec::new();
    if let Some(entry) = &file.optimize {
        named.extend(entry.target.iter().map(|file| ("optimize.target".to_owned(), file)));
        named.extend(entry.mask.iter().map(|file| ("optimize.mask".to_owned(), file)));
    }
    for entry in &file.views {
        named.extend(entry.path.iter().map(|file| (format!("view.{}.path", file.display()), file)));
        let Some(name) = &entry.name else { continue };
        let field = |key: &str| format!("view.{name}.{key}");
        named.extend(entry.target.iter().map(|file| (field("target"), file)));
        named.extend(entry.passes().map(|(pass, matched)| (field(pass.name()), &matched.path)));
        named.extend(entry.mask.iter().map(|file| (field("mask"), file)));
    }
    for (name, entry) in &file.textures {
        named.extend(entry.path.iter().map(|file| (format!("texture.{name}.path"), file)));
    }
    for entry in &file.meshes {
        let Some(path) = &entry.path else { continue };
        let name = entry.name.clone().unwrap_or(path.display().to_string());
        named.push((format!("mesh.{name}.path"), path));
    }
    named.into_iter().map(|(field, file)| (field, folder.join(file))).collect()
}
