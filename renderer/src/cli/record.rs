//! What a run was, for its summary and its report.

use std::collections::HashSet;
use std::path::Path;

use glam::DVec3;
use serde_json::{Value, json};

use crate::files::save_png;
use crate::optimize::Settings;
use crate::recovery::Recovery;
use crate::scene::{Camera, Material, Mesh, Object, ParameterId, Scene};
use crate::{Error, Image, Settings as RenderSettings, render};

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
        "edges": format!("{:?}", recovery.scene().edges_for(render.edges, recovery.ids())).to_lowercase(),
        "samples per pixel": render.sampling.count(),
        "optimizer": settings.optimizer.name(),
        "schedule": settings.schedule.name(),
        "most iterations": settings.iterations,
    })
}

/// Writes a difference, scaled such that its largest channel is 1; that channel, for the summary.
pub(super) fn save_difference(mut difference: Image, out: &Path) -> Result<Value, Error> {
    let channels = difference.pixels.as_flattened_mut();
    let largest = channels.iter().copied().max_by(f32::total_cmp).unwrap_or(0.0);
    if largest > 0.0 {
        channels.iter_mut().for_each(|channel| *channel /= largest);
    }
    save_png(&difference, &out.join("difference.png"))?;
    Ok(largest.into())
}

/// Writes pictures of the textures and of the shapes that vary, as they were and as they are; the entry
/// of the summary: path and files of each.
pub(super) fn save_pictures(
    recovery: &Recovery<'_>,
    recovered: &Scene,
    out: &Path,
) -> Result<Value, Error> {
    let mut entries = Vec::new();
    let mut pictured = HashSet::new();
    for &id in recovery.ids() {
        let pictures = match id.object {
            Object::Texture(index) => {
                [recovery.scene(), recovered].map(|scene| scene.textures()[index].image())
            }
            Object::Mesh(index) if id.field == "vertices" => {
                portraits(&recovery.scene().meshes()[index], &recovered.meshes()[index])?
            }
            _ => continue,
        };
        // Vertices of a mesh may vary one by one.
        if !pictured.insert(id.object) {
            continue;
        }
        let number = entries.len();
        let file = |name: &str| format!("picture{number}-{name}.png");
        for (name, picture) in ["initial", "final"].iter().zip(&pictures) {
            save_png(picture, &out.join(file(name)))?;
        }
        let path = recovered.path(ParameterId { vertex: None, ..id }).to_string();
        entries.push(json!({ "path": path, "initial": file("initial"), "final": file("final") }));
    }
    Ok(Value::Array(entries))
}

/// Two states of a mesh, by itself and grey, as one camera sees them that shows both whole.
fn portraits(initial: &Mesh, recovered: &Mesh) -> Result<[Image; 2], Error> {
    let mut both = Scene::new(1, 1, Camera::looking(DVec3::Z, DVec3::ZERO));
    both.add_material("grey", Material::lambertian(DVec3::splat(0.8)))?;
    both.meshes = vec![initial.clone(), recovered.clone()];
    both.frame();
    let portrait = |mesh: &Mesh| {
        let mut scene = Scene { meshes: vec![mesh.clone()], ..both.clone() };
        scene.meshes[0].materials.fill(0);
        render(&scene, &RenderSettings::default())
    };
    Ok([portrait(initial)?, portrait(recovered)?])
}
