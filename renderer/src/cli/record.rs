//! What a run was, for its summary and its report.

use std::path::Path;

use serde_json::{Map, Value, json};

use crate::Error;
use crate::Image;
use crate::files::save_png;
use crate::optimize::Settings;
use crate::recovery::Recovery;
use crate::scene::{Object, Scene};

/// How the run was started, and what it was told: entries of the summary.
pub(super) fn settings(recovery: &Recovery<'_>, settings: &Settings) -> Value {
    let render = recovery.render_settings();
    // The name of the program may be the path of a build.
    let arguments = std::env::args().skip(1);
    let command: Vec<String> = std::iter::once("renderer".to_owned()).chain(arguments).collect();
    json!({
        "command": command.join(" "),
        "version": env!("CARGO_PKG_VERSION"),
        "arithmetic": render.arithmetic.name(),
        "edges": format!("{:?}", render.edges.for_parameters(recovery.ids())).to_lowercase(),
        "samples per pixel": render.sampling.count(),
        "optimizer": settings.optimizer.name(),
        "schedule": settings.schedule.name(),
        "most iterations": settings.iterations,
    })
}

/// The largest channel of an image of differences.
pub(super) fn largest(difference: &Image) -> Value {
    let channels = difference.pixels.as_flattened().iter();
    channels.copied().max_by(f32::total_cmp).into()
}

/// Writes the textures that vary as they were and as they are; the entry of the summary: path and
/// files of each.
pub(super) fn save_textures(
    recovery: &Recovery<'_>,
    recovered: &Scene,
    out: &Path,
) -> Result<Value, Error> {
    let mut entries = Vec::new();
    for &id in recovery.ids() {
        let Object::Texture(index) = id.object else { continue };
        let mut entry = Map::new();
        entry.insert("path".to_owned(), recovered.path(id).to_string().into());
        for (name, scene) in [("initial", recovery.scene()), ("final", recovered)] {
            let file = format!("texture{index}-{name}.png");
            save_png(&scene.textures()[index].image(), &out.join(&file))?;
            entry.insert(name.to_owned(), file.into());
        }
        entries.push(Value::Object(entry));
    }
    Ok(Value::Array(entries))
}
