//! Shapes and lights that users add.

use glam::dvec3;
use renderer::Scene;

use crate::image::{agrees_with_finite_differences, lanes_agree_on};
use crate::scenes::{mirror_scene, set};

#[path = "../../examples/custom_shape/kinds.rs"]
pub mod kinds;

use kinds::{Ellipsoid, Spotlight};

/// Adds a light that a user defines.
pub fn add_spotlight(scene: &mut Scene) {
    let light = Spotlight {
        position: dvec3(-2.0, 4.0, 4.0),
        target: dvec3(0.0, 0.3, 0.0),
        radiant_intensity: 28.0,
        sharpness: 12.0,
    };
    scene.add_emitter("spot", light).unwrap();
}

/// Adds a shape that a user defines and that is placed in the world, with a material by index.
pub fn add_egg(scene: &mut Scene, material: u32) {
    let egg = Ellipsoid { center: dvec3(0.05, 0.15, 0.2), radii: dvec3(0.2, 0.5, 0.25) };
    scene.add_shape("egg", egg, material).unwrap();
    set(scene, "shape.egg.translation", &[0.2, 0.3, 0.7]);
    set(scene, "shape.egg.rotation", &[10.0, 20.0, 30.0]);
    set(scene, "shape.egg.scale", &[1.5, 0.8, 1.1]);
}

/// The mirrors show the ellipsoid, which is a mirror too; shadows fall on it and from it.
fn scene(size: u32) -> Scene {
    let mut scene = mirror_scene(size);
    add_egg(&mut scene, 1);
    add_spotlight(&mut scene);
    scene
}

#[test]
fn their_gradients_agree_with_finite_differences() {
    let scene = scene(20);
    let paths: Vec<String> =
        scene.parameters().iter().map(|&id| scene.path(id).to_string()).collect();
    for path in ["shape.egg.center", "shape.egg.radii", "shape.egg.rotation", "light.spot.target"] {
        assert!(paths.contains(&path.to_owned()), "{paths:?}");
    }
    for id in scene.parameters() {
        agrees_with_finite_differences(&scene, id);
    }
}

#[test]
fn lanes_agree_with_single_numbers_on_them() {
    lanes_agree_on(&scene(37));
}

#[test]
fn a_scene_file_cannot_hold_them() {
    let folder = tempfile::tempdir().unwrap();
    let error = renderer::files::save_scene(&scene(4), folder.path()).unwrap_err();
    assert!(error.to_string().contains("shape.egg: is defined in Rust"), "{error}");
}

#[test]
fn they_are_checked() {
    let mut scene = scene(4);
    let scale = scene.parameter("shape.egg.scale").unwrap();
    let error = scene.set(scale, &[1.0, 0.0, 1.0]).unwrap_err().to_string();
    assert_eq!(error, "shape.egg.scale: must not be 0 along any axis");
    assert_eq!(scene.get(scale)[..], [1.5, 0.8, 1.1]);
    let egg = Ellipsoid { center: dvec3(0.0, f64::NAN, 0.0), radii: dvec3(1.0, 1.0, 1.0) };
    let error = scene.add_shape("broken", egg, 0).unwrap_err().to_string();
    assert_eq!(error, "shape.broken.center: NaN is not a finite number");
    assert_eq!(scene.shapes().len(), 1);
}
