//! The ways to find what a pixel shows agree.

use std::f64::consts::TAU;

use glam::DVec3;
use renderer::settings::BuildQuality;
use renderer::{
    Pass, PrimaryVisibility, Renderer, Samples, Sampling, Scene, Settings, render,
    settings::GradientSamples,
};

use crate::edges::{add_floor, add_lamp, paint, veil};
use crate::fine_images::add_round;
use crate::paths::paths;
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

/// Two rings, of which light goes through one, and their shadows.
fn rings() -> Scene {
    let mut scene = crate::edges::scene();
    add_floor(&mut scene, 0.0);
    let (opaque, veil) = (paint(&mut scene, "rings", [0.7, 0.4, 0.3], 0.0), veil(&mut scene));
    for (x, paint) in [(-0.5, opaque), (0.5, veil)] {
        add_round(&mut scene, [24, 12], true, paint, |u, v| {
            let ((z, y), (sin, cos)) = ((TAU * u).sin_cos(), (TAU * v).sin_cos());
            let out = 0.4 + 0.15 * cos;
            DVec3::new(x + 0.15 * sin, 0.6 + out * y, out * z)
        });
        scene.meshes.last_mut().unwrap().name = format!("ring of material {paint}");
    }
    add_lamp(&mut scene);
    scene
}

/// Images with edges and their derivatives do not depend on how the acceleration structure comes to what it finds, so
/// that a run that is resumed, whose structure is built anew, has those of one that was not interrupted.
#[test]
fn edges_are_the_same_by_any_hierarchy() {
    let direct = rings();
    for scene in [Scene { integrator: paths(2, 4), ..direct.clone() }, direct] {
        let id = scene.parameter("mesh.floor.translation").unwrap();
        let along = [(id, vec![0.3, -0.7, 0.5])];
        let mut moved = scene.clone();
        moved.set(id, &[0.01, -0.02, 0.03]).unwrap();
        let settings = Settings::default();
        let derivative = |settings: Settings, is_used_before: bool| {
            let mut renderer = Renderer::new(&scene, &settings).unwrap();
            if is_used_before {
                renderer.jvp(&scene, &along).unwrap();
            }
            renderer.update(&moved);
            renderer.jvp(&moved, &along).unwrap()
        };
        let expected = derivative(settings, false);
        let visibility = PrimaryVisibility::BruteForce;
        let others = [
            derivative(settings, true),
            derivative(Settings { build_quality: BuildQuality::High, ..settings }, false),
            derivative(Settings { visibility, ..settings }, false),
        ];
        assert_eq!(others.map(|other| other == expected), [true; 3]);
    }
}
