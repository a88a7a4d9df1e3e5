//! `renderer params`

use std::path::PathBuf;

use serde_json::{Map, Value};

use super::changes::Changes;
use super::output::{abbreviate, json_numbers, print};
use crate::Error;
use crate::scene::View;

#[derive(clap::Args)]
pub(super) struct Arguments {
    /// A scene file (TOML), or a mesh (OBJ, PLY, STL, glTF), which is framed and lit by default
    scene: PathBuf,

    #[command(flatten)]
    changes: Changes,

    /// Print an object: path -> numbers
    #[arg(long)]
    json: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Error> {
    let scene = arguments.changes.load(&arguments.scene)?.scene;
    let sides = |place: &str, width: u32, height: u32| {
        [(format!("{place}.width"), width), (format!("{place}.height"), height)]
    };
    let size: Vec<(String, u32)> = match scene.views() {
        [] => sides("camera", scene.width, scene.height).into(),
        views => {
            let of_view =
                |view: &View| sides(&format!("view.{}", view.name), view.width, view.height);
            views.iter().flat_map(of_view).collect()
        }
    };
    if arguments.json {
        let mut object = Map::new();
        for id in scene.parameters() {
            let numbers = json_numbers(&scene.get(id), &scene.shape(id));
            object.insert(scene.path(id).to_string(), numbers);
        }
        object.extend(size.into_iter().map(|(path, value)| (path, value.into())));
        return print(format_args!("{:#}", Value::Object(object)));
    }

    let mut rows: Vec<[String; 4]> = Vec::new();
    for id in scene.parameters() {
        let shape: Vec<_> = scene.shape(id).iter().map(usize::to_string).collect();
        let shape = if shape.is_empty() { "1".into() } else { shape.join(" x ") };
        let value = abbreviate(&scene.get(id));
        rows.push([scene.path(id).to_string(), shape, "differentiable".into(), value]);
    }
    for (path, value) in size {
        rows.push([path, "1".into(), "not differentiable".into(), value.to_string()]);
    }
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max();
    let widths = [0, 1, 2].map(|column| width(column).unwrap_or(0));
    let [a, b, c] = widths;
    let lines = rows
        .iter()
        .map(|[path, shape, kind, value]| format!("{path:a$}  {shape:>b$}  {kind:c$}  {value}"));
    print(lines.collect::<Vec<_>>().join("\n"))
}
