//! The environment where light is direct: distant lights that stand for its parts.

use std::f64::consts::{PI, TAU};

use glam::{DVec3, dvec3};
use renderer::scene::{Environment, EnvironmentObject};
use renderer::{Arithmetic, Edges, Image, LossKind, Renderer, Scene, Settings, render};

use crate::area_lights::{blocker_scene, floor, irradiance, shadows_agree_with_differences};
use crate::image::{check_parameter_with, in_arithmetic, target};
use crate::scenes::{set, small_scene};
use crate::sky::{under, uneven};

/// The irradiance of a map on what faces up, by quadrature over its texels.
fn irradiance_of(width: u32, texels: &[[f64; 3]]) -> DVec3 {
    let height = texels.len() as u32 / width;
    let of_texel = |(index, texel): (usize, &[f64; 3])| {
        let row = f64::from(index as u32 / width);
        let [above, below] = [row, row + 1.0].map(|row| (PI * row / f64::from(height)).cos());
        let solid_angle = TAU / f64::from(width) * (above - below);
        DVec3::from(*texel) * solid_angle * (0.5 * (above + below)).max(0.0)
    };
    texels.iter().enumerate().map(of_texel).sum()
}

#[test]
fn an_even_sky_brings_pi_times_its_radiance() {
    let radiance = dvec3(0.3, 0.5, 0.9);
    for (samples, most) in [(16, 0.05), (256, 0.01)] {
        let mut scene = floor(samples);
        scene.environment = Some(Environment::constant(radiance).into());
        let off = irradiance(&scene) / (PI * radiance) - 1.0;
        assert!(off.abs().max_element() < most, "{samples}: {off}");
    }
}

#[test]
fn maps_bring_the_irradiance_of_their_texels() {
    let (width, texels) = (32, uneven(32, 16));
    let expected = irradiance_of(width, &texels);
    for (samples, most) in [(16, 0.1), (256, 0.04)] {
        let mut scene = floor(samples);
        under(&mut scene, width, texels.clone(), 77.0);
        let off = irradiance(&scene) / expected - 1.0;
        assert!(off.abs().max_element() < most, "{samples}: {off}");
    }
}

/// A map that is turned lights as if all else had been turned the other way.
#[test]
fn maps_turn_as_objects_do() {
    let lit = |rotation: f64, turn: f64| {
        let mut scene = blocker_scene();
        scene.light_samples = 16;
        under(&mut scene, 16, uneven(16, 8), rotation);
        for mesh in ["mesh.floor.rotation", "mesh.blocker.rotation"] {
            set(&mut scene, mesh, &[0.0, turn, 0.0]);
        }
        let (sine, cosine) = turn.to_radians().sin_cos();
        let turned = |v: DVec3| dvec3(v.x * cosine + v.z * sine, v.y, v.z * cosine - v.x * sine);
        let (from, at) = (turned(scene.camera.look_from), turned(scene.camera.look_at));
        set(&mut scene, "camera.look_from", &from.to_array());
        set(&mut scene, "camera.look_at", &at.to_array());
        render(&scene, &in_arithmetic(Arithmetic::F64)).unwrap()
    };
    let (still, turned) = (lit(10.0, 0.0), lit(60.0, 50.0));
    let pairs = still.pixels.as_flattened().iter().zip(turned.pixels.as_flattened());
    assert!(pairs.clone().all(|(a, b)| (a - b).abs() < 1e-5));
    assert!(pairs.filter(|(a, _)| **a > 0.1).count() > 1000);
}

/// A scene of everything under a map.
fn scene_under_a_map() -> Scene {
    let mut scene = small_scene(12);
    scene.light_samples = 3;
    under(&mut scene, 4, uneven(4, 3), 20.0);
    set(&mut scene, "environment.radiance", &[0.3, 0.2, 0.25]);
    scene
}

#[test]
fn every_parameter_agrees_with_finite_differences() {
    let scene = scene_under_a_map();
    let target = target(&scene);
    let settings = in_arithmetic(Arithmetic::F64);
    for id in scene.parameters() {
        check_parameter_with(&settings, &scene, &target, LossKind::MeanSquared, id);
    }
}

/// Shadows of the sky move with what casts them and as the map turns.
#[test]
fn edges_of_shadows_of_the_sky() {
    let mut scene = blocker_scene();
    scene.light_samples = 16;
    under(&mut scene, 16, uneven(16, 8), 10.0);
    let paths = ["mesh.blocker.translation", "camera.look_from"];
    shadows_agree_with_differences(&scene, &paths, [12, 64]);
}

/// As the map turns, the image changes as if all else turned the other way.
#[test]
fn derivatives_by_the_turn_of_a_map_are_those_of_all_else() {
    let mut scene = blocker_scene();
    scene.light_samples = 16;
    under(&mut scene, 16, uneven(16, 8), 10.0);
    let settings = Settings { edges: Edges::On, ..in_arithmetic(Arithmetic::F64) };
    let along = |direction: &[(&str, DVec3)]| {
        let direction: Vec<_> = direction
            .iter()
            .map(|(path, numbers)| {
                let id = scene.parameter(path).unwrap();
                (id, numbers.to_array()[..scene.get(id).len()].to_vec())
            })
            .collect();
        Renderer::new(&scene, &settings).unwrap().jvp(&scene, &direction).unwrap().1
    };
    let degree = |v: DVec3| dvec3(v.z, 0.0, -v.x) * 1.0_f64.to_radians();
    let turned_map = along(&[("environment.rotation", DVec3::X)]);
    let turned_rest = along(&[
        ("mesh.floor.rotation", DVec3::Y),
        ("mesh.blocker.rotation", DVec3::Y),
        ("camera.look_from", degree(scene.camera.look_from)),
        ("camera.look_at", degree(scene.camera.look_at)),
    ]);
    let numbers = |image: &Image| image.pixels.as_flattened().to_vec();
    let (map, rest) = (numbers(&turned_map), numbers(&turned_rest));
    let size: f32 = map.iter().map(|number| number.abs()).sum();
    let off: f32 = map.iter().zip(&rest).map(|(a, b)| (a + b).abs()).sum();
    assert!(size > 0.1 && off < 1e-3 * size, "{off} {size}");
}

/// Parts stay where they were cut: a renderer that takes over other texels brings as much of each part as they
/// say.
#[test]
fn parts_stay_while_texels_vary() {
    let mut scene = floor(64);
    under(&mut scene, 8, uneven(8, 4), 0.0);
    let settings = Settings::default().in_double_precision();
    let mut renderer = Renderer::new(&scene, &settings).unwrap();
    let before = renderer.render().pixels[0];
    let texels = scene.parameter("texture.sky.texels").unwrap();
    let twice: Vec<f64> = scene.get(texels).iter().map(|texel| 2.0 * texel).collect();
    scene.set(texels, &twice).unwrap();
    renderer.update(&scene);
    let after = renderer.render().pixels[0];
    for (before, after) in before.into_iter().zip(after) {
        assert!((2.0 * before - after).abs() < 1e-6 * after);
    }
}

#[test]
fn a_dark_sky_lights_nothing_and_has_a_gradient() {
    let mut scene = floor(16);
    scene.environment = Some(EnvironmentObject::from(Environment::constant(DVec3::ZERO)));
    let radiance = scene.parameter("environment.radiance").unwrap();
    let settings = Settings::default().in_double_precision();
    let (image, along) =
        Renderer::new(&scene, &settings).unwrap().jvp(&scene, &[(radiance, vec![1.0; 3])]).unwrap();
    assert_eq!(image.pixels[0], [0.0; 3]);
    assert!(along.pixels[0].iter().all(|derivative| (derivative - 1.0).abs() < 0.05));
}
