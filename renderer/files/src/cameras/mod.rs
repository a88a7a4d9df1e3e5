//! Cameras of other programs: [`nerf`] reads `transforms.json` and [`write`](mod@write) writes it, [`colmap`] reads the
//! files of COLMAP, text and binary.
//!
//! A camera here is a pinhole whose axis goes through the middle of the image and whose pixels are squares.
//! Files may describe others: what cannot be read exactly is refused, by name.

mod colmap;
mod nerf;
mod pinhole;
mod write;

#[cfg(test)]
mod tests;

use std::path::{Path, PathBuf};

#[cfg(feature = "gltf")]
pub(super) use pinhole::Pinhole;
pub use write::save_cameras;

use glam::{DMat3, DVec3};
use renderer_core::Error;
use renderer_core::scene::{Camera, View};

use super::names::{Names, clean_name};

/// A camera of a file, and the image that was taken with it.
#[derive(Clone, Debug, PartialEq)]
pub struct FoundView {
    /// Named after the image. It looks at the point at distance 1.
    pub view: View,
    /// The image.
    pub image: PathBuf,
}

/// Reads the cameras of a file `transforms.json` as of NeRF (Mildenhall et al. 2020) and its successors, or of
/// a folder that holds `cameras.bin` and `images.bin` of COLMAP, or `cameras.txt` and `images.txt`, itself or in
/// `sparse/0` or `sparse`. The images of COLMAP are looked for in the folder `images` beside the folder or one above it, else in the folder
/// itself.
///
/// The cameras of `transforms.json` look along their negative z axis, y points upwards; those of COLMAP look
/// along z, y points downwards. Names are the stems of the files of images.
///
/// # Errors
///
/// If a file cannot be read or is broken, or a camera is none of ours: it has lens distortion, pixels that
/// are not squares (by more than a thousandth), or an axis that misses the middle of the image by more than
/// half a pixel.
pub fn load_cameras(path: &Path) -> Result<Vec<FoundView>, Error> {
    let mut found = if path.is_dir() { colmap::load(path)? } else { nerf::load(path)? };
    if found.is_empty() {
        return Err(Error::new(path.display(), "holds no cameras"));
    }
    let mut names = Names::default();
    for FoundView { view, image } in &mut found {
        let stem = image.file_stem().map(|stem| clean_name(&stem.to_string_lossy()));
        view.name = names.take(stem.filter(|stem| !stem.is_empty()).unwrap_or("view".into()));
    }
    Ok(found)
}

/// How a camera maps directions to pixels.
struct Intrinsics {
    width: u32,
    height: u32,
    /// The distance of the image plane in widths and heights of pixels.
    focal: [f64; 2],
    /// Where the axis meets the image, in pixels from its upper left corner.
    principal: [f64; 2],
}

impl Intrinsics {
    /// The view at a position that is turned so: right, up and backwards are columns.
    fn view(&self, axes: DMat3, position: DVec3) -> Result<View, String> {
        let [width, height] = [self.width, self.height];
        if width == 0 || height == 0 {
            return Err(format!("has {width} x {height} pixels"));
        }
        let [x, y] = self.focal;
        if !(x > 0.0 && y > 0.0 && x.is_finite() && y.is_finite()) {
            return Err(format!("has the focal lengths {x} and {y}; they must be above 0"));
        }
        if (x / y - 1.0).abs() > 1e-3 {
            let problem = format!("has the focal lengths {x} and {y}: its pixels are no squares");
            return Err(format!("{problem}; undistort the images first"));
        }
        let middle = [width, height].map(|size| 0.5 * f64::from(size));
        let is_off = |axis: usize| (self.principal[axis] - middle[axis]).abs() > 0.5;
        // What is not a number is off, too.
        if is_off(0) || is_off(1) || !self.principal.iter().all(|at| at.is_finite()) {
            let ([x, y], [a, b]) = (self.principal, middle);
            let problem =
                format!("has its principal point at {x}, {y} and not in the middle, {a}, {b}");
            return Err(format!("{problem}; undistort and crop the images first"));
        }
        let rigid = (axes.transpose() * axes - DMat3::IDENTITY).to_cols_array();
        let skew = rigid.iter().fold(0.0_f64, |most, entry| most.max(entry.abs()));
        if !(skew < 1e-3 && axes.determinant() > 0.0 && position.is_finite()) {
            return Err("has a matrix that is no rotation and translation".to_owned());
        }
        let vfov = 2.0 * (middle[1] / y).atan().to_degrees();
        let (up, backward) = (axes.y_axis, axes.z_axis);
        let camera =
            Camera { look_from: position, look_at: position - backward, up, vfov, film_scale: 1.0 };
        Ok(View { name: String::new(), width, height, camera })
    }
}

/// Refuses lens distortion.
fn check_undistorted<'a>(terms: impl IntoIterator<Item = (&'a str, f64)>) -> Result<(), String> {
    match terms.into_iter().find(|(_, value)| *value != 0.0) {
        None => Ok(()),
        Some((name, value)) => Err(format!(
            "has the lens distortion {name} = {value}, which is not modelled; undistort the images first"
        )),
    }
}
