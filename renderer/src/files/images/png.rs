//! PNG.

use std::io::Cursor;

use png::{BitDepth, ColorType, Decoder, Encoder, EncodingError, Limits, Transformations};

use super::canvas::{Decoded, Size, Source, Stored};
use super::not_decoded;
use super::orientation::Orientation;

/// The most memory for what stands beside the pixels, such as texts and colour profiles.
const MOST_BESIDE: usize = 64 << 20;

/// Decodes the pixels of a PNG file, row by row.
pub fn read(source: &Source<'_>) -> Result<Decoded, String> {
    let limits = Limits { bytes: MOST_BESIDE };
    let mut decoder = Decoder::new_with_limits(Cursor::new(source.bytes), limits);
    decoder.set_transformations(Transformations::EXPAND);
    let mut reader = decoder.read_info().map_err(not_decoded)?;
    let (color, depth) = reader.output_color_type();
    let (channels, has_alpha) = match color {
        ColorType::Grayscale => (1, false),
        ColorType::GrayscaleAlpha => (2, true),
        ColorType::Rgba => (4, true),
        ColorType::Rgb | ColorType::Indexed => (3, false),
    };
    let info = reader.info();
    let orientation = Orientation::of(info.exif_metadata.as_deref());
    let (width, height, is_interlaced) = (info.width, info.height, info.interlaced);
    let mut canvas = source.canvas(Size { width, height, has_alpha, orientation })?;
    let mut put_row = |y: u32, row: &[u8]| {
        let mut pixel = [0; 4];
        let mut put = |x: usize, level: &dyn Fn(usize) -> u16| {
            (0..channels).for_each(|channel| pixel[channel] = level(channels * x + channel));
            let [first, second, third, fourth] = pixel;
            let levels = match channels {
                1 => [first, first, first, u16::MAX],
                2 => [first, first, first, second],
                3 => [first, second, third, u16::MAX],
                _ => [first, second, third, fourth],
            };
            canvas.put(x as u32, y, Stored::Srgb(levels));
        };
        for x in 0..width as usize {
            match depth {
                BitDepth::Sixteen => {
                    put(x, &|at| u16::from_be_bytes([row[2 * at], row[2 * at + 1]]))
                }
                _ => put(x, &|at| 257 * u16::from(row[at])),
            }
        }
    };
    if is_interlaced {
        let size = reader.output_buffer_size().ok_or_else(|| not_decoded("it is too large"))?;
        let mut frame = vec![0; size];
        let info = reader.next_frame(&mut frame).map_err(not_decoded)?;
        frame.chunks_exact(info.line_size).zip(0..height).for_each(|(row, y)| put_row(y, row));
    } else {
        for y in 0..height {
            let row = reader.next_row().map_err(not_decoded)?;
            put_row(y, row.ok_or_else(|| not_decoded("rows are missing"))?.data());
        }
    }
    Ok(canvas.finish())
}

/// The file of an image of 8 bits for each of red, green and blue.
pub fn encode(levels: &[u8], width: u32, height: u32) -> Result<Vec<u8>, EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, width, height);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    encoder.write_header()?.write_image_data(levels)?;
    Ok(bytes)
}
