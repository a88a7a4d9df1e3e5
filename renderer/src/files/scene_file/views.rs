//! The cameras of a scene file.

use std::path::{Path, PathBuf};

use glam::DVec3;

use super::format::ordered::Ordered;
use super::format::value::Numbers;
use super::format::{CameraEntry, MatchedFile, SceneFile, ViewEntry};
use super::{Problem, file_in, named_by, numbers};
use crate::experiment::{MatchedPass, ViewTarget};
use crate::files::{FoundView, load_cameras};
use crate::scene::{Camera, Scene, View};
use crate::settings::Pass;

/// A view, and what it is compared with.
pub(super) struct ReadView {
    view: View,
    target: ViewTarget,
    /// Whether it is known how far away what it looks at is.
    is_aimed: bool,
}

/// Gives a scene without views its camera.
pub(super) fn set_camera(scene: &mut Scene, entry: Option<&CameraEntry>) -> Result<(), Problem> {
    let entry =
        entry.ok_or_else(|| Problem::new("camera", "is missing: add a [camera] or a [[view]]"))?;
    scene.width = size("camera", "width", entry.width)?;
    scene.height = size("camera", "height", entry.height)?;
    numbers::assign(&mut scene.camera, "camera", "camera", &entry.numbers)
}

/// The views of a file in a folder. What one leaves out it has from `[camera]`.
pub(super) fn read(file: &SceneFile, folder: &Path) -> Result<Vec<ReadView>, Problem> {
    let default = CameraEntry::default();
    let common = file.camera.as_ref().unwrap_or(&default);
    let mut views = Vec::new();
    for (index, entry) in file.views.iter().enumerate() {
        match &entry.path {
            Some(path) => views.extend(from_file(entry, path, folder)?),
            None => views.push(single(entry, index, common, folder)?),
        }
    }
    Ok(views)
}

/// Adds views to a scene that has its objects; what they are compared with.
pub(super) fn add(views: Vec<ReadView>, scene: &mut Scene) -> Vec<ViewTarget> {
    let mut targets = Vec::new();
    for ReadView { mut view, target, is_aimed } in views {
        if !is_aimed {
            view.camera = scene.aimed(view.camera);
        }
        scene.views.push(view);
        targets.push(target);
    }
    // The camera without a name plays no part; it is that of the first view.
    if let Some(View { width, height, camera, .. }) = scene.views.first() {
        (scene.width, scene.height, scene.camera) = (*width, *height, *camera);
    }
    targets
}

/// A view with a table of its own.
fn single(
    entry: &ViewEntry,
    index: usize,
    common: &CameraEntry,
    folder: &Path,
) -> Result<ReadView, Problem> {
    let Some(name) = entry.name.clone() else {
        let problem = format!("number {} has neither a name nor the path of cameras", index + 1);
        return Err(Problem::new("view", problem));
    };
    let path = format!("view.{name}");
    let is_own = |key: &str| entry.numbers.iter().any(|(own, _)| own == key);
    let inherited = common.numbers.iter().filter(|(key, _)| !is_own(key));
    let all: Ordered<Numbers> = inherited.chain(&entry.numbers).cloned().collect();
    let mut camera = Camera::looking(DVec3::NAN, DVec3::NAN);
    numbers::assign(&mut camera, "camera", &path, &all)?;
    let width = size(&path, "width", entry.width.or(common.width))?;
    let height = size(&path, "height", entry.height.or(common.height))?;
    let matched = |(pass, file): (Pass, &MatchedFile)| {
        let weight = weight(file.weight, || format!("{path}.{}.weight", pass.name()))?;
        let file = file_in(folder, &file.path, || format!("{path}.{}", pass.name()))?;
        Ok::<_, Problem>(MatchedPass { pass, file, weight })
    };
    let named = |key: &str, file: &Option<PathBuf>| {
        let file = file.as_ref().map(|file| file_in(folder, file, || format!("{path}.{key}")));
        file.transpose()
    };
    let target = ViewTarget {
        image: named("target", &entry.target)?,
        passes: entry.passes().map(matched).collect::<Result<_, _>>()?,
        mask: named("mask", &entry.mask)?,
        ..common_target(entry, &path)?
    };
    Ok(ReadView { view: View { name, width, height, camera }, target, is_aimed: true })
}

/// The views of a file of cameras. With a name of the table, theirs begin with it.
fn from_file(entry: &ViewEntry, path: &Path, folder: &Path) -> Result<Vec<ReadView>, Problem> {
    let place = format!("view.{}", path.display());
    let files = [("target", &entry.target), ("mask", &entry.mask)];
    let sizes = [("width", entry.width), ("height", entry.height)];
    let own = files.iter().filter(|(_, file)| file.is_some()).map(|(key, _)| *key);
    let own = own.chain(entry.passes().map(|(pass, _)| pass.name()));
    let own = own.chain(sizes.iter().filter(|(_, size)| size.is_some()).map(|(key, _)| *key));
    if let Some(key) = own.chain(entry.numbers.iter().map(|(key, _)| &key[..])).next() {
        let problem = "is that of one view; this table stands for all cameras of a file";
        return Err(Problem::new(format!("{place}.{key}"), problem));
    }
    let target = common_target(entry, &place)?;
    let read = |FoundView { mut view, image }: FoundView| {
        if let Some(name) = &entry.name {
            view.name = format!("{name}.{}", view.name);
        }
        ReadView {
            view,
            target: ViewTarget { image: Some(image), ..target.clone() },
            is_aimed: false,
        }
    };
    let file = file_in(folder, path, || "view.path".to_owned())?;
    let found = load_cameras(&file).map_err(named_by(format!("{place}.path")))?;
    Ok(found.into_iter().map(read).collect())
}

/// What may be said of one view or of many.
fn common_target(entry: &ViewEntry, path: &str) -> Result<ViewTarget, Problem> {
    let weight = weight(entry.weight.unwrap_or(1.0), || format!("{path}.weight"))?;
    let held_out = entry.held_out.unwrap_or_default();
    Ok(ViewTarget { weight, held_out, ..ViewTarget::default() })
}

/// A factor on a loss.
fn weight(weight: f64, path: impl Fn() -> String) -> Result<f64, Problem> {
    match weight >= 0.0 && weight.is_finite() {
        true => Ok(weight),
        false => Err(Problem::new(path(), format!("must be 0 or more, is {weight}"))),
    }
}

fn size(path: &str, name: &str, size: Option<u32>) -> Result<u32, Problem> {
    size.ok_or_else(|| Problem::new(format!("{path}.{name}"), "is missing"))
}
