//! `cameras.bin` and `images.bin`: numbers in little endian, one after the other.

use std::collections::HashMap;
use std::path::Path;

use renderer_core::Error;

use super::{FoundView, Intrinsics, found, images, intrinsics, lens};
use crate::disk::read;

/// The lenses by their numbers; only the first five can be without distortion.
const MODELS: [&str; 11] = [
    "SIMPLE_PINHOLE",
    "PINHOLE",
    "SIMPLE_RADIAL",
    "RADIAL",
    "OPENCV",
    "OPENCV_FISHEYE",
    "FULL_OPENCV",
    "FOV",
    "SIMPLE_RADIAL_FISHEYE",
    "RADIAL_FISHEYE",
    "THIN_PRISM_FISHEYE",
];
/// What a point of an image takes: its place and the number of a point in space.
const POINT_BYTES: u64 = 24;

pub(super) fn load(folder: &Path) -> Result<Vec<FoundView>, Error> {
    let cameras = cameras(&folder.join("cameras.bin"))?;
    let path = folder.join("images.bin");
    let bytes = read(&path)?;
    let images = images(folder);
    let mut input = Input(&bytes);
    let mut views = Vec::new();
    let of_file = |problem| Error::new(path.display(), problem);
    for index in 0..input.u64("number of images").map_err(of_file)? {
        let mut view = || {
            let _ = input.u32("number")?;
            let mut numbers = [0.0; 7];
            for value in &mut numbers {
                *value = input.f64("quaternion and translation")?;
            }
            let camera = input.u32("camera")?.into();
            let name = input.text("file name")?;
            if name.is_empty() {
                return Err("has no file name".to_owned());
            }
            let points = input.u64("number of points")?;
            input.skip(points.saturating_mul(POINT_BYTES), "points")?;
            found(numbers, camera, &cameras, images.join(name))
        };
        let place = |problem| Error::new(format!("{}: image {index}", path.display()), problem);
        views.push(view().map_err(place)?);
    }
    input.finish().map_err(of_file)?;
    Ok(views)
}

/// The cameras by number.
fn cameras(path: &Path) -> Result<HashMap<u64, Intrinsics>, Error> {
    let bytes = read(path)?;
    let mut input = Input(&bytes);
    let mut cameras = HashMap::new();
    let of_file = |problem| Error::new(path.display(), problem);
    for index in 0..input.u64("number of cameras").map_err(of_file)? {
        let mut camera = || -> Result<_, String> {
            let id: u64 = input.u32("number")?.into();
            let model = input.u32("lens")?;
            let known = MODELS.get(model as usize);
            let names =
                lens(known.ok_or_else(|| format!("has lens {model}, which is not known"))?)?;
            let mut side = |what| {
                let pixels = input.u64(what)?;
                u32::try_from(pixels).map_err(|_| format!("has a {what} of {pixels} pixels"))
            };
            let size = [side("width")?, side("height")?];
            let mut numbers = HashMap::new();
            for name in names {
                numbers.insert(*name, input.f64(name)?);
            }
            Ok((id, intrinsics(size, &numbers)?))
        };
        let place = |problem| Error::new(format!("{}: camera {index}", path.display()), problem);
        let (id, intrinsics) = camera().map_err(place)?;
        cameras.insert(id, intrinsics);
    }
    input.finish().map_err(of_file)?;
    Ok(cameras)
}

/// What is left of a file.
struct Input<'a>(&'a [u8]);

impl<'a> Input<'a> {
    fn array<const N: usize>(&mut self, what: &str) -> Result<[u8; N], String> {
        let (array, rest) = self.0.split_first_chunk().ok_or_else(|| ends_before(what))?;
        self.0 = rest;
        Ok(*array)
    }

    fn u32(&mut self, what: &str) -> Result<u32, String> {
        self.array(what).map(u32::from_le_bytes)
    }

    fn u64(&mut self, what: &str) -> Result<u64, String> {
        self.array(what).map(u64::from_le_bytes)
    }

    fn f64(&mut self, what: &str) -> Result<f64, String> {
        self.array(what).map(f64::from_le_bytes)
    }

    /// A text that a zero ends.
    fn text(&mut self, what: &str) -> Result<&'a str, String> {
        let end = self.0.iter().position(|&byte| byte == 0).ok_or_else(|| ends_before(what))?;
        let text = str::from_utf8(&self.0[..end]).map_err(|_| format!("{what}: is not UTF-8"))?;
        self.0 = &self.0[end + 1..];
        Ok(text)
    }

    fn skip(&mut self, bytes: u64, what: &str) -> Result<(), String> {
        let bytes = usize::try_from(bytes).unwrap_or(usize::MAX);
        self.0 = self.0.get(bytes..).ok_or_else(|| ends_before(what))?;
        Ok(())
    }

    /// Whether nothing is left.
    fn finish(&self) -> Result<(), String> {
        match self.0.len() {
            0 => Ok(()),
            left => Err(format!("goes on for {left} bytes after what it says it holds")),
        }
    }
}

fn ends_before(what: &str) -> String {
    format!("ends before its {what}")
}
