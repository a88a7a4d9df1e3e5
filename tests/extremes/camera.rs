//! Cameras at their ends.

use glam::DVec3;
use renderer::{Camera, Scene};

use crate::images::{ARITHMETICS, check_agreement, difference, evaluate, placed, render};
use crate::kernels::PrimaryRay;
use crate::oracle::{Case, check};
use crate::scenes::{mirror_scene, small_scene};

struct View {
    look_from: [f64; 3],
    look_at: [f64; 3],
    up: [f64; 3],
    vfov: f64,
}

const ORDINARY: View = View {
    look_from: [0.5, 1.5, 4.0],
    look_at: [0.0, 0.25, 0.0],
    up: [0.125, 1.0, 0.0],
    vfov: 45.0,
};

impl View {
    #[track_caller]
    fn check(self, name: &str, length: f64, value: f64, gradient: f64) {
        let Self { look_from, look_at, up, vfov } = self;
        let numbers = [&look_from[..], &look_at, &up, &[vfov, 1.0, 0.625, -0.375]].concat();
        let x: Vec<f64> = numbers.into_iter().map(|x| f64::from(x as f32)).collect();
        let angle = vfov.min(180.0 - vfov);
        check::<PrimaryRay>(&Case {
            name,
            x: &x,
            lengths: &[length, length, length, 0.1 * angle, 0.1 * angle / vfov, 0.1 * angle / vfov],
            value,
            gradient,
        });
    }
}

#[test]
fn fields_of_view() {
    for vfov in [1e-3, 1.0, 90.0, 179.0, 179.99] {
        let view = View { vfov, ..ORDINARY };
        view.check(
            &format!("field of view {vfov} degrees"),
            0.01,
            10.0,
            10.0 + 1e3 / (180.0 - vfov),
        );
    }
}

#[test]
fn places_and_directions() {
    for distance in [1e-3, 1e-6] {
        let view = View { look_from: [0.0, 0.25, distance], ..ORDINARY };
        view.check(&format!("look_at {distance:e} from look_from"), 0.1 * distance, 10.0, 20.0);
        let up = [-0.5 + distance, -1.25, -4.0];
        let view = View { up, ..ORDINARY };
        view.check(
            &format!("up {distance:e} from the view"),
            0.1 * distance,
            0.1 / distance,
            0.5 / distance,
        );
    }
}

/// One pixel, one row, one column, the longest row.
#[test]
fn sizes_of_images() {
    for (width, height) in [(1, 1), (16_384, 1), (1, 16_384), (3, 2)] {
        let mut scene = mirror_scene(24);
        (scene.width, scene.height) = (width, height);
        let images = ARITHMETICS.map(|arithmetic| render(&scene, arithmetic));
        let (double_loss, _) = evaluate(&scene, ARITHMETICS[3]);
        for (image, arithmetic) in images.iter().zip(ARITHMETICS) {
            assert_eq!(image.pixels.len(), (width * height) as usize);
            assert!(difference(image, &images[3]) <= 1e-4, "{width} x {height}, {arithmetic:?}");
            let (loss, gradient) = evaluate(&scene, arithmetic);
            assert!((loss / double_loss - 1.0).abs() <= 1e-4, "{width} x {height}, {arithmetic:?}");
            assert!(gradient.iter().flat_map(|(_, block)| block).all(|g| g.is_finite()));
        }
    }
}

#[test]
fn nothing_to_see() {
    let mut behind = small_scene(24);
    behind.camera.look_at = DVec3::new(0.6, 4.6, 12.0);
    let empty = Scene::new(9, 5, Camera::looking(DVec3::Z, DVec3::ZERO));
    for scene in [behind, empty] {
        for arithmetic in ARITHMETICS {
            let image = render(&scene, arithmetic);
            assert!(image.pixels.as_flattened().iter().all(|&channel| channel == 0.0));
            let (loss, gradient) = evaluate(&scene, arithmetic);
            assert_eq!(loss, 0.0);
            assert!(gradient.iter().flat_map(|(_, block)| block).all(|&g| g == 0.0));
        }
    }
}

#[track_caller]
fn refused(scene: &Scene, parts: [&str; 2]) {
    let error = scene.validate("scene").unwrap_err().to_string();
    assert!(parts.iter().all(|part| error.contains(part)), "{error}");
}

/// Rays that single precision cannot tell apart are refused, those it can are right.
#[test]
fn pixels_that_are_too_close_are_refused() {
    let mut scene = small_scene(24);
    scene.camera.vfov = 1e-3;
    render(&scene, ARITHMETICS[1]);
    (scene.width, scene.height) = (512, 512);
    refused(&scene, ["scene: camera.vfov", "too close for rays in single precision"]);
    scene.camera.vfov = 179.99;
    render(&scene, ARITHMETICS[1]);
}

#[test]
fn scenes_in_narrow_and_wide_views() {
    for (vfov, bound) in [(1e-3, 1e-3), (1.0, 1e-4), (170.0, 1e-4), (179.99, 1e-3)] {
        let mut scene = small_scene(24);
        scene.camera.vfov = vfov;
        check_agreement(&format!("scene in a view of {vfov} degrees"), &scene, bound);
    }
}

/// Where the camera stands in the world does not matter to how far it may be from what it looks at.
#[test]
fn directions_that_rounding_decides_are_refused() {
    let scene = placed(&small_scene(24), 1e-3, DVec3::splat(1e6));
    render(&scene, ARITHMETICS[1]);
    refused(
        &placed(&small_scene(24), 1e-6, DVec3::splat(1e6)),
        ["camera.look_from", "must differ"],
    );
    let mut same = small_scene(24);
    same.camera.look_from = same.camera.look_at;
    refused(&same, ["camera.look_from", "must differ from camera.look_at"]);
    let mut along = small_scene(24);
    along.camera.up = along.camera.look_at - along.camera.look_from;
    refused(&along, ["camera.up", "must not be parallel"]);
}
