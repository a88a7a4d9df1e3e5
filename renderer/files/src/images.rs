//! Images: PNG and JPEG (sRGB), OpenEXR and Radiance HDR (linear); how alike two are.

mod decode;
mod layers;
pub(crate) mod png;
mod quality;

use std::fmt::Display;
use std::io::Cursor;
use std::path::Path;
use std::sync::LazyLock;

use decode::{Convert, Decoded, Stored};
use image::codecs::hdr::HdrEncoder;
use image::codecs::openexr::OpenExrEncoder;
use image::{ExtendedColorType, ImageEncoder, ImageFormat, ImageResult, Rgb};
pub use layers::{load_pass, save_passes};
use png::png_bytes;
pub use quality::Quality;
use renderer_core::display::map_range;
use renderer_core::{Error, Image};

use crate::disk::{check_writable, read, write_atomically};

#[cfg(test)]
mod tests;

/// An image from a file.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadedImage {
    /// The pixels of the image.
    pub image: Image,
    /// Whether the file cannot hold values above 1 (PNG and JPEG): there, a channel that is 1 may
    /// have been brighter when the picture was taken.
    pub saturates: bool,
}

/// Reads a PNG, JPEG, OpenEXR or Radiance HDR file; what it is, its content decides, not its name.
///
/// PNG and JPEG, grey or RGB, of 8 or 16 bits, are taken as sRGB and decoded to linear values;
/// colour profiles and gamma chunks are ignored. Where there is alpha, the picture is composited
/// over black, as the renderer's own background is. The orientation that a camera noted in a JPEG
/// is applied. OpenEXR and HDR are taken as they are: linear, and colours already multiplied by alpha.
///
/// # Errors
///
/// If the file cannot be read or decoded, or a pixel of it is infinite or not a number.
pub fn load_image(path: &Path) -> Result<LoadedImage, Error> {
    let over_black = |stored: Stored, _: bool| match stored {
        Stored::Srgb([r, g, b, alpha]) => {
            let coverage = f64::from(alpha) / MOST;
            [r, g, b].map(|level| (LINEAR[usize::from(level)] * coverage) as f32)
        }
        Stored::Linear([r, g, b, _]) => [r, g, b],
    };
    let decoded = decode(&read(path)?, path.display(), over_black)?;
    Ok(LoadedImage { image: decoded.image, saturates: decoded.is_srgb })
}

/// How much each pixel of an image file counts, as grey pixels: its alpha, or, where it has none, the mean of
/// its channels as they are stored, from 0 to 1 in PNG and JPEG.
///
/// # Errors
///
/// As [`load_image`], and if a pixel of an OpenEXR file is below 0.
pub fn load_mask(path: &Path) -> Result<Image, Error> {
    let mask = decode_coverage(&read(path)?, path.display(), true)?;
    if mask.pixels.iter().any(|[value, ..]| *value < 0.0) {
        return Err(Error::new(
            path.display(),
            "a pixel is below 0: it cannot count for less than nothing",
        ));
    }
    Ok(mask)
}

/// The texels of a texture, and whether its file says that some of them are transparent.
#[doc(hidden)]
pub struct TextureFile {
    pub image: Image,
    pub is_transparent: bool,
}

/// Decodes the bytes of an image file at `place` as [`load_image`] does, but for alpha: the colours of
/// a texture are what the file says, whatever covers them.
#[doc(hidden)]
pub fn decode_texture(bytes: &[u8], place: impl Display) -> Result<TextureFile, Error> {
    let whole = |stored: Stored, _: bool| match stored {
        Stored::Srgb([r, g, b, _]) => [r, g, b].map(|level| LINEAR[usize::from(level)] as f32),
        Stored::Linear([r, g, b, _]) => [r, g, b],
    };
    let Decoded { image, is_transparent, .. } = decode(bytes, place, whole)?;
    Ok(TextureFile { image, is_transparent })
}

/// Decodes the channels of an image file at `place` as they are stored, but for alpha.
#[doc(hidden)]
pub fn decode_data(bytes: &[u8], place: impl Display) -> Result<Image, Error> {
    let data = |stored: Stored, _: bool| {
        let [r, g, b, _] = stored.values();
        [r, g, b]
    };
    Ok(decode(bytes, place, data)?.image)
}

/// Decodes how much the bytes of an image file at `place` cover, as grey texels: its alpha, or, where it
/// has none and is a mask, the mean of its channels as they are stored, else everything.
#[doc(hidden)]
pub fn decode_coverage(bytes: &[u8], place: impl Display, is_mask: bool) -> Result<Image, Error> {
    let coverage = |stored: Stored, has_alpha: bool| match (stored.values(), has_alpha) {
        ([.., alpha], true) => [alpha; 3],
        (_, false) => [1.0; 3],
    };
    let mask = |stored: Stored, has_alpha: bool| match (stored.values(), has_alpha) {
        ([.., alpha], true) => [alpha; 3],
        ([r, g, b, _], false) => [(r + g + b) / 3.0; 3],
    };
    let convert: Convert = if is_mask { mask } else { coverage };
    Ok(decode(bytes, place, convert)?.image)
}

/// Turns what measures shapes into a picture whose levels are in proportion to it, black at the lower end of a
/// range and below, white at the upper one and beyond.
#[doc(hidden)]
pub fn picture_of_measure(image: &mut Image, (low, high): (f32, f32)) {
    map_range(image, low, high);
    let values = image.pixels.as_flattened_mut();
    values
        .iter_mut()
        .for_each(|value| *value = srgb_decode(f64::from(value.clamp(0.0, 1.0))) as f32);
}

/// Writes an 8 bit sRGB PNG. Values are clamped to `[0, 1]`, encoded and rounded to the nearest
/// level.
///
/// # Errors
///
/// If the image has no area, a pixel is infinite or not a number, or the file cannot be written.
pub fn save_png(image: &Image, path: &Path) -> Result<(), Error> {
    check(image, path.display())?;
    write_atomically(path, &png_bytes(image, path.display())?)
}

/// Writes an OpenEXR image of 32 bit floats, exactly as they are.
///
/// # Errors
///
/// If the image has no area, a pixel is infinite or not a number, or the file cannot be written.
pub fn save_exr(image: &Image, path: &Path) -> Result<(), Error> {
    check(image, path.display())?;
    write_atomically(path, &exr_bytes(image).map_err(|error| not_encoded(path.display(), error))?)
}

/// The file of an image of 32 bit floats.
fn exr_bytes(image: &Image) -> ImageResult<Vec<u8>> {
    let samples: Vec<u8> =
        image.pixels.as_flattened().iter().flat_map(|v| v.to_ne_bytes()).collect();
    let mut bytes = Cursor::new(Vec::new());
    OpenExrEncoder::new(&mut bytes).write_image(
        &samples,
        image.width,
        image.height,
        ExtendedColorType::Rgb32F,
    )?;
    Ok(bytes.into_inner())
}

/// Writes a Radiance HDR image: three mantissas of 8 bits with one exponent for each pixel. What is negative
/// becomes 0.
///
/// # Errors
///
/// If the image has no area, a pixel is infinite or not a number, or the file cannot be written.
pub fn save_hdr(image: &Image, path: &Path) -> Result<(), Error> {
    check(image, path.display())?;
    // Below this the exponent of the format has no room.
    const DARKEST: f32 = 1e-38;
    let rgbe = |pixel: &[f32; 3]| {
        let is_dark = pixel.iter().all(|&v| v < DARKEST);
        Rgb(pixel.map(|v| if is_dark { 0.0 } else { v.max(0.0) }))
    };
    let pixels: Vec<_> = image.pixels.iter().map(rgbe).collect();
    let mut bytes = Vec::new();
    HdrEncoder::new(&mut bytes)
        .encode(&pixels, image.width as usize, image.height as usize)
        .map_err(|error| not_encoded(path.display(), error))?;
    write_atomically(path, &bytes)
}

/// Writes an image in the format that the extension of `path` names: `png`, `exr` or `hdr`.
///
/// # Errors
///
/// If the extension is another one, the image has no area, a pixel is infinite or not a number, or
/// the file cannot be written.
pub fn save_image(image: &Image, path: &Path) -> Result<(), Error> {
    match output_format(path)? {
        OutputFormat::Png => save_png(image, path),
        OutputFormat::Exr => save_exr(image, path),
        OutputFormat::Hdr => save_hdr(image, path),
    }
}

/// Whether [`save_image`] could write to `path`, asked before the work that makes the image.
///
/// # Errors
///
/// If the extension is neither `png`, `exr` nor `hdr`, the folder does not exist, or `path` is a
/// directory.
pub fn check_image_path(path: &Path) -> Result<(), Error> {
    output_format(path)?;
    check_writable(path)
}

#[derive(Clone, Copy)]
enum OutputFormat {
    Png,
    Exr,
    Hdr,
}

fn output_format(path: &Path) -> Result<OutputFormat, Error> {
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or("").to_ascii_lowercase();
    match extension.as_str() {
        "png" => Ok(OutputFormat::Png),
        "exr" => Ok(OutputFormat::Exr),
        "hdr" => Ok(OutputFormat::Hdr),
        _ => Err(Error::new(
            path.display(),
            "images are written as .png (8 bit sRGB), .exr (linear float) or .hdr (linear, 8 bits)",
        )),
    }
}

/// Decodes the bytes of an image file at `place`.
fn decode(bytes: &[u8], place: impl Display, convert: Convert) -> Result<Decoded, Error> {
    if bytes.is_empty() {
        return Err(Error::new(place, "is empty, not an image"));
    }
    let decoded = decode::decode(bytes, convert).map_err(|problem| Error::new(&place, problem))?;
    check(&decoded.image, place)?;
    Ok(decoded)
}

/// Whether the bytes of a file are those of an image of a format that is read, whole or broken; what is
/// empty is broken.
#[doc(hidden)]
pub fn is_known(bytes: &[u8]) -> bool {
    let read = [ImageFormat::Png, ImageFormat::Jpeg, ImageFormat::OpenExr, ImageFormat::Hdr];
    bytes.is_empty() || image::guess_format(bytes).is_ok_and(|format| read.contains(&format))
}

/// The largest stored level: every 8 and 16 bit format maps to 16 bits without loss, 255 to this.
const MOST: f64 = u16::MAX as f64;

impl Stored {
    /// What is stored, on a scale that ends at 1 for levels.
    fn values(self) -> [f32; 4] {
        match self {
            Self::Srgb(levels) => levels.map(|level| (f64::from(level) / MOST) as f32),
            Self::Linear(values) => values,
        }
    }
}

/// The linear values of the stored levels.
static LINEAR: LazyLock<Vec<f64>> =
    LazyLock::new(|| (0..=u16::MAX).map(|v| srgb_decode(f64::from(v) / MOST)).collect());

/// The linear value of an sRGB value in `[0, 1]` (IEC 61966-2-1).
#[doc(hidden)]
pub fn srgb_decode(encoded: f64) -> f64 {
    if encoded <= 0.04045 { encoded / 12.92 } else { ((encoded + 0.055) / 1.055).powf(2.4) }
}

/// The sRGB value of a linear one; both are clipped to `[0, 1]`.
#[doc(hidden)]
pub fn srgb_encode(linear: f32) -> f64 {
    let linear = f64::from(linear).clamp(0.0, 1.0);
    if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 }
}

/// The 8 bit sRGB level of a linear value.
pub(crate) fn srgb_level(linear: f32) -> u8 {
    (255.0 * srgb_encode(linear)).round() as u8
}

/// Whether the image has as many pixels as it says, at least one, and all are finite.
fn check(image: &Image, place: impl Display) -> Result<(), Error> {
    let (width, height, pixels) = (image.width, image.height, image.pixels.len());
    if pixels == 0 || pixels as u64 != u64::from(width) * u64::from(height) {
        let problem = format!("{pixels} pixels are no image of {width} by {height}");
        return Err(Error::new(place, problem));
    }
    let channels = image.pixels.as_flattened();
    let Some(first) = channels.iter().position(|v| !v.is_finite()) else { return Ok(()) };
    let (pixel, channel) = (first / 3, first % 3);
    let (x, y) = (pixel % image.width as usize, pixel / image.width as usize);
    let channel = ["red", "green", "blue"][channel];
    Err(Error::new(
        place,
        format!("{channel} at column {x}, row {y} is {}, not a finite number", channels[first]),
    ))
}

fn not_encoded(place: impl Display, error: impl ToString) -> Error {
    Error::new(place, format!("cannot be encoded: {}", one_line(error)))
}

fn one_line(error: impl ToString) -> String {
    error.to_string().split_whitespace().collect::<Vec<_>>().join(" ")
}
