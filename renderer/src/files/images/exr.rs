//! OpenEXR.

use std::io::Cursor;

use exr::prelude::{
    Error, Image as ExrImage, IntegerBounds, ReadChannels, ReadLayers, SpecificChannels, Text,
    Vec2, WritableImage,
};

use super::canvas::{Canvas, Decoded, Size, Source, Stored};
use super::not_decoded;
use super::orientation::Orientation;
use crate::Image;

/// Decodes the first image of an OpenEXR file that has red, green and blue: what it shows through its
/// display window, black where there are no data.
pub fn read(source: &Source<'_>) -> Result<Decoded, String> {
    let chunks = exr::block::read(Cursor::new(source.bytes), false).map_err(not_decoded)?;
    let has = |header: &&exr::meta::header::Header, channel: &str| {
        header.channels.find_index_of_channel(&Text::from(channel)).is_some()
    };
    let header = chunks
        .headers()
        .iter()
        .find(|header| !header.deep && ["R", "G", "B"].iter().all(|name| has(header, name)))
        .ok_or_else(|| not_decoded("it has no red, green and blue"))?;
    let window: IntegerBounds = header.shared_attributes.display_window;
    let offset = header.own_attributes.layer_position - window.position;
    let too_large = |_| not_decoded("it is too large");
    let width = u32::try_from(window.size.width()).map_err(too_large)?;
    let height = u32::try_from(window.size.height()).map_err(too_large)?;
    let has_alpha = has(&header, "A");
    let size = Size { width, height, has_alpha, orientation: Orientation::default() };
    source.check(size)?;
    let convert = source.convert;
    let (offset_x, offset_y) = (i64::from(offset.x()), i64::from(offset.y()));
    let decoded = exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level()
        .rgba_channels(
            move |_, _| Canvas::new(size, convert),
            move |canvas: &mut Canvas, at: Vec2<usize>, pixel: (f32, f32, f32, f32)| {
                let (x, y) = (at.x() as i64 + offset_x, at.y() as i64 + offset_y);
                if (0..i64::from(width)).contains(&x) && (0..i64::from(height)).contains(&y) {
                    canvas.put(x as u32, y as u32, Stored::Linear(pixel.into()));
                }
            },
        )
        .first_valid_layer()
        .all_attributes()
        .from_chunks(chunks)
        .map_err(not_decoded)?;
    Ok(Decoded { is_srgb: false, ..decoded.layer_data.channel_data.pixels.finish() })
}

/// The file of an image of 32 bit floats.
pub fn encode(image: &Image) -> Result<Vec<u8>, Error> {
    let width = image.width as usize;
    let pixel = |at: Vec2<usize>| image.pixels[at.y() * width + at.x()].into();
    let channels = SpecificChannels::rgb(|at| -> (f32, f32, f32) { pixel(at) });
    let mut bytes = Cursor::new(Vec::new());
    ExrImage::from_channels((width, image.height as usize), channels)
        .write()
        .to_buffered(&mut bytes)?;
    Ok(bytes.into_inner())
}
