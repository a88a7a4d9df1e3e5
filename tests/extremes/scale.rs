//! A scene that is tiny, huge, or far from the origin shows the same image, and its gradients follow.

use glam::{DVec3, dvec3};
use renderer::arithmetic::{Arithmetic, Precision};
use renderer::scene::{Light, ParameterId, Scene};

use crate::images::{ARITHMETICS, difference, evaluate, placed, render};
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

/// How the derivative by a parameter changes where the scene is `scale` times as large.
fn covariance(scene: &Scene, id: ParameterId, scale: f64) -> f64 {
    use ParameterId::*;
    match id {
        LookFrom
        | LookAt
        | LightPosition(_)
        | SphereCenter(_)
        | SphereRadius(_)
        | Vertices(_)
        | Vertex { .. } => scale.recip(),
        LightIntensity(i) if matches!(scene.parameters.lights[i], Light::Point(_)) => {
            (scale * scale).recip()
        }
        _ => 1.0,
    }
}

fn check(scene: &Scene, name: &str, arithmetics: &[Arithmetic]) {
    for &arithmetic in arithmetics {
        let image = render(scene, arithmetic);
        let (loss, gradient) = evaluate(scene, arithmetic);
        for (scale, offset) in PLACEMENTS {
            let moved = placed(scene, scale, offset);
            let (moved_loss, moved_gradient) = evaluate(&moved, arithmetic);
            let off_by = difference(&image, &render(&moved, arithmetic));
            let mut worst = (moved_loss / loss - 1.0).abs();
            for ((id, block), (_, moved_block)) in gradient.iter().zip(&moved_gradient) {
                let largest = block.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
                for (x, moved) in block.iter().zip(moved_block) {
                    let moved = moved / covariance(scene, *id, scale);
                    let error = if *x == moved { 0.0 } else { (x - moved).abs() / largest };
                    worst = worst.max(error);
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
}

#[test]
fn images_and_gradients_follow_the_scene() {
    for (scene, name) in [
        (small_scene(24), "two lights"),
        (mirror_scene(24), "mirrors"),
        (textured_scene(24), "textures"),
    ] {
        check(&scene, name, &ARITHMETICS);
    }
}
