//! `renderer render`

use std::path::PathBuf;

use super::output::print;
use crate::Error;
use crate::arithmetic::Arithmetic;
use crate::experiment::Experiment;
use crate::files::{check_image_path, save_image};
use crate::recovery::render_at;

#[derive(clap::Args)]
pub(super) struct Arguments {
    /// A scene file (TOML), or a mesh (OBJ, PLY, STL, glTF), which is framed and lit by default
    scene: PathBuf,

    /// Where to write the image: .png (sRGB, clipped to 0..1) or .exr (linear, as rendered)
    #[arg(short, long, value_name = "IMAGE")]
    output: PathBuf,
}

pub(super) fn run(arguments: &Arguments, arithmetic: Arithmetic) -> Result<(), Error> {
    check_image_path(&arguments.output)?;
    let experiment = Experiment::load(&arguments.scene)?;
    save_image(&render_at(arithmetic, &experiment.scene), &arguments.output)?;
    print(arguments.output.display())
}
