//! The cameras of a scene file.

use std::path::Path;

use glam::DVec3;

use super::format::{CameraEntry, SceneFile, ViewEntry};
use super::{Problem, numbers};
use crate::experiment::ViewTarget;
use crate::scene::{Camera, Scene, View};

/// An empty scene with the cameras of a file. What a view leaves out it has from `[camera]`.
pub(super) fn scene(file: &SceneFile) -> Result<Scene, Problem> {
    let nowhere = Camera::looking(DVec3::NAN, DVec3::NAN);
    let default = CameraEntry::default();
    let given = file.camera.as_ref().unwrap_or(&default);
    let mut scene = Scene { bounces: file.bounces, ..Scene::new(0, 0, nowhere) };
    if file.views.is_empty() {
        scene.width = size("camera", "width", given.width)?;
        scene.height = size("camera", "height", given.height)?;
        numbers::assign(&mut scene.camera, "camera", "camera", &given.numbers)?;
        return Ok(scene);
    }
    for (index, entry) in file.views.iter().enumerate() {
        let name = entry.name.clone().ok_or_else(|| nameless(index))?;
        let path = format!("view.{name}");
        let mut camera = nowhere;
        let is_own = |key: &str| entry.numbers.iter().any(|(own, _)| own == key);
        let common = given.numbers.iter().filter(|(key, _)| !is_own(key)).cloned();
        let all: Vec<_> = common.chain(entry.numbers.iter().cloned()).collect();
        numbers::assign(&mut camera, "camera", &path, &all)?;
        let width = size(&path, "width", entry.width.or(given.width))?;
        let height = size(&path, "height", entry.height.or(given.height))?;
        scene.views.push(View { name, width, height, camera });
    }
    Ok(scene)
}

/// What the views of a file are compared with.
pub(super) fn targets(views: &[ViewEntry], folder: &Path) -> Result<Vec<ViewTarget>, Problem> {
    let target = |(index, entry): (usize, &ViewEntry)| {
        let name = entry.name.as_ref().ok_or_else(|| nameless(index))?;
        let weight = entry.weight.unwrap_or(1.0);
        if !(weight >= 0.0 && weight.is_finite()) {
            let problem = format!("must be 0 or more, is {weight}");
            return Err(Problem::new(format!("view.{name}.weight"), problem));
        }
        Ok(ViewTarget {
            image: entry.target.as_ref().map(|file| folder.join(file)),
            coverage: entry.coverage.as_ref().map(|file| folder.join(file)),
            mask: entry.mask.as_ref().map(|file| folder.join(file)),
            weight,
            held_out: entry.held_out.unwrap_or_default(),
        })
    };
    views.iter().enumerate().map(target).collect()
}

fn nameless(index: usize) -> Problem {
    let problem = format!("number {} has no name; each view needs one", index + 1);
    Problem::new("view", problem)
}

fn size(path: &str, name: &str, size: Option<u32>) -> Result<u32, Problem> {
    size.ok_or_else(|| Problem::new(format!("{path}.{name}"), "is missing"))
}
