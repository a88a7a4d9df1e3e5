//! PNG files in memory.

use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder};

use crate::Error;

/// The bytes of a PNG of levels of 8 bits. `place` names the image in errors.
pub(super) fn encode(
    levels: &[u8],
    [width, height]: [u32; 2],
    kind: ExtendedColorType,
    place: &str,
) -> Result<Vec<u8>, Error> {
    let mut bytes = Vec::new();
    PngEncoder::new(&mut bytes)
        .write_image(levels, width, height, kind)
        .map_err(|error| Error::new(place, format!("cannot be encoded: {error}")))?;
    Ok(bytes)
}

/// The bytes that [`save_png`](super::save_png) writes.
#[cfg(feature = "cli")]
pub(crate) fn png_bytes(image: &crate::Image) -> Result<Vec<u8>, Error> {
    let level = |&value: &f32| (255.0 * super::images::srgb_encode(value)).round() as u8;
    let levels: Vec<u8> = image.pixels.as_flattened().iter().map(level).collect();
    encode(&levels, [image.width, image.height], ExtendedColorType::Rgb8, "an image")
}
