//! Cameras.

use glam::DQuat;
use renderer_core::scene::{Camera, Scene};
use serde_json::{Value, json};

use crate::cameras::Pinhole;

/// The nearest that other programs are to show, as a part of the distance to where a camera looks: the format asks for it.
const NEAREST: f64 = 1e-3;

/// The cameras of a scene, and a node for each: those of its views, or its own.
pub(super) fn cameras(scene: &Scene) -> (Vec<Value>, Vec<Value>) {
    let own = [("camera", [scene.width, scene.height], &scene.camera)];
    let views = scene.views().iter();
    let views: Vec<_> =
        views.map(|view| (&view.name[..], [view.width, view.height], &view.camera)).collect();
    let all = if views.is_empty() { own.to_vec() } else { views };
    let written = all.into_iter().enumerate();
    written.map(|(index, (name, size, camera))| entry(index, name, size, camera)).unzip()
}

fn entry(index: usize, name: &str, size: [u32; 2], camera: &Camera<f64>) -> (Value, Value) {
    let Pinhole { position, axes, half_height } = Pinhole::from(camera);
    let [width, height] = size.map(f64::from);
    let perspective = json!({
        "yfov": 2.0 * half_height.atan(),
        "aspectRatio": width / height,
        "znear": NEAREST * camera.look_from.distance(camera.look_at),
    });
    let node = json!({
        "name": name,
        "camera": index,
        "translation": position.to_array(),
        "rotation": DQuat::from_mat3(&axes).to_array(),
    });
    (json!({ "name": name, "type": "perspective", "perspective": perspective }), node)
}
