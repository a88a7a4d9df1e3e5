//! The pixels of an image while they are decoded.

use super::orientation::Orientation;
use crate::{Image, memory};

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

/// What a decoder knows before the first pixel.
#[derive(Clone, Copy)]
pub struct Size {
    /// Columns as they are stored.
    pub width: u32,
    /// Rows as they are stored.
    pub height: u32,
    /// Whether pixels have an alpha.
    pub has_alpha: bool,
    /// How the picture is turned.
    pub orientation: Orientation,
}

/// The image of a file.
pub struct Decoded {
    pub image: Image,
    /// Whether the file cannot hold values above 1.
    pub is_srgb: bool,
    /// Whether the alpha of a pixel is less than the most.
    pub is_transparent: bool,
}

/// The bytes of a file, and what becomes of its pixels.
pub struct Source<'a> {
    pub bytes: &'a [u8],
    pub convert: Convert,
}

/// More pixels no byte of a file stands for: a blank PNG, of one bit per pixel, has 8256, blank JPEG and
/// OpenEXR images have 512. An OpenEXR header may announce millions around data of a few.
const MOST_PIXELS_PER_BYTE: u64 = 10_000;

/// What a pixel takes while it is decoded: what is stored, and what it becomes.
const PIXEL_BYTES: u64 = 16;

impl Source<'_> {
    /// Whether so few bytes can hold an image of this size.
    pub fn check(&self, Size { width, height, .. }: Size) -> Result<(), String> {
        let size = self.bytes.len();
        if u64::from(width) * u64::from(height) > MOST_PIXELS_PER_BYTE * size as u64 {
            return Err(format!("{size} bytes cannot hold the {width} x {height} pixels it has"));
        }
        let needed = u64::from(width) * u64::from(height) * PIXEL_BYTES;
        memory::ask(needed).map_err(|problem| format!("{width} x {height} pixels: {problem}"))
    }

    /// What the pixels are put on.
    pub fn canvas(&self, size: Size) -> Result<Canvas, String> {
        self.check(size)?;
        Ok(Canvas::new(size, self.convert))
    }
}

/// Pixels are converted one by one, as they are decoded: no second image is in memory.
pub struct Canvas {
    size: Size,
    convert: Convert,
    decoded: Decoded,
}

impl Canvas {
    pub fn new(size: Size, convert: Convert) -> Self {
        let (width, height) = size.orientation.turned(size.width, size.height);
        let image = Image::black(width, height);
        Self { size, convert, decoded: Decoded { image, is_srgb: true, is_transparent: false } }
    }

    /// The pixel that is stored in a column and a row.
    pub fn put(&mut self, column: u32, row: u32, stored: Stored) {
        let Size { width, height, has_alpha, orientation } = self.size;
        let transparent = match stored {
            Stored::Srgb([.., alpha]) => alpha < u16::MAX,
            Stored::Linear([.., alpha]) => alpha < 1.0,
        };
        self.decoded.is_transparent |= transparent;
        let (x, y) = orientation.place(column, row, width, height);
        let image = &mut self.decoded.image;
        image.pixels[y as usize * image.width as usize + x as usize] =
            (self.convert)(stored, has_alpha);
    }

    pub fn finish(self) -> Decoded {
        self.decoded
    }
}
