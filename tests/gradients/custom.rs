//! Shapes and lights that users add.

use std::sync::Arc;

use renderer::scene::{CustomLightObject, CustomShapeObject, ParameterId, Scene};

use crate::image::{agrees_with_finite_differences, lanes_agree_on};
use crate::scenes::mirror_scene;

#[path = "../../examples/custom_shape/kinds.rs"]
mod kinds;

use kinds::{Ellipsoid, Spotlight};

/// Adds a light that a user defines.
pub fn add_spotlight(scene: &mut Scene) {
    let light = Arc::new(Spotlight);
    scene.custom_lights.push(CustomLightObject { name: "spot".into(), light });
    scene.parameters.custom_lights.push(vec![-2.0, 4.0, 4.0, 0.0, 0.3, 0.0, 0.09, 1.2]);
}

/// The mirrors show the ellipsoid, which is a mirror too; shadows fall on it and from it.
fn scene(size: u32) -> Scene {
    let mut scene = mirror_scene(size);
    let shape = Arc::new(Ellipsoid);
    scene.shapes.push(CustomShapeObject { name: "egg".into(), material: 1, shape });
    scene.parameters.shapes.push(vec![0.25, 0.45, 0.9, 0.3, 0.4, 0.25]);
    add_spotlight(&mut scene);
    scene
}

#[test]
fn their_gradients_agree_with_finite_differences() {
    let scene = scene(20);
    let paths: Vec<String> =
        scene.parameter_ids().iter().map(|&id| scene.path(id).to_string()).collect();
    assert!(paths.contains(&"shape.egg.parameters".to_owned()), "{paths:?}");
    assert!(paths.contains(&"light.spot.parameters".to_owned()), "{paths:?}");
    for id in scene.parameter_ids() {
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
    assert_eq!(scene(4).parameter("shape.egg.parameters"), Some(ParameterId::ShapeParameters(0)));
}
