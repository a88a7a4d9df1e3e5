//! Traversal alone, to measure it.

use ad::lanes::Lanes;

use super::prepared::Prepared;
use super::tiles::for_each_strip;
use super::view::View;

/// How many rays an image takes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rays {
    /// From the camera: one for each pixel.
    pub primary: u64,
    /// Between lights and the surfaces that face them.
    pub shadow: u64,
}

/// Traces the rays of an image, those of shadows if they are wanted, and shades nothing.
pub fn trace<L: Lanes>(prepared: &Prepared<'_, L>, shadows: bool) -> Rays {
    let (width, height) = (prepared.scene.width, prepared.scene.height);
    let strips = for_each_strip(width, height, View::<L>::default, |view, strip| {
        let mut rays = Rays::default();
        for tile in strip.tiles() {
            for sample in prepared.samples(&tile) {
                prepared.look(&sample, view);
                rays.primary += u64::from(tile.rays().count_ones());
                if shadows {
                    prepared.light_up(view);
                    rays.shadow +=
                        view.lit.iter().map(|lit| u64::from(lit.facing.count_ones())).sum::<u64>();
                }
            }
        }
        rays
    });
    strips.into_iter().fold(Rays::default(), |sum, strip| Rays {
        primary: sum.primary + strip.primary,
        shadow: sum.shadow + strip.shadow,
    })
}
