//! Folders of COLMAP: its [`text`] files or its [`binary`] ones, which say the same.

mod binary;
mod text;

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use glam::{DMat3, DQuat, DVec3};
use renderer_core::Error;

use super::{FoundView, Intrinsics, check_undistorted};

/// The cameras of photographs, of a folder of files or of a project, whose first model is read. Where a folder
/// holds both kinds of files the binary ones are read, as COLMAP does.
pub(super) fn load(folder: &Path) -> Result<Vec<FoundView>, Error> {
    for folder in [folder.to_owned(), folder.join("sparse/0"), folder.join("sparse")] {
        if folder.join("cameras.bin").exists() {
            return binary::load(&folder);
        }
        if folder.join("cameras.txt").exists() {
            return text::load(&folder);
        }
    }
    let problem = "holds no cameras.bin or cameras.txt, nor do sparse/0 and sparse in it";
    Err(Error::new(folder.display(), problem))
}

/// The folder that the images are in.
fn images(folder: &Path) -> PathBuf {
    let candidates = [folder.parent(), folder.parent().and_then(Path::parent)];
    let beside = candidates.into_iter().flatten().map(|above| above.join("images"));
    beside.into_iter().find(|images| images.is_dir()).unwrap_or_else(|| folder.to_owned())
}

/// What the numbers of a lens are called, in their order.
fn lens(model: &str) -> Result<&'static [&'static str], String> {
    Ok(match model {
        "SIMPLE_PINHOLE" => &["f", "cx", "cy"],
        "PINHOLE" => &["fx", "fy", "cx", "cy"],
        "SIMPLE_RADIAL" => &["f", "cx", "cy", "k"],
        "RADIAL" => &["f", "cx", "cy", "k1", "k2"],
        "OPENCV" => &["fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2"],
        _ => return Err(format!("has the lens {model}, which is not modelled")),
    })
}

/// What a lens does, of its numbers by name.
fn intrinsics(
    [width, height]: [u32; 2],
    numbers: &HashMap<&str, f64>,
) -> Result<Intrinsics, String> {
    let get = |name: &str| numbers.get(name).copied();
    let terms = ["k", "k1", "k2", "p1", "p2"];
    check_undistorted(terms.map(|name| (name, get(name).unwrap_or(0.0))))?;
    let focal = |name: &str| get(name).or_else(|| get("f")).unwrap_or(f64::NAN);
    let principal = ["cx", "cy"].map(|name| get(name).unwrap_or(f64::NAN));
    Ok(Intrinsics { width, height, focal: [focal("fx"), focal("fy")], principal })
}

/// What a photograph was taken with, and how the camera stood: the quaternion and the translation from the
/// world to the camera, which looks along z, with y downwards.
fn found(
    [w, x, y, z, translation @ ..]: [f64; 7],
    camera: u64,
    cameras: &HashMap<u64, Intrinsics>,
    image: PathBuf,
) -> Result<FoundView, String> {
    let Some(intrinsics) = cameras.get(&camera) else {
        return Err(format!("names camera {camera}, which the file of cameras does not have"));
    };
    let quaternion = DQuat::from_xyzw(x, y, z, w);
    if !(quaternion.length() > 0.0 && quaternion.is_finite()) {
        return Err("has a quaternion that is no rotation".to_owned());
    }
    let to_world = DMat3::from_quat(quaternion.normalize()).transpose();
    let position = -(to_world * DVec3::from(translation));
    let axes = DMat3::from_cols(to_world.x_axis, -to_world.y_axis, -to_world.z_axis);
    Ok(FoundView { view: intrinsics.view(axes, position)?, image })
}
