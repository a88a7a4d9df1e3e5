//! PNG files in memory.

use std::fmt::Display;

use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder};
use renderer_core::{Error, Image};

use super::{not_encoded, srgb_level};

/// The bytes of a PNG of levels of 8 bits. `place` names the image in errors.
pub(crate) fn encode(
    levels: &[u8],
    [width, height]: [u32; 2],
    kind: ExtendedColorType,
    place: impl Display,
) -> Result<Vec<u8>, Error> {
    let mut bytes = Vec::new();
    PngEncoder::new(&mut bytes)
        .write_image(levels, width, height, kind)
        .map_err(|error| not_encoded(place, error))?;
    Ok(bytes)
}

/// The bytes that [`save_png`](super::save_png) writes.
pub fn png_bytes(image: &Image, place: impl Display) -> Result<Vec<u8>, Error> {
    let levels: Vec<u8> = image.pixels.as_flattened().iter().map(|&v| srgb_level(v)).collect();
    encode(&levels, [image.width, image.height], ExtendedColorType::Rgb8, place)
}
