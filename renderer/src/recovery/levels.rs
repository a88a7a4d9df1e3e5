//! Images from coarse to fine.
//!
//! An edge in an image says where it should go only while it is within a pixel of there; farther away it is
//! only known on which side. So coarse pixels see farther, and cost less.

use crate::scene::Scene;
use crate::settings::Sampling;

/// What is wrong with halving the images of a scene so often.
pub(crate) fn check_levels(scene: &Scene, levels: u32) -> Result<(), String> {
    let sizes = scene.views().iter().map(|view| [view.width, view.height]);
    let sizes = sizes.chain(scene.views().is_empty().then_some([scene.width, scene.height]));
    for [width, height] in sizes {
        let is_halved = |side: u32| side.trailing_zeros() >= levels;
        if !is_halved(width) || !is_halved(height) {
            return Err(format!("{width} x {height} pixels cannot be halved {levels} times"));
        }
    }
    Ok(())
}

/// A scene with the sides of its images halved.
pub(super) fn halved(scene: &Scene, levels: u32) -> Scene {
    let mut scene = scene.clone();
    (scene.width, scene.height) = (scene.width >> levels, scene.height >> levels);
    for view in &mut scene.views {
        (view.width, view.height) = (view.width >> levels, view.height >> levels);
    }
    scene
}

/// The rays of pixels that are so often halved: a grid of up to four by four takes the place of one ray, since
/// what is smaller than the distance of rays is missed, and the image is the mean of finer ones.
pub(super) fn spread(sampling: Sampling, levels: u32) -> Sampling {
    const SIDE: u32 = 4;
    match sampling {
        Sampling::Center if levels > 0 => spread(Sampling::Grid(1), levels),
        Sampling::Grid(side) if side < SIDE => Sampling::Grid((side << levels.min(2)).min(SIDE)),
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coarse_pixels_have_the_rays_of_those_that_they_cover_up_to_four_by_four() {
        let sides = |sampling| [0, 1, 2, 3].map(|levels| spread(sampling, levels).count());
        assert_eq!(sides(Sampling::Center), [1, 4, 16, 16]);
        assert_eq!(sides(Sampling::Grid(3)), [9, 16, 16, 16]);
        assert_eq!(sides(Sampling::Grid(6)), [36; 4]);
    }
}
