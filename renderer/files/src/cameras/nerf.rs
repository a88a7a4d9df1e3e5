//! `transforms.json`.

use std::path::Path;

use glam::{DMat3, DVec3};
use renderer_core::Error;
use serde::Deserialize;

use super::{FoundView, Intrinsics, check_undistorted};
use crate::disk::read;
use crate::load_image;

#[derive(Deserialize)]
struct Transforms {
    #[serde(flatten)]
    common: Lens,
    frames: Vec<Frame>,
}

#[derive(Deserialize)]
struct Frame {
    /// Relative to the file; where it has no extension, that of a PNG is meant.
    file_path: String,
    /// From the camera to the world, row by row.
    transform_matrix: [[f64; 4]; 4],
    /// What is not that of all frames.
    #[serde(flatten)]
    own: Lens,
}

#[derive(Clone, Deserialize)]
struct Lens {
    w: Option<f64>,
    h: Option<f64>,
    /// The horizontal field of view in radians.
    camera_angle_x: Option<f64>,
    camera_angle_y: Option<f64>,
    fl_x: Option<f64>,
    fl_y: Option<f64>,
    cx: Option<f64>,
    cy: Option<f64>,
    k1: Option<f64>,
    k2: Option<f64>,
    k3: Option<f64>,
    k4: Option<f64>,
    p1: Option<f64>,
    p2: Option<f64>,
    /// What the lens is called by: `OPENCV`, `OPENCV_FISHEYE`, ...
    camera_model: Option<String>,
    is_fisheye: Option<bool>,
}

pub(super) fn load(path: &Path) -> Result<Vec<FoundView>, Error> {
    let broken = |error: serde_json::Error| {
        let place = format!("{}:{}", path.display(), error.line());
        Error::new(place, format_args!("is no transforms.json: {error}"))
    };
    let file: Transforms = serde_json::from_slice(&read(path)?).map_err(broken)?;
    let folder = path.parent().unwrap_or(Path::new(""));
    let found = |(index, frame): (usize, &Frame)| {
        let refuse = |problem: String| {
            let place = format!("{}: frames[{index}] ({})", path.display(), frame.file_path);
            Error::new(place, problem)
        };
        let mut image = folder.join(&frame.file_path);
        if image.extension().is_none() {
            image.set_extension("png");
        }
        let lens = Lenses { own: &frame.own, common: &file.common };
        let size = match lens.size().map_err(refuse)? {
            Some(size) => size,
            None => {
                let picture = load_image(&image)?.image;
                [picture.width, picture.height]
            }
        };
        let intrinsics = lens.intrinsics(size).map_err(refuse)?;
        let [x, y, z, last] = frame.transform_matrix;
        if last != [0.0, 0.0, 0.0, 1.0] {
            return Err(refuse("has a matrix whose last row is not 0, 0, 0, 1".to_owned()));
        }
        let axes =
            DMat3::from_cols_array_2d(&[0, 1, 2].map(|column| [x, y, z].map(|row| row[column])));
        let position = DVec3::new(x[3], y[3], z[3]);
        let view = intrinsics.view(axes, position).map_err(refuse)?;
        Ok(FoundView { view, image })
    };
    file.frames.iter().enumerate().map(found).collect()
}

/// A term of the distortion.
type Term = fn(&Lens) -> Option<f64>;

/// What a frame says of its lens, and, where it says nothing, the file.
struct Lenses<'a> {
    own: &'a Lens,
    common: &'a Lens,
}

impl Lenses<'_> {
    fn get(&self, of: impl Fn(&Lens) -> Option<f64>) -> Option<f64> {
        of(self.own).or_else(|| of(self.common))
    }

    /// Width and height in pixels, if they are given.
    fn size(&self) -> Result<Option<[u32; 2]>, String> {
        let (width, height) = match (self.get(|lens| lens.w), self.get(|lens| lens.h)) {
            (Some(width), Some(height)) => (width, height),
            (None, None) => return Ok(None),
            (Some(_), None) => return Err("has `w`, the width, and no `h`".to_owned()),
            (None, Some(_)) => return Err("has `h`, the height, and no `w`".to_owned()),
        };
        let count = |size: f64| match size {
            _ if size >= 1.0 && size <= f64::from(u32::MAX) && size.fract() == 0.0 => {
                Ok(size as u32)
            }
            _ => Err(format!("has a side of {size} pixels")),
        };
        Ok(Some([count(width)?, count(height)?]))
    }

    /// The focal length in pixels that belongs to half of a side, by its length or by the angle of the side: what a
    /// frame says of one counts for both.
    fn focal(
        &self,
        half: f64,
        [name, name_of_angle]: [&str; 2],
        of: impl Fn(&Lens) -> [Option<f64>; 2],
    ) -> Result<Option<f64>, String> {
        let from_angle = |angle: f64| half / (0.5 * angle).tan();
        let [length, angle] = match of(self.own) {
            [None, None] => of(self.common),
            own => own,
        };
        match (length, angle.map(from_angle)) {
            (Some(length), Some(of_angle)) if (length / of_angle - 1.0).abs() > 0.01 => {
                Err(format!(
                    "has {name} = {length}, but its {name_of_angle} means {of_angle:.1} where the side has {} pixels",
                    2.0 * half
                ))
            }
            (length, of_angle) => Ok(length.or(of_angle)),
        }
    }

    fn intrinsics(&self, [width, height]: [u32; 2]) -> Result<Intrinsics, String> {
        let model = self.own.camera_model.as_ref().or(self.common.camera_model.as_ref());
        let is_fisheye = self.own.is_fisheye.or(self.common.is_fisheye).unwrap_or_default();
        let known = ["OPENCV", "PINHOLE", "SIMPLE_PINHOLE"];
        match model {
            Some(model) if !known.contains(&&model[..]) => {
                return Err(format!("has the lens {model}, which is not modelled"));
            }
            _ if is_fisheye => return Err("has a fisheye lens, which is not modelled".to_owned()),
            _ => {}
        }
        let terms: [(&str, Term); 6] = [
            ("k1", |lens| lens.k1),
            ("k2", |lens| lens.k2),
            ("k3", |lens| lens.k3),
            ("k4", |lens| lens.k4),
            ("p1", |lens| lens.p1),
            ("p2", |lens| lens.p2),
        ];
        check_undistorted(terms.map(|(name, of)| (name, self.get(of).unwrap_or(0.0))))?;
        let half = [width, height].map(|size| 0.5 * f64::from(size));
        let x = self
            .focal(half[0], ["fl_x", "camera_angle_x"], |lens| [lens.fl_x, lens.camera_angle_x])?;
        let y = self
            .focal(half[1], ["fl_y", "camera_angle_y"], |lens| [lens.fl_y, lens.camera_angle_y])?;
        let Some(focal) = x.or(y) else {
            return Err("has neither fl_x nor camera_angle_x".to_owned());
        };
        let principal = [
            self.get(|lens| lens.cx).unwrap_or(half[0]),
            self.get(|lens| lens.cy).unwrap_or(half[1]),
        ];
        let focal = [x.unwrap_or(focal), y.unwrap_or(focal)];
        Ok(Intrinsics { width, height, focal, principal })
    }
}
