//! The image, and losses of it.

use ad::lanes::Lanes;
use glam::DVec3;

use super::prepared::Prepared;
use super::shade::radiance;
use super::tiles::{Tile, for_each_tile};
use crate::image::Image;
use crate::precision::vectors_of_lanes;

/// A loss that is a sum over pixels.
pub trait PixelLoss: Sync {
    /// What the pixel in column `x` and row `y` adds to the loss if it has this radiance, and the
    /// derivative of that by the radiance.
    fn evaluate(&self, x: u32, y: u32, radiance: DVec3) -> (f64, DVec3);
}

/// Renders the image: one ray through the middle of each pixel. Where the camera sees nothing, the
/// image is black.
pub fn render<L: Lanes>(prepared: &Prepared<'_, L>) -> Image {
    let (width, height) = (prepared.scene.width, prepared.scene.height);
    let tiles = for_each_tile(width, height, |tile| {
        let mut pixels = Vec::new();
        visit(prepared, &tile, |x, y, radiance| pixels.push((x, y, radiance.as_vec3())));
        pixels
    });

    let mut image = Image::black(width, height);
    for (x, y, radiance) in tiles.into_iter().flatten() {
        image.pixels[y as usize * width as usize + x as usize] = radiance.into();
    }
    image
}

/// The loss of the image, in double precision from the radiance on.
pub fn loss<L: Lanes>(prepared: &Prepared<'_, L>, loss: &impl PixelLoss) -> f64 {
    let tiles = for_each_tile(prepared.scene.width, prepared.scene.height, |tile| {
        let mut sum = 0.0;
        visit(prepared, &tile, |x, y, radiance| sum += loss.evaluate(x, y, radiance).0);
        sum
    });
    tiles.into_iter().sum()
}

/// Calls `use_pixel` with the radiance of every pixel of a tile.
fn visit<L: Lanes>(
    prepared: &Prepared<'_, L>,
    tile: &Tile,
    mut use_pixel: impl FnMut(u32, u32, DVec3),
) {
    let view = prepared.view(tile);
    for &(x, y) in &view.missed {
        use_pixel(x, y, DVec3::ZERO);
    }
    let groups = prepared.groups(&view);
    let lit = prepared.lit(&view, &groups);
    for group in &groups {
        let radiance = vectors_of_lanes::<L>(radiance(group, &prepared.lights, &lit));
        for (pixel, radiance) in view.seen[group.pixels.clone()].iter().zip(radiance) {
            use_pixel(pixel.x, pixel.y, radiance);
        }
    }
}
