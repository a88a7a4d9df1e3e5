//! A scene that is tiny, huge, or far from the origin shows the same image, and its gradients follow.

use glam::{DVec3, dvec3};
use renderer::scene::Object;
use renderer::{Arithmetic, ParameterId, Precision, Scene};

use crate::images::{ARITHMETICS, difference, evaluate, placed, placed_by_transforms, render};
use crate::scenes::{mirror_scene, small_scene, textured_scene};

/// Scales and offsets. What an `f64` holds of a scene at a distance of 1e6 are steps of 1e-10, so a
/// scene there cannot be tiny too.
const PLACEMENTS: [(f64, DVec3); 8] = [
    (1e-6, DVec3::ZERO),
    (1e-3, dvec3(3.0, -2.0, 1.0)),
    (1e3, DVec3::ZERO),
    (1e6, DVec3::ZERO),
    (1.0, dvec3(1e3, -2e3, 5e2)),
    (1.0, dvec3(-1e6, 7e5, 1e6)),
    (1e3, dvec3(1e6, 1e6, -1e6)),
    (1e6, dvec3(-1e6, 3e5, 1e6)),
];

/// A way to place a scene elsewhere.
type Place = fn(&Scene, f64, DVec3) -> Scene;

/// How the derivative by a parameter changes where the scene is `scale` times as large; nothing where it
/// also depends on the place, as those by a transform do that turns about the origin.
fn covariance(id: ParameterId, scale: f64, by_transforms: bool) -> Option<f64> {
    match (id.object, id.field) {
        (Object::Mesh(_), "rotation") if by_transforms => Some(1.0),
        (Object::Mesh(_), "vertices") if by_transforms => Some(1.0),
        (Object::Mesh(_), "rotation") => None,
        (Object::Mesh(_), "scale") if !by_transforms => None,
        (_, "radiant_intensity") => Some((scale * scale).recip()),
        (
            _,
            "look_from" | "look_at" | "position" | "center" | "radius" | "vertices" | "translation"
            | "scale",
        ) => Some(scale.recip()),
        _ => Some(1.0),
    }
}

fn check(scene: &Scene, name: &str, place: Place, by_transforms: bool) {
    for arithmetic in ARITHMETICS {
        check_in(arithmetic, scene, name, place, by_transforms);
    }
}

fn check_in(arithmetic: Arithmetic, scene: &Scene, name: &str, place: Place, by_transforms: bool) {
    let image = render(scene, arithmetic);
    let (loss, gradient) = evaluate(scene, arithmetic);
    for (scale, offset) in PLACEMENTS {
        let moved = place(scene, scale, offset);
        let (moved_loss, moved_gradient) = evaluate(&moved, arithmetic);
        let off_by = difference(&image, &render(&moved, arithmetic));
        let mut worst = (moved_loss / loss - 1.0).abs();
        for ((id, block), (_, moved_block)) in gradient.iter().zip(&moved_gradient) {
            let Some(covariance) = covariance(*id, scale, by_transforms) else { continue };
            let largest = block.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
            for (x, moved) in block.iter().zip(moved_block) {
                let moved = moved / covariance;
                let error = if *x == moved { 0.0 } else { (x - moved).abs() / largest };
                worst = crate::larger(worst, error);
            }
        }
        println!(
            "| {name}, times {scale:e}, moved by {:e} | {arithmetic:?} | {off_by:.1e} | {worst:.1e} |",
            offset.abs().max_element()
        );
        let bound = match arithmetic.precision() {
            Precision::F32 => 1e-5,
            Precision::F64 => 1e-7,
        };
        assert!(off_by <= bound, "{name}, {arithmetic:?}: images differ by {off_by:e}");
        assert!(worst <= 10.0 * bound, "{name}, {arithmetic:?}: gradients differ by {worst:e}");
    }
}

#[test]
fn images_and_gradients_follow_the_scene() {
    for (scene, name) in [
        (small_scene(24), "two lights"),
        (mirror_scene(24), "mirrors"),
        (textured_scene(24), "textures"),
    ] {
        check(&scene, name, placed, false);
        check(&scene, name, placed_by_transforms, true);
    }
}
