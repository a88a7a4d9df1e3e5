//! The image, and losses of it.

use ad::Vec3;
use ad::lanes::Lanes;
use glam::DVec3;

use super::mirrors::{Mirrors, Sight};
use super::prepared::Prepared;
use super::shade::Shaded;
use super::tiles::{TILE, Tile, fill_strips, for_each_strip};
use super::view::{Group, set_vectors};
use crate::acceleration::{PacketVectors, ray_at, rays};
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
    let mut image = Image::black(prepared.scene.width, prepared.scene.height);
    render_into(prepared, &mut image);
    image
}

/// [`render`], over an image of the same size: who renders often saves the time to get memory.
///
/// # Panics
///
/// If the image has another size than the scene's.
pub fn render_into<L: Lanes>(prepared: &Prepared<'_, L>, image: &mut Image) {
    let size = (prepared.scene.width, prepared.scene.height);
    assert_eq!((image.width, image.height), size, "the image has the size of the scene's");
    fill_strips(image, Sight::default, |sight, strip, rows| {
        for tile in strip.tiles() {
            let mut colors = PacketVectors::ZERO;
            visit(prepared, &tile, sight, |group, radiance| {
                set_vectors::<L>(&mut colors, group.first, group.alive, radiance);
            });
            let pixels = by_rows(&colors);
            for (row, pixels) in rows.iter_mut().zip(&pixels) {
                row[strip.columns(&tile)].copy_from_slice(&pixels[..tile.columns]);
            }
        }
    });
}

/// What rays bring, at the places of their pixels.
#[inline]
fn by_rows(colors: &PacketVectors) -> [[[f32; 3]; TILE]; TILE] {
    let mut pixels = [[[0.0; 3]; TILE]; TILE];
    for (row, pixels) in pixels.iter_mut().enumerate() {
        for (column, pixel) in pixels.iter_mut().enumerate() {
            *pixel = colors.get(ray_at(column, row)).into();
        }
    }
    pixels
}

/// The loss of the image, in double precision from the radiance on.
pub fn loss<L: Lanes>(prepared: &Prepared<'_, L>, loss: &impl PixelLoss) -> f64 {
    let (width, height) = (prepared.scene.width, prepared.scene.height);
    let strips = for_each_strip(width, height, Sight::default, |sight, strip| {
        let mut sum = 0.0;
        for tile in strip.tiles() {
            visit(prepared, &tile, sight, |group, radiance: Vec3<L>| {
                let radiance = vectors_of_lanes::<L>(radiance);
                for (lane, ray) in group.rays() {
                    let (x, y) = tile.pixel(ray);
                    sum += loss.evaluate(x, y, radiance[lane]).0;
                }
            });
            sum += black_pixels(&tile, sight.views()[0].missed, loss);
        }
        sum
    });
    strips.into_iter().sum()
}

/// The loss of the pixels of a tile that show nothing.
pub(super) fn black_pixels(tile: &Tile, missed: u64, loss: &impl PixelLoss) -> f64 {
    rays(missed)
        .map(|ray| {
            let (x, y) = tile.pixel(ray);
            loss.evaluate(x, y, DVec3::ZERO).0
        })
        .sum()
}

/// Calls `use_radiance` with the radiance of every group of a tile.
fn visit<L: Lanes>(
    prepared: &Prepared<'_, L>,
    tile: &Tile,
    sight: &mut Sight<L>,
    mut use_radiance: impl FnMut(&Group<L>, Vec3<L>),
) {
    prepared.see(tile, Mirrors::Bright, sight);
    let (view, mirrored) = (&sight.views()[0], sight.views().get(1));
    for group in &view.groups {
        let appearance = prepared.appearance(group);
        let shaded = Shaded::new(prepared, group, &appearance, &view.lit, mirrored);
        use_radiance(group, shaded.radiance());
    }
}
