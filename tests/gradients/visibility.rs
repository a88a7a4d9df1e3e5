//! The ways to find what a pixel shows agree.

use glam::DVec3;
use renderer::{
    Pass, PrimaryVisibility, Samples, Sampling, Scene, Settings, render, settings::GradientSamples,
};

use crate::scenes::textured_scene;

/// Whether the image is the same whatever finds what pixels show.
fn is_same(scene: &Scene, settings: &Settings) {
    let image = |visibility| render(scene, &Settings { visibility, ..*settings }).unwrap();
    let bvh = image(PrimaryVisibility::Bvh);
    assert_eq!(bvh, image(PrimaryVisibility::BruteForce));
    assert_eq!(bvh, image(PrimaryVisibility::Raster));
}

/// Wide and high images; a camera among the geometry, with parts behind it and across its plane;
/// an image that shows nothing; a single pixel.
#[test]
fn hierarchy_brute_force_and_raster_show_the_same() {
    let mut inside = textured_scene(90);
    inside.camera.look_from = DVec3::new(0.9, 0.35, 0.9);
    inside.camera.vfov = 120.0;
    let mut away = textured_scene(40);
    away.camera.look_at = DVec3::new(0.0, 40.0, 6.0);
    let mut high = textured_scene(30);
    (high.width, high.height) = (13, 101);
    let mut pixel = textured_scene(30);
    (pixel.width, pixel.height) = (1, 1);
    for scene in [textured_scene(130), inside, away, high, pixel] {
        for pass in [Pass::Radiance, Pass::Albedo] {
            is_same(&scene, &Settings { pass, ..crate::without_edges() });
        }
    }
}

/// Rays through any point of a pixel, not through its middle alone.
#[test]
fn so_they_do_with_several_rays_per_pixel() {
    let samples = Samples { count: 5, seed: 1, gradient: GradientSamples::Same };
    let sampling = Sampling::Stratified(samples);
    is_same(&textured_scene(50), &Settings { sampling, ..crate::without_edges() });
}
