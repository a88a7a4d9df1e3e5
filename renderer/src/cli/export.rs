//! `renderer export`

use std::path::{Path, PathBuf};

use renderer_files::Warnings;
use renderer_files::disk::check_writable;

use super::changes::Changes;
use super::output::{print, print_warnings};
use super::views::view_stems;
use crate::experiment::{Experiment, Target};
use crate::files::{FoundView, save_cameras, save_meshes};
use crate::scene::View;
use crate::{Error, Warning};

#[derive(clap::Args)]
pub(super) struct Arguments {
    /// A scene file (TOML), such as that of a result, or a mesh (OBJ, PLY, STL, glTF)
    scene: PathBuf,

    /// Where to write: .glb (meshes with textures, cameras, lights), .obj (meshes, with .mtl and .png beside it) or
    /// .json (cameras, as transforms.json has them); nothing is replaced
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
    let is_cameras = output.extension().is_some_and(|it| it.eq_ignore_ascii_case("json"));
    let warnings = match is_cameras {
        true => export_cameras(&experiment, output)?,
        false => save_meshes(&experiment.scene, output)?,
    };
    print_warnings(&warnings);
    print(output.display())
}

/// Writes the cameras of views, or that of the scene, with the images that they are compared with.
fn export_cameras(experiment: &Experiment, output: &Path) -> Result<Vec<Warning>, Error> {
    let Experiment { scene, optimize, .. } = experiment;
    let section = optimize.clone().unwrap_or_default();
    let mut cameras = Vec::new();
    let mut warnings = Warnings::default();
    let mut add = |view: &View, place: &str, stem: &str, image: Option<PathBuf>| {
        let image = image.unwrap_or_else(|| {
            let file = format!("{stem}.png");
            let problem = format!("has no image; its file_path names {file}, which is not written");
            warnings.add("no image", place, problem);
            output.with_file_name(file)
        });
        cameras.push(FoundView { view: view.clone(), image });
    };
    for (index, (view, stem)) in scene.views().iter().zip(view_stems(scene)).enumerate() {
        let image = section.views.get(index).and_then(|target| target.image.clone());
        add(view, &format!("view.{}", view.name), &stem, image);
    }
    if scene.views().is_empty() {
        let image = match section.target {
            Some(Target::Image(image)) => Some(image),
            _ => None,
        };
        let [width, height] = scene.size();
        let view = View { name: "camera".to_owned(), width, height, camera: scene.camera };
        add(&view, "camera", "camera", image);
    }
    save_cameras(&cameras, output)?;
    Ok(warnings.finish())
}
