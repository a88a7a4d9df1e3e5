//! From the bytes of an image file to pixels.

use std::io::Cursor;

use image::metadata::Orientation;
use image::{
    ColorType, DynamicImage, ImageBuffer, ImageDecoder, ImageFormat, ImageReader, Limits, Rgb,
};
use renderer_core::{Image, memory};

use super::one_line;

/// A pixel as a file stores it, with its alpha, which is the most where the file has none.
#[derive(Clone, Copy)]
pub enum Stored {
    /// Levels of sRGB, and a linear alpha.
    Srgb([u16; 4]),
    /// Linear values.
    Linear([f32; 4]),
}

/// The pixel that a stored one becomes; the second argument says whether the file has alpha.
pub type Convert = fn(Stored, bool) -> [f32; 3];

/// The image of a file.
pub struct Decoded {
    pub image: Image,
    /// Whether the file cannot hold values above 1.
    pub is_srgb: bool,
    /// Whether any pixel is less than fully opaque.
    pub is_transparent: bool,
}

/// More pixels no byte of a file stands for: a blank PNG, of one bit per pixel, has 8256, blank JPEG and
/// OpenEXR images have 512. An OpenEXR header may announce millions around data of a few.
const MOST_PIXELS_PER_BYTE: u64 = 10_000;

/// The most memory for what stands beside the pixels, such as texts and colour profiles.
const MOST_BESIDE: u64 = 64 << 20;

/// Decodes an image file: each pixel as it is stored, and whether the file has alpha, become the pixel
/// that `convert` makes of it. Pixels are converted one by one, so that there are no others in memory than
/// the stored ones and those of the result.
pub fn decode(bytes: &[u8], convert: Convert) -> Result<Decoded, String> {
    let not_decoded = |error| format!("cannot be decoded: {}", one_line(error));
    let mut reader = ImageReader::new(Cursor::new(bytes))
        .with_guessed_format()
        .map_err(|error| format!("cannot be read: {error}"))?;
    let is_srgb = match reader.format() {
        Some(ImageFormat::Jpeg) if is_cut_off(bytes) => {
            let problem = "cannot be decoded: the file is cut off, it has no end of the image";
            return Err(problem.to_owned());
        }
        Some(ImageFormat::Png | ImageFormat::Jpeg) => true,
        Some(ImageFormat::OpenExr | ImageFormat::Hdr) => false,
        _ => return Err("is not a PNG, JPEG, OpenEXR or Radiance HDR image".to_owned()),
    };
    let mut limits = Limits::no_limits();
    limits.max_alloc = Some(MOST_BESIDE);
    reader.limits(limits);
    let mut decoder = reader.into_decoder().map_err(not_decoded)?;
    // An orientation that cannot be read is none.
    let orientation = decoder.orientation().unwrap_or(Orientation::NoTransforms);
    let ((width, height), color) = (decoder.dimensions(), decoder.color_type());
    let pixels = u64::from(width) * u64::from(height);
    if pixels > MOST_PIXELS_PER_BYTE * bytes.len() as u64 {
        let size = bytes.len();
        return Err(format!("{size} bytes cannot hold the {width} x {height} pixels it has"));
    }
    memory::ask(decoder.total_bytes().saturating_add(pixels * size_of::<[f32; 3]>() as u64))
        .map_err(|problem| format!("{width} x {height} pixels: {problem}"))?;
    let mut stored = vec![0; decoder.total_bytes() as usize];
    decoder.read_image(&mut stored).map_err(not_decoded)?;

    let mut is_transparent = false;
    let mut image = Image { width, height, pixels: Vec::with_capacity(pixels as usize) };
    for pixel in stored.chunks_exact(color.bytes_per_pixel().into()) {
        let pixel = stored_pixel(pixel, color);
        is_transparent |= match pixel {
            Stored::Srgb([.., alpha]) => alpha < u16::MAX,
            Stored::Linear([.., alpha]) => alpha < 1.0,
        };
        image.pixels.push(convert(pixel, color.has_alpha()));
    }
    drop(stored);
    if orientation != Orientation::NoTransforms {
        image = turned(image, orientation);
    }
    Ok(Decoded { image, is_srgb, is_transparent })
}

/// Whether a JPEG file has no end of the image (the marker EOI) behind the start of its last scan (SOS; ITU-T T.81,
/// B.1.1.3). Its decoder makes rows of its own of those that are missing.
fn is_cut_off(bytes: &[u8]) -> bool {
    let last = |marker: [u8; 2]| bytes.array_windows().rposition(|pair| *pair == marker);
    last([0xFF, 0xD9]) < last([0xFF, 0xDA])
}

/// The picture as the camera was held.
fn turned(image: Image, orientation: Orientation) -> Image {
    let buffer = ImageBuffer::from_fn(image.width, image.height, |x, y| {
        Rgb(image.pixels[y as usize * image.width as usize + x as usize])
    });
    let mut turned = DynamicImage::ImageRgb32F(buffer);
    turned.apply_orientation(orientation);
    let (width, height) = (turned.width(), turned.height());
    Image { width, height, pixels: turned.into_rgb32f().pixels().map(|pixel| pixel.0).collect() }
}

/// A pixel of this type. Every 8 and 16 bit level maps to 16 bits without loss: 255 to 65535.
fn stored_pixel(bytes: &[u8], color: ColorType) -> Stored {
    let (channels, alpha) = (usize::from(color.channel_count()), color.has_alpha());
    match usize::from(color.bytes_per_pixel()) / channels {
        1 => Stored::Srgb(spread(channels, alpha, u16::MAX, |at| 257 * u16::from(bytes[at]))),
        2 => {
            let levels = bytes.as_chunks().0;
            Stored::Srgb(spread(channels, alpha, u16::MAX, |at| u16::from_ne_bytes(levels[at])))
        }
        _ => {
            let values = bytes.as_chunks().0;
            Stored::Linear(spread(channels, alpha, 1.0, |at| f32::from_ne_bytes(values[at])))
        }
    }
}

/// Red, green, blue and alpha from channels of which there may be fewer.
fn spread<T>(channels: usize, has_alpha: bool, most: T, channel: impl Fn(usize) -> T) -> [T; 4] {
    let [green, blue] = if channels < 3 { [0, 0] } else { [1, 2] };
    let alpha = if has_alpha { channel(channels - 1) } else { most };
    [channel(0), channel(green), channel(blue), alpha]
}
