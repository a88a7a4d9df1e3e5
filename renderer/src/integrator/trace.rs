//! Traversal alone, to measure it.

use ad::lanes::Lanes;

use super::mirrors::Dark;
use super::prepared::Prepared;
use super::tiles::for_each_strip;
use super::view::View;

/// Traces the rays of an image from the camera, those of their shadows if they are wanted, and shades
/// nothing.
pub fn trace<L: Lanes>(prepared: &Prepared<'_, L>, shadows: bool) {
    let (width, height) = (prepared.scene.width, prepared.scene.height);
    for_each_strip(width, height, View::<L>::default, |view, strip| {
        for tile in strip.tiles() {
            for sample in prepared.samples(&tile) {
                prepared.look(&sample, view);
                if shadows {
                    prepared.light_up(Dark::default(), view);
                }
            }
        }
    });
}
