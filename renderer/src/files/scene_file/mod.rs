//! Scene files: TOML, one file for a whole experiment.
//!
//! [`format`] is the file as it is written down, [`read`] turns it into an experiment, [`write`] an
//! experiment into a folder, [`numbers`] sets what the table of parameters knows, and [`locate`] finds
//! the line that a message is about.

mod coordinates;
mod dark;
mod format;
mod invisible;
mod levels;
mod locate;
mod materials;
mod meshes;
mod named;
mod numbers;
mod optimize;
mod read;
mod small;
mod textures;
mod views;
mod write;

#[cfg(test)]
mod tests;
#[cfg(test)]
mod texture_tests;

use std::path::{Path, PathBuf};

use renderer_files::disk::read as read_bytes;
use toml::de::DeTable;

use crate::experiment::{Experiment, NamedFile, at_field};
use crate::files::MeshFormat;
use crate::scene::Invalid;
use crate::{Error, ErrorKind};
use locate::Locator;

pub use write::{save_experiment, save_scene};

impl Experiment {
    /// Reads a scene file, or a mesh ([`load_mesh`](crate::files::load_mesh)), which is then framed
    /// and lit by default: the camera looks at the centre of the bounding box from the front, to the
    /// right and above; a point light `key` stands above the camera. A camera and lights that a glTF
    /// file brings along replace these. What the files hold that nothing here shows is left out, and
    /// said in [`warnings`](Self::warnings).
    ///
    /// # Errors
    ///
    /// If a file cannot be read, is broken, or describes what cannot be rendered. The message names
    /// the file and, where it can, the line and the field.
    pub fn load(path: &Path) -> Result<Self, Error> {
        if MeshFormat::of(path).is_some() {
            return meshes::load_mesh_scene(path);
        }
        load(path)
    }

    /// Parses the text of a scene file whose relative paths begin in `base_dir`; messages call it
    /// `name`.
    ///
    /// # Errors
    ///
    /// As [`load`](Self::load).
    pub fn parse(text: &str, base_dir: &Path, name: &str) -> Result<Self, Error> {
        parse(text, base_dir, name)
    }
}

/// Reads a scene file.
fn load(path: &Path) -> Result<Experiment, Error> {
    let neither = |why: &str| {
        let problem = "is neither a scene file (TOML) nor a mesh (.obj, .ply, .stl, .gltf, .glb)";
        Error::new(path.display(), format!("{problem}{why}"))
    };
    let text = String::from_utf8(read_bytes(path)?).map_err(|error| {
        let position = error.utf8_error().valid_up_to();
        neither(&format!(": byte {position} is not UTF-8 text"))
    })?;
    // Whoever calls it TOML wants to know what is wrong with that.
    let is_called_toml = path.extension().is_none_or(|it| it.eq_ignore_ascii_case("toml"));
    if !is_called_toml && DeTable::parse(&text).is_err() {
        return Err(neither(""));
    }
    let folder = path.parent().unwrap_or(Path::new(""));
    parse(&text, folder, &path.display().to_string())
}

/// Parses the text of a scene file.
fn parse(text: &str, folder: &Path, name: &str) -> Result<Experiment, Error> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let locator = Locator::new(text, name);
    let file: format::SceneFile =
        toml::from_str(text).map_err(|error| locator.syntax_error(error))?;
    let mut experiment =
        read::experiment(&file, folder, name).map_err(|problem| match problem {
            Problem::Here(invalid) => locator.place(invalid),
            Problem::Elsewhere(error) => error,
            Problem::Named { path, error } => at_field(locator.field(&path), error),
        })?;
    let named = named::files(&file, folder).into_iter();
    let named = named.map(|(field, path)| NamedFile { path, by: locator.field(&field) });
    experiment.files.extend(named);
    Ok(experiment)
}

/// What is wrong: in the scene file itself, or in a file that it names.
enum Problem {
    Here(Invalid),
    Elsewhere(Error),
    /// A file cannot be read that the field at `path` names.
    Named {
        path: String,
        error: Error,
    },
}

impl Problem {
    fn new(path: impl ToString, problem: impl ToString) -> Self {
        Self::Here(Invalid { path: path.to_string(), problem: problem.to_string() })
    }
}

/// The file that a field names, relative to the folder of the scene file.
fn file_in(folder: &Path, file: &Path, field: impl FnOnce() -> String) -> Result<PathBuf, Problem> {
    match file.as_os_str().is_empty() {
        true => Err(Problem::new(field(), "is empty; it must be the path of a file")),
        false => Ok(folder.join(file)),
    }
}

/// What is wrong with a file that the field at `path` names: that it cannot be read is for who wrote the field, all else
/// for who wrote the file.
fn named_by(path: String) -> impl FnOnce(Error) -> Problem {
    move |error| match error.kind {
        ErrorKind::Io => Problem::Named { path, error },
        _ => Problem::Elsewhere(error),
    }
}

impl Problem {
    /// The error where there is no scene file, but a mesh at `path`.
    fn at(self, path: &Path) -> Error {
        match self {
            Self::Here(Invalid { path: field, problem }) => {
                Error::new(format!("{}: {field}", path.display()), problem)
            }
            Self::Elsewhere(error) | Self::Named { error, .. } => error,
        }
    }
}

impl From<Invalid> for Problem {
    fn from(invalid: Invalid) -> Self {
        Self::Here(invalid)
    }
}

impl From<Error> for Problem {
    fn from(error: Error) -> Self {
        Self::Elsewhere(error)
    }
}
