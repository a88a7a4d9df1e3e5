//! JPEG.

use std::io::Cursor;

use zune_jpeg::JpegDecoder;
use zune_jpeg::zune_core::colorspace::ColorSpace;
use zune_jpeg::zune_core::options::DecoderOptions;

use super::canvas::{Decoded, Size, Source, Stored};
use super::not_decoded;
use super::orientation::Orientation;

/// Decodes the pixels of a JPEG file.
pub fn read(source: &Source<'_>) -> Result<Decoded, String> {
    let options = DecoderOptions::default().set_max_width(usize::MAX).set_max_height(usize::MAX);
    let mut decoder = JpegDecoder::new_with_options(Cursor::new(source.bytes), options);
    decoder.decode_headers().map_err(not_decoded)?;
    let is_grey = decoder.input_colorspace() == Some(ColorSpace::Luma);
    let (width, height) = decoder.dimensions().ok_or_else(|| not_decoded("it has no size"))?;
    let orientation = Orientation::of(decoder.exif().map(Vec::as_slice));
    // JPEG has 16 bits for either.
    let (width, height) = (width as u32, height as u32);
    let mut canvas = source.canvas(Size { width, height, has_alpha: false, orientation })?;
    let (channels, space) = if is_grey { (1, ColorSpace::Luma) } else { (3, ColorSpace::RGB) };
    decoder.set_options(options.jpeg_set_out_colorspace(space));
    let levels = decoder.decode().map_err(not_decoded)?;
    for (pixel, index) in levels.chunks_exact(channels).zip(0..width * height) {
        let [r, g, b] = [0, channels / 3, 2 * (channels / 3)].map(|at| 257 * u16::from(pixel[at]));
        canvas.put(index % width, index / width, Stored::Srgb([r, g, b, u16::MAX]));
    }
    Ok(canvas.finish())
}
