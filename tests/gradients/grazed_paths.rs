//! Paths from surfaces that the camera grazes, where radiance changes ever faster towards the silhouette, beside
//! differences of finely sampled images.

use std::f64::consts::{PI, TAU};

use glam::{DVec3, dvec3};
use renderer::scene::MaterialObject;
use renderer::{Camera, Scene, Settings, SphereObject};

use crate::differences::{differences, gradient, relative_error};
use crate::fine_images::add_round;
use crate::moving_paths::Weights;
use crate::paths::paths;
use crate::sky::under;
use crate::without_edges;

const CENTER: DVec3 = dvec3(0.1, -0.05, 0.2);

/// The camera sees nothing but something round of metal, under a sky.
fn metal_scene(roughness: f64) -> Scene {
    let camera = Camera { vfov: 28.0, ..Camera::looking(DVec3::Z * 4.0, DVec3::ZERO) };
    let mut scene = Scene::new(24, 18, camera);
    let metal = MaterialObject::metallic_roughness(dvec3(0.9, 0.6, 0.4), 0.7, roughness);
    scene.add_material("metal", metal).unwrap();
    let texel = |index: u32| {
        let (x, y) = (f64::from(index % 16), f64::from(index / 16));
        [1.0 + 0.5 * (TAU * x / 16.0).sin(), 0.5 + 0.1 * y, 1.0]
    };
    under(&mut scene, 16, (0..128).map(texel).collect(), 30.0);
    scene
}

/// One gradient of 256 paths, beside differences of images of 2048.
#[track_caller]
fn check(mut scene: Scene, path: &str, most: f64) {
    scene.integrator = paths(2, 2048);
    let expected = differences(&scene, &without_edges(), &Weights, path, 0.02);
    scene.integrator = paths(2, 256);
    let found = gradient(&scene, &Settings::default(), &Weights, path);
    let off = relative_error(&found, &expected);
    assert!(off < most, "{path}: {off:.3} off: {found:?}, by differences {expected:?}");
}

#[test]
fn metal_balls_have_little_noise() {
    for (roughness, most) in [(1.0, [0.01, 0.02]), (0.5, [0.04, 0.15])] {
        let mut scene = metal_scene(roughness);
        scene.add_sphere(SphereObject::new("ball", CENTER, 0.8)).unwrap();
        check(scene.clone(), "sphere.ball.radius", most[0]);
        check(scene, "sphere.ball.center", most[1]);
    }
}

#[test]
fn smooth_metal_meshes_have_little_noise() {
    let mut scene = metal_scene(1.0);
    add_round(&mut scene, [48, 24], false, 0, |u, v| {
        let ((sine, cosine), (x, z)) = ((PI * v).sin_cos(), (TAU * u).sin_cos());
        CENTER + 0.8 * dvec3(sine * x, cosine, sine * z)
    });
    check(scene.clone(), "mesh.round.scale", 0.03);
    check(scene, "mesh.round.translation", 0.06);
}
