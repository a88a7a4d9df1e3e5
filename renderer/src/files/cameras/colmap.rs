//! `cameras.txt` and `images.txt` of COLMAP.

use std::collections::HashMap;
use std::fmt::Display;
use std::path::Path;
use std::str::{FromStr, SplitWhitespace};

use glam::{DMat3, DQuat, DVec3};

use super::{FoundView, Intrinsics, check_undistorted};
use crate::Error;
use crate::disk::read;

pub(super) fn load(folder: &Path) -> Result<Vec<FoundView>, Error> {
    let cameras = cameras(&folder.join("cameras.txt"))?;
    let path = folder.join("images.txt");
    let text = text(&path)?;
    let candidates = [folder.parent(), folder.parent().and_then(Path::parent)];
    let beside = candidates.into_iter().flatten().map(|above| above.join("images"));
    let images = beside.into_iter().find(|images| images.is_dir());
    let images = images.unwrap_or_else(|| folder.to_owned());

    let mut found = Vec::new();
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
        let [w, x, y, z, rest @ ..] = numbers;
        let camera: u64 = next(&mut words, "camera").map_err(refuse)?;
        let name = words.collect::<Vec<_>>().join(" ");
        if name.is_empty() {
            return Err(refuse("has no file name".to_owned()));
        }
        let Some(intrinsics) = cameras.get(&camera) else {
            return Err(refuse(format!("names camera {camera}, which cameras.txt does not have")));
        };
        let quaternion = DQuat::from_xyzw(x, y, z, w);
        if !(quaternion.length() > 0.0 && quaternion.is_finite()) {
            return Err(refuse("has a quaternion that is no rotation".to_owned()));
        }
        // From the world to the camera, which looks along z, with y downwards.
        let to_world = DMat3::from_quat(quaternion.normalize()).transpose();
        let position = -(to_world * DVec3::from(rest));
        let axes = DMat3::from_cols(to_world.x_axis, -to_world.y_axis, -to_world.z_axis);
        let view = intrinsics.view(axes, position).map_err(refuse)?;
        found.push(FoundView { view, image: images.join(name) });
    }
    Ok(found)
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
    let (width, height) = (next(&mut words, "width")?, next(&mut words, "height")?);
    let names: &[&str] = match &model[..] {
        "SIMPLE_PINHOLE" => &["f", "cx", "cy"],
        "PINHOLE" => &["fx", "fy", "cx", "cy"],
        "SIMPLE_RADIAL" => &["f", "cx", "cy", "k"],
        "RADIAL" => &["f", "cx", "cy", "k1", "k2"],
        "OPENCV" => &["fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2"],
        _ => return Err(format!("has the lens {model}, which is not modelled")),
    };
    let mut numbers = HashMap::new();
    for name in names {
        numbers.insert(*name, next::<f64>(&mut words, name)?);
    }
    let get = |name: &str| numbers.get(name).copied();
    let terms = ["k", "k1", "k2", "p1", "p2"];
    check_undistorted(terms.map(|name| (name, get(name).unwrap_or(0.0))))?;
    let focal = |name: &str| get(name).or_else(|| get("f")).unwrap_or(f64::NAN);
    let principal = ["cx", "cy"].map(|name| get(name).unwrap_or(f64::NAN));
    let focal = [focal("fx"), focal("fy")];
    Ok((id, Intrinsics { width, height, focal, principal }))
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
