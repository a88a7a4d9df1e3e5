//! `cameras.txt` and `images.txt`.

use std::collections::HashMap;
use std::fmt::Display;
use std::path::Path;
use std::str::{FromStr, SplitWhitespace};

use renderer_core::Error;

use super::{FoundView, Intrinsics, found, images, intrinsics, lens};
use crate::disk::read;

pub(super) fn load(folder: &Path) -> Result<Vec<FoundView>, Error> {
    let cameras = cameras(&folder.join("cameras.txt"))?;
    let path = folder.join("images.txt");
    let text = text(&path)?;
    let images = images(folder);

    let mut views = Vec::new();
    // Every second line lists points, and may be empty.
    let lines = text.lines().zip(1..).filter(|(line, _)| !line.starts_with('#'));
    for (line, number) in lines.step_by(2) {
        if line.trim().is_empty() {
            continue;
        }
        let refuse = |problem: String| Error::new(format!("{}:{number}", path.display()), problem);
        let mut words = line.split_whitespace();
        let _: u64 = next(&mut words, "number").map_err(refuse)?;
        let mut numbers = [0.0; 7];
        for value in &mut numbers {
            *value = next(&mut words, "quaternion and translation").map_err(refuse)?;
        }
        let camera: u64 = next(&mut words, "camera").map_err(refuse)?;
        let name = words.collect::<Vec<_>>().join(" ");
        if name.is_empty() {
            return Err(refuse("has no file name".to_owned()));
        }
        let view = found(numbers, camera, &cameras, images.join(name));
        views.push(view.map_err(refuse)?);
    }
    Ok(views)
}

/// The cameras by number.
fn cameras(path: &Path) -> Result<HashMap<u64, Intrinsics>, Error> {
    let mut cameras = HashMap::new();
    for (line, number) in text(path)?.lines().zip(1..) {
        if line.starts_with('#') || line.trim().is_empty() {
            continue;
        }
        let (id, intrinsics) = camera(line)
            .map_err(|problem| Error::new(format!("{}:{number}", path.display()), problem))?;
        cameras.insert(id, intrinsics);
    }
    Ok(cameras)
}

/// `1 SIMPLE_RADIAL 640 480 500 320 240 0.01`
fn camera(line: &str) -> Result<(u64, Intrinsics), String> {
    let mut words = line.split_whitespace();
    let id = next(&mut words, "number")?;
    let model: String = next(&mut words, "model")?;
    let size = [next(&mut words, "width")?, next(&mut words, "height")?];
    let mut numbers = HashMap::new();
    for name in lens(&model)? {
        numbers.insert(*name, next::<f64>(&mut words, name)?);
    }
    Ok((id, intrinsics(size, &numbers)?))
}

/// The next word of a line.
fn next<T: FromStr<Err: Display>>(
    words: &mut SplitWhitespace<'_>,
    what: &str,
) -> Result<T, String> {
    let word = words.next().ok_or_else(|| format!("ends before its {what}"))?;
    word.parse().map_err(|error| format!("{what}: `{word}`: {error}"))
}

fn text(path: &Path) -> Result<String, Error> {
    String::from_utf8(read(path)?).map_err(|_| Error::new(path.display(), "is not UTF-8 text"))
}
