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
    if output.exists() {
        let problem = "exists, and would be replaced: choose another name, or remove it";
        return Err(Error::new(output.display(), problem));
    }
    let experiment = changes.load(scene)?;
    print_warnings(&save_meshes(&experiment.scene, output)?);
    print(output.display())
}
