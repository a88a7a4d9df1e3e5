//! The image, and losses of it.

use ad::Scalar;
use glam::DVec3;

use super::pixel::PixelLoss;
use super::prepared::Prepared;
use super::tiles::for_each_tile;
use crate::image::Image;

/// Renders the image: one ray through the middle of each pixel. Where the camera sees nothing, the
/// image is black.
pub fn render<S: Scalar>(prepared: &Prepared<'_, S>) -> Image {
    let (width, height) = (prepared.scene.width, prepared.scene.height);
    let tiles = for_each_tile(width, height, |tile| {
        let mut lit = Vec::new();
        let pixels = tile.pixels().map(|(x, y)| {
            let sight = prepared.look(x, y);
            sight.map_or(DVec3::ZERO, |sight| prepared.radiance(&sight, &mut lit)).as_vec3()
        });
        let pixels: Vec<_> = pixels.collect();
        (tile, pixels)
    });

    let mut image = Image::black(width, height);
    for (tile, pixels) in tiles {
        for ((x, y), pixel) in tile.pixels().zip(pixels) {
            image.pixels[y as usize * width as usize + x as usize] = pixel.into();
        }
    }
    image
}

/// The loss of the image, in double precision from the radiance on.
pub fn loss<S: Scalar>(prepared: &Prepared<'_, S>, loss: &impl PixelLoss) -> f64 {
    let tiles = for_each_tile(prepared.scene.width, prepared.scene.height, |tile| {
        let mut lit = Vec::new();
        let losses = tile.pixels().map(|(x, y)| {
            let sight = prepared.look(x, y);
            let radiance = sight.map_or(DVec3::ZERO, |sight| prepared.radiance(&sight, &mut lit));
            loss.evaluate(x, y, radiance).0
        });
        losses.sum::<f64>()
    });
    tiles.into_iter().sum()
}
