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

    /// Where to write the meshes: .glb (with textures), or .obj (with .mtl and .png beside it)
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,

    #[command(flatten)]
    changes: Changes,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Error> {
    let Arguments { scene, output, changes } = arguments;
    check_writable(output)?;
    if output
        .canonicalize()
        .is_ok_and(|output| scene.canonicalize().is_ok_and(|scene| scene == output))
    {
        return Err(Error::new(output.display(), "is the scene itself; choose another file"));
    }
    let experiment = changes.load(scene)?;
    print_warnings(&save_meshes(&experiment.scene, output)?);
    print(output.display())
}
