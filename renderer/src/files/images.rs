//! Images: PNG and JPEG (sRGB), OpenEXR (linear).

use std::fmt::Display;
use std::io::Cursor;
use std::path::Path;

use image::codecs::openexr::OpenExrEncoder;
use image::codecs::png::PngEncoder;
use image::{
    DynamicImage, ExtendedColorType, GenericImageView, ImageDecoder, ImageEncoder, ImageFormat,
    ImageReader, ImageResult, Limits, Rgba, metadata::Orientation,
};

use crate::Error;
use crate::Image;
use crate::disk::read;
use crate::disk::{check_writable, write_atomically};

#[cfg(test)]
mod tests;

/// An image from a file.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadedImage {
    /// Its pixels.
    pub image: Image,
    /// Whether the file cannot hold values above 1 (PNG and JPEG): there, a channel that is 1 may
    /// have been brighter when the picture was taken.
    pub saturates: bool,
}

/// Reads a PNG, JPEG or OpenEXR file; what it is, its content decides, not its name.
///
/// PNG and JPEG, grey or RGB, of 8 or 16 bits, are taken as sRGB and decoded to linear values;
/// colour profiles and gamma chunks are ignored. Where there is alpha, the picture is composited
/// over black, as the renderer's own background is. The orientation that a camera noted in a JPEG
/// is applied. OpenEXR is taken as it is: linear, and its colours already multiplied by alpha.
///
/// # Errors
///
/// If the file cannot be read or decoded, or a pixel of it is infinite or not a number.
pub fn load_image(path: &Path) -> Result<LoadedImage, Error> {
    let (decoded, saturates) = decode(&read(path)?, path.display())?;
    let image = if saturates {
        from_srgb(decoded, |color, coverage| color * coverage)
    } else {
        from_linear(decoded)
    };
    check(&image, path.display())?;
    Ok(LoadedImage { image, saturates })
}

/// The texels of a texture, and whether its file says that some of them are transparent.
pub(super) struct TextureFile {
    pub image: Image,
    pub is_transparent: bool,
}

/// Decodes the bytes of an image file at `place` as [`load_image`] does, but for alpha: the colours of
/// a texture are what the file says, whatever covers them.
pub(super) fn decode_texture(bytes: &[u8], place: impl Display) -> Result<TextureFile, Error> {
    let (decoded, is_srgb) = decode(bytes, &place)?;
    let is_transparent =
        decoded.color().has_alpha() && decoded.pixels().any(|(_, _, pixel)| pixel.0[3] < u8::MAX);
    let image = if is_srgb { from_srgb(decoded, |color, _| color) } else { from_linear(decoded) };
    check(&image, place)?;
    Ok(TextureFile { image, is_transparent })
}

/// Decodes how much the bytes of an image file at `place` cover, as grey texels: its alpha, or, where it
/// has none and is a mask, the mean of its channels as they are stored, else everything.
pub(super) fn decode_coverage(
    bytes: &[u8],
    place: impl Display,
    is_mask: bool,
) -> Result<Image, Error> {
    let (decoded, _) = decode(bytes, &place)?;
    let has_alpha = decoded.color().has_alpha();
    let decoded = decoded.into_rgba32f();
    let coverage = |&Rgba([r, g, b, alpha]): &Rgba<f32>| match (has_alpha, is_mask) {
        (true, _) => [alpha; 3],
        (false, true) => [(r + g + b) / 3.0; 3],
        (false, false) => [1.0; 3],
    };
    let pixels = decoded.pixels().map(coverage).collect();
    let image = Image { width: decoded.width(), height: decoded.height(), pixels };
    check(&image, place)?;
    Ok(image)
}

/// Writes an 8 bit sRGB PNG. Values are clamped to `[0, 1]`, encoded and rounded to the nearest
/// level.
///
/// # Errors
///
/// If the image has no area, a pixel is infinite or not a number, or the file cannot be written.
pub fn save_png(image: &Image, path: &Path) -> Result<(), Error> {
    check(image, path.display())?;
    let levels: Vec<u8> = image.pixels.as_flattened().iter().map(|&v| srgb_level(v)).collect();
    let mut bytes = Vec::new();
    PngEncoder::new(&mut bytes)
        .write_image(&levels, image.width, image.height, ExtendedColorType::Rgb8)
        .map_err(|error| not_encoded(path, error))?;
    write_atomically(path, &bytes)
}

/// Writes an OpenEXR image of 32 bit floats, exactly as they are.
///
/// # Errors
///
/// If the image has no area, a pixel is infinite or not a number, or the file cannot be written.
pub fn save_exr(image: &Image, path: &Path) -> Result<(), Error> {
    check(image, path.display())?;
    let samples: Vec<u8> =
        image.pixels.as_flattened().iter().flat_map(|v| v.to_ne_bytes()).collect();
    let mut bytes = Cursor::new(Vec::new());
    OpenExrEncoder::new(&mut bytes)
        .write_image(&samples, image.width, image.height, ExtendedColorType::Rgb32F)
        .map_err(|error| not_encoded(path, error))?;
    write_atomically(path, bytes.get_ref())
}

/// Writes an image in the format that the extension of `path` names: `png` or `exr`.
///
/// # Errors
///
/// If the extension is another one, the image has no area, a pixel is infinite or not a number, or
/// the file cannot be written.
pub fn save_image(image: &Image, path: &Path) -> Result<(), Error> {
    match output_format(path)? {
        OutputFormat::Png => save_png(image, path),
        OutputFormat::Exr => save_exr(image, path),
    }
}

/// Whether [`save_image`] could write to `path`, asked before the work that makes the image.
///
/// # Errors
///
/// If the extension is neither `png` nor `exr`, the folder does not exist, or `path` is a
/// directory.
pub fn check_image_path(path: &Path) -> Result<(), Error> {
    output_format(path)?;
    check_writable(path)
}

#[derive(Clone, Copy)]
enum OutputFormat {
    Png,
    Exr,
}

fn output_format(path: &Path) -> Result<OutputFormat, Error> {
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or("").to_ascii_lowercase();
    match extension.as_str() {
        "png" => Ok(OutputFormat::Png),
        "exr" => Ok(OutputFormat::Exr),
        _ => Err(Error::new(
            path.display(),
            "images are written as .png (8 bit sRGB) or .exr (linear float)",
        )),
    }
}

/// The most memory that the pixels of a file may take: 128 million pixels of four floats.
const MOST_BYTES: u64 = 1 << 31;

/// More pixels no byte of a file stands for: a blank PNG, of one bit per pixel, has 8256, blank JPEG and
/// OpenEXR images have 512. An OpenEXR header may announce millions around data of a few.
const MOST_PIXELS_PER_BYTE: u64 = 10_000;

/// The pixels of a file, and whether they are sRGB and clipped at 1.
fn decode(bytes: &[u8], place: impl Display) -> Result<(DynamicImage, bool), Error> {
    let refuse = |problem: String| Error::new(&place, problem);
    if bytes.is_empty() {
        return Err(refuse("is empty, not an image".to_owned()));
    }
    let reader = ImageReader::new(Cursor::new(bytes))
        .with_guessed_format()
        .map_err(|error| refuse(format!("cannot be read: {error}")))?;
    let is_srgb = match reader.format() {
        Some(ImageFormat::Png | ImageFormat::Jpeg) => true,
        Some(ImageFormat::OpenExr) => false,
        _ => return Err(refuse("is not a PNG, JPEG or OpenEXR image".to_owned())),
    };
    let not_decoded = |error| refuse(format!("cannot be decoded: {}", one_line(error)));
    let decoder = reader.into_decoder().map_err(not_decoded)?;
    let (width, height) = decoder.dimensions();
    if u64::from(width) * u64::from(height) > MOST_PIXELS_PER_BYTE * bytes.len() as u64 {
        let size = bytes.len();
        return Err(refuse(format!(
            "{size} bytes cannot hold the {width} x {height} pixels it has"
        )));
    }
    Ok((pixels(decoder).map_err(not_decoded)?, is_srgb))
}

fn pixels(mut decoder: impl ImageDecoder) -> ImageResult<DynamicImage> {
    // A broken header may announce any size; memory is taken before the pixels are there.
    let mut limits = Limits::no_limits();
    limits.max_alloc = Some(MOST_BYTES);
    limits.reserve(decoder.total_bytes())?;
    // An orientation that cannot be read is none.
    let orientation = decoder.orientation().unwrap_or(Orientation::NoTransforms);
    let mut decoded = DynamicImage::from_decoder(decoder)?;
    decoded.apply_orientation(orientation);
    Ok(decoded)
}

/// Linear colours, each `covered` by alpha.
fn from_srgb(decoded: DynamicImage, covered: impl Fn(f64, f64) -> f64) -> Image {
    // Every 8 and 16 bit format maps to 16 bits without loss: 255 to 65535, grey to three channels.
    let decoded = decoded.into_rgba16();
    let linear: Vec<f64> = (0..=u16::MAX).map(|v| srgb_decode(f64::from(v) / 65535.0)).collect();
    let pixels = decoded
        .pixels()
        .map(|pixel| {
            let [r, g, b, alpha] = pixel.0;
            let coverage = f64::from(alpha) / 65535.0;
            [r, g, b].map(|v| covered(linear[usize::from(v)], coverage) as f32)
        })
        .collect();
    Image { width: decoded.width(), height: decoded.height(), pixels }
}

fn from_linear(decoded: DynamicImage) -> Image {
    let decoded = decoded.into_rgba32f();
    let pixels = decoded.pixels().map(|pixel| [pixel.0[0], pixel.0[1], pixel.0[2]]).collect();
    Image { width: decoded.width(), height: decoded.height(), pixels }
}

/// The linear value of an sRGB value in `[0, 1]` (IEC 61966-2-1).
fn srgb_decode(encoded: f64) -> f64 {
    if encoded <= 0.04045 { encoded / 12.92 } else { ((encoded + 0.055) / 1.055).powf(2.4) }
}

/// The 8 bit sRGB level of a linear value.
fn srgb_level(linear: f32) -> u8 {
    let linear = f64::from(linear).clamp(0.0, 1.0);
    let encoded =
        if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 };
    (255.0 * encoded).round() as u8
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

fn not_encoded(path: &Path, error: image::ImageError) -> Error {
    Error::new(path.display(), format!("cannot be encoded: {}", one_line(error)))
}

fn one_line(error: impl ToString) -> String {
    error.to_string().split_whitespace().collect::<Vec<_>>().join(" ")
}
