//! The ways to find what a pixel shows agree.

use glam::DVec3;
use renderer::integrator::{
    GradientSamples, Pass, Prepared, RenderSettings, Samples, Sampling, Visibility, render,
};
use renderer::scene::Scene;
use wide::f32x16;

use crate::scenes::textured_scene;

fn image(scene: &Scene, visibility: Visibility, pass: Pass) -> Vec<[f32; 3]> {
    let settings = RenderSettings { visibility, pass, ..RenderSettings::default() };
    render(&Prepared::<f32x16>::with_settings(scene, settings)).pixels
}

/// Wide and high images; a camera among the geometry, with parts behind it and across its plane;
/// an image that shows nothing; a single pixel.
#[test]
fn tree_list_and_raster_show_the_same() {
    let mut inside = textured_scene(90);
    inside.parameters.camera.look_from = DVec3::new(0.9, 0.35, 0.9);
    inside.parameters.camera.vfov = 120.0;
    let mut away = textured_scene(40);
    away.parameters.camera.look_at = DVec3::new(0.0, 40.0, 6.0);
    let mut high = textured_scene(30);
    (high.width, high.height) = (13, 101);
    let mut pixel = textured_scene(30);
    (pixel.width, pixel.height) = (1, 1);
    for scene in [textured_scene(130), inside, away, high, pixel] {
        for pass in [Pass::Radiance, Pass::Albedo] {
            let tree = image(&scene, Visibility::Tree, pass);
            assert_eq!(tree, image(&scene, Visibility::List, pass));
            assert_eq!(tree, image(&scene, Visibility::Raster, pass));
        }
    }
}

/// Rays through any point of a pixel, not through its middle alone.
#[test]
fn so_they_do_with_several_rays_per_pixel() {
    let scene = textured_scene(50);
    let samples = Samples { count: 5, seed: 1, gradient: GradientSamples::Same };
    let image = |visibility| {
        let sampling = Sampling::Stratified(samples);
        let settings = RenderSettings { visibility, sampling, ..RenderSettings::default() };
        render(&Prepared::<f32x16>::with_settings(&scene, settings))
    };
    assert_eq!(image(Visibility::Tree), image(Visibility::List));
    assert_eq!(image(Visibility::Tree), image(Visibility::Raster));
}
