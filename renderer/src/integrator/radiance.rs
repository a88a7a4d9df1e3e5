//! The image, and losses of it.

use ad::Vec3;
use ad::lanes::Lanes;
use glam::DVec3;

use super::mirrors::{Dark, Sight};
use super::prepared::Prepared;
use super::shade::Shaded;
use super::tiles::{TILE, Tile, fill_strips, for_each_strip};
use super::view::{Group, Sample, set_vectors};
use crate::acceleration::{PACKET_RAYS, PacketVectors, ray_at, rays};
use crate::image::Image;
use crate::precision::vectors_of_lanes;

/// A loss that is a sum over pixels.
pub trait PixelLoss: Sync {
    /// What the pixel in column `x` and row `y` adds to the loss if it has this radiance, and the
    /// derivative of that by the radiance.
    fn evaluate(&self, x: u32, y: u32, radiance: DVec3) -> (f64, DVec3);
}

/// Renders the image: the mean of what the rays through each pixel bring. Where the camera sees
/// nothing, the image is black.
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
            if prepared.sampling.count() == 1 {
                let sample = Sample { tile: &tile, sampling: prepared.sampling, index: 0 };
                visit(prepared, &sample, sight, |group, radiance| {
                    set_vectors::<L>(&mut colors, group.first, group.alive, radiance);
                });
            } else {
                let radiance = mean_radiance(prepared, &tile, sight);
                radiance
                    .iter()
                    .enumerate()
                    .for_each(|(ray, color)| colors.set(ray, color.as_vec3()));
            }
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
            let radiance = mean_radiance(prepared, &tile, sight);
            for ray in rays(tile.rays()) {
                let (x, y) = tile.pixel(ray);
                sum += loss.evaluate(x, y, radiance[ray]).0;
            }
        }
        sum
    });
    strips.into_iter().sum()
}

/// The radiance of the pixels of a tile, in double precision from that of each ray on.
#[inline(never)]
pub(super) fn mean_radiance<L: Lanes>(
    prepared: &Prepared<'_, L>,
    tile: &Tile,
    sight: &mut Sight<L>,
) -> [DVec3; PACKET_RAYS] {
    let mut total = [DVec3::ZERO; PACKET_RAYS];
    for sample in prepared.samples(tile) {
        visit(prepared, &sample, sight, |group, radiance| {
            let radiance = vectors_of_lanes::<L>(radiance);
            for (lane, ray) in group.rays() {
                total[ray] += radiance[lane];
            }
        });
    }
    let count = f64::from(prepared.sampling.count());
    total.map(|radiance| radiance / count)
}

/// Calls `use_radiance` with the radiance of every group of rays.
#[inline]
fn visit<L: Lanes>(
    prepared: &Prepared<'_, L>,
    sample: &Sample<'_>,
    sight: &mut Sight<L>,
    mut use_radiance: impl FnMut(&Group<L>, Vec3<L>),
) {
    prepared.see(sample, Dark::default(), sight);
    let (view, beyond) = (&sight.views()[0], sight.views().get(1));
    for group in &view.groups {
        let materials = prepared.materials(group);
        let appearance = prepared.appearance(group, &materials);
        let shaded = Shaded::new(prepared, group, &appearance, view, beyond);
        use_radiance(group, shaded.radiance());
    }
}
