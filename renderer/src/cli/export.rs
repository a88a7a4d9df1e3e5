//! `renderer export`

use std::path::PathBuf;

use super::changes::Changes;
use super::output::{print, print_warnings};
use crate::Error;
use crate::disk::check_writable;
use crate::files::save_meshes;

#[derive(clap::Args)]
pub(super) struct Arguments {
    /// A scene file (TOML), such as that of a result, or a mesh (OBJ, PLY, STL, glTF)
    scene: PathBuf,

    /// Where to write the meshes: .glb (with textures), or .obj (with .mtl and .png beside it); nothing is replaced
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,

    #[command(flatten)]
    changes: Changes,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Error> {
    let Arguments { scene, output, changes } = arguments;
    check_writable(output)?;
    // The scene may be made of it.
    let library = output.extension().is_some_and(|e| e.eq_ignore_ascii_case("obj"));
    let files = [output.clone()].into_iter().chain(library.then(|| output.with_extension("mtl")));
    if let Some(file) = files.into_iter().find(|file| file.exists()) {
        let problem = "exists, and no mesh is replaced: choose another name, or remove it";
        return Err(Error::new(file.display(), problem));
    }
    let experiment = changes.load(scene)?;
    print_warnings(&save_meshes(&experiment.scene, output)?);
    print(output.display())
}
