//! Maps of the light from everywhere: what they bring, beside quadrature, and gradients by them.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::{DVec3, dvec3};
use renderer::scene::{Environment, EnvironmentObject, Wrap};
use renderer::{
    Arithmetic, Camera, Material, Mesh, Renderer, Scene, Settings, SphereObject, Texture, render,
};

use crate::image::in_arithmetic;
use crate::paths::{Sum, agrees_with_differences, assert_close, floor_scene, mean, paths};
use crate::scenes::set;

type Texels = Vec<[f64; 3]>;

/// Puts a scene under a map of `width` columns.
pub fn under(scene: &mut Scene, width: u32, texels: Texels, rotation: f64) {
    let height = texels.len() as u32 / width;
    let map =
        Texture { name: "sky".into(), width, height, wrap: Wrap::Mirror, texels: texels.into() };
    let map = scene.add_texture(map).unwrap();
    let values = Environment { radiance: DVec3::ONE, rotation };
    scene.environment = Some(EnvironmentObject::from(values).with_texture(map));
}

/// A map without any symmetry: dim, with a bright spot.
pub fn uneven(width: u32, height: u32) -> Texels {
    let texel = |i: u32| {
        let (x, y) = (f64::from(i % width), f64::from(i / width));
        let spot = if i == width * (height / 3) + width / 4 { 20.0 } else { 0.0 };
        [0.3 + 0.1 * x.sin() + spot, 0.4 + 0.2 * (x * y).cos() + spot, 0.2 + 0.05 * y + 0.5 * spot]
    };
    (0..width * height).map(texel).collect()
}

/// A rough ball and a pane that mirrors over a floor, under a map, with a lamp beside.
pub fn sky_scene(size: u32) -> Scene {
    let mut scene = Scene::new(size, size, Camera::looking(dvec3(0.5, 1.5, 4.0), DVec3::ZERO));
    let grey = Material { roughness: 0.4, ..Material::lambertian(dvec3(0.6, 0.5, 0.7)) };
    let glossy = Material {
        specular: dvec3(0.3, 0.2, 0.25),
        exponent: 12.0,
        ..Material::lambertian(dvec3(0.3, 0.5, 0.2))
    };
    let mirror = Material { mirror: DVec3::splat(0.6), ..grey };
    let lamp = Material { emission: dvec3(2.0, 1.5, 1.0), ..grey };
    let [floor, ball, pane, lamp] =
        [("floor", grey), ("ball", glossy), ("pane", mirror), ("lamp", lamp)]
            .map(|(name, material)| scene.add_material(name, material).unwrap());
    let mut quad = |name: &str, corners: [[f64; 3]; 4], material| {
        let mesh = Mesh::new(name, corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]]);
        scene.add_mesh(mesh.material(material)).unwrap();
    };
    quad(
        "floor",
        [[-2.0, -1.0, 2.0], [2.0, -1.0, 2.0], [2.0, -1.0, -2.0], [-2.0, -1.0, -2.0]],
        floor,
    );
    quad(
        "pane",
        [[-1.9, -1.0, -1.0], [-0.6, -1.0, -1.6], [-0.6, 0.6, -1.6], [-1.9, 0.6, -1.0]],
        pane,
    );
    quad("lamp", [[1.2, 0.2, -0.4], [1.6, 0.2, -0.3], [1.5, 0.7, -0.3], [1.1, 0.7, -0.4]], lamp);
    scene.add_sphere(SphereObject::new("ball", DVec3::ZERO, 0.8).material(ball)).unwrap();
    under(&mut scene, 6, uneven(6, 4), 25.0);
    set(&mut scene, "environment.radiance", &[0.9, 1.1, 0.8]);
    scene.integrator = paths(4, 8);
    scene
}

/// The bilinear radiance of a map, written once more.
fn radiance(texels: &Texels, width: usize, rotation: f64, direction: DVec3) -> DVec3 {
    let height = texels.len() / width;
    let longitude = direction.x.atan2(-direction.z) / TAU + rotation / 360.0 + 0.5;
    let x = longitude.rem_euclid(1.0) * width as f64 - 0.5;
    let y = direction.y.clamp(-1.0, 1.0).acos() / PI * height as f64 - 0.5;
    let texel = |x: f64, y: f64| {
        let row = y.clamp(0.0, height as f64 - 1.0) as usize;
        DVec3::from(texels[row * width + (x as i64).rem_euclid(width as i64) as usize])
    };
    let (left, top) = (x.floor(), y.floor());
    let row = |y: f64| texel(left, y).lerp(texel(left + 1.0, y), x - left);
    row(top).lerp(row(top + 1.0), y - top)
}

/// The irradiance that a map brings to a plane that looks upwards, by quadrature.
fn irradiance(texels: &Texels, width: usize, rotation: f64) -> DVec3 {
    const STEPS: usize = 600;
    let mut sum = DVec3::ZERO;
    for i in 0..STEPS {
        let angle = FRAC_PI_2 * (i as f64 + 0.5) / STEPS as f64;
        for j in 0..2 * STEPS {
            let around = PI * (j as f64 + 0.5) / STEPS as f64;
            let (sine, cosine) = angle.sin_cos();
            let direction = dvec3(sine * around.cos(), cosine, sine * around.sin());
            sum += radiance(texels, width, rotation, direction) * (sine * cosine);
        }
    }
    sum * (FRAC_PI_2 / STEPS as f64 * PI / STEPS as f64)
}

#[test]
fn a_plane_receives_what_quadrature_says() {
    let mut spot = vec![[0.0; 3]; 16 * 8];
    spot[2 * 16 + 5] = [90.0, 50.0, 10.0];
    for (texels, width, rotation) in [
        (uneven(12, 6), 12, 0.0),
        (uneven(12, 6), 12, 77.0),
        (spot, 16, -11.0),
        (uneven(1, 5), 1, 10.0),
        (uneven(5, 1), 5, 0.0),
        (vec![[3.0, 2.0, 1.0]], 1, 123.0),
    ] {
        let expected = irradiance(&texels, width, rotation) * 0.6 / PI;
        let mut scene = floor_scene();
        under(&mut scene, width as u32, texels, rotation);
        scene.integrator = paths(2, 1024);
        let image = render(&scene, &Settings::default()).unwrap();
        let pixels = image.pixels.iter().map(|pixel| glam::Vec3::from(*pixel).as_dvec3());
        let found = pixels.sum::<DVec3>() / image.pixels.len() as f64;
        assert!((found / expected - 1.0).abs().max_element() < 3e-3, "{found} of {expected}");
    }
}

/// A map of one value is a constant environment: what camera rays see of it to round-off, the rest but for
/// noise.
#[test]
fn even_maps_are_constant_environments() {
    let mut constant = sky_scene(16);
    constant.integrator = paths(4, 256);
    let value = [0.7, 0.6, 0.5];
    constant.environment = Some(Environment::constant(value.into()).into());
    for (width, height) in [(1, 1), (8, 4)] {
        let mut even = constant.clone();
        even.textures.clear();
        under(&mut even, width, vec![value; width as usize * height], 40.0);
        let settings = Settings::default();
        assert_close(mean(&even, &settings), mean(&constant, &settings), 2e-3);
        let corner = |scene: &Scene| render(scene, &settings).unwrap().pixels[0];
        for (a, b) in corner(&even).into_iter().zip(corner(&constant)) {
            assert!((a - b).abs() < 1e-5, "{a} {b}");
        }
    }
}

/// Which way a map lies: its middle towards -z, its right half towards +x, its top up; and it turns as objects do.
#[test]
fn maps_lie_and_turn_as_the_documentation_says() {
    let texels: Texels = (0..8 * 4).map(|i| [f64::from(i % 8), f64::from(i / 8), 1.0]).collect();
    let seen = |direction: DVec3, rotation: f64| {
        let up = if direction.y.abs() > 0.9 { DVec3::X } else { DVec3::Y };
        let mut camera = Camera { up, ..Camera::looking(DVec3::ZERO, direction) };
        camera.film_scale = 1e-3;
        let mut scene = Scene::new(1, 1, camera);
        under(&mut scene, 8, texels.clone(), rotation);
        scene.integrator = paths(1, 1);
        render(&scene, &in_arithmetic(Arithmetic::F64)).unwrap().pixels[0]
    };
    let near = |found: [f32; 3], x: f32, y: f32| {
        assert!((found[0] - x).abs() < 0.02 && (found[1] - y).abs() < 0.02, "{found:?}: {x} {y}");
    };
    near(seen(-DVec3::Z, 0.0), 3.5, 1.5);
    near(seen(DVec3::X, 0.0), 5.5, 1.5);
    near(seen(-DVec3::X, 0.0), 1.5, 1.5);
    assert!((seen(DVec3::Y, 0.0)[1], seen(-DVec3::Y, 0.0)[1]) < (0.02, 3.0 + 0.02));
    near(seen(dvec3(0.0, 1.0, -1.0), 0.0), 3.5, 0.5);
    // A quarter turn about y takes -z to -x.
    near(seen(-DVec3::X, 90.0), 3.5, 1.5);
    near(seen(-DVec3::Z, 90.0), 5.5, 1.5);
    near(seen(-DVec3::Z, 90.0 - 720.0), 5.5, 1.5);
}

#[test]
fn gradients_by_texels_and_rotation_agree_with_differences() {
    agrees_with_differences(&sky_scene(12));
}

#[test]
fn backgrounds_hide_the_environment_from_the_camera_and_nothing_else() {
    let mut scene = sky_scene(16);
    let settings = Settings::default();
    let plain = render(&scene, &settings).unwrap();
    scene.environment.as_mut().unwrap().background = Some(dvec3(0.25, 0.5, 8.0));
    let hidden = render(&scene, &settings).unwrap();
    let shown = |pixel: &[f32; 3]| *pixel == [0.25, 0.5, 8.0];
    let count = hidden.pixels.iter().filter(|pixel| shown(pixel)).count();
    let same = plain.pixels.iter().zip(&hidden.pixels).filter(|(a, b)| a == b).count();
    assert!(count > 20 && same > 50, "{count} {same}");
    agrees_with_differences(&Scene { width: 8, height: 8, ..scene });
}

/// Radiances of any size, and none.
#[test]
fn extreme_maps_are_exact_multiples_of_ordinary_ones() {
    let mut scene = sky_scene(12);
    set(&mut scene, "material.lamp.emission", &[0.0; 3]);
    let ids = ["texture.sky.texels", "material.floor.diffuse", "environment.rotation"];
    let ids = ids.map(|path| scene.parameter(path).unwrap());
    let texels = scene.get(ids[0]).into_owned();
    let mut of = |factor: f64| {
        let scaled: Vec<f64> = texels.iter().map(|value| value * factor).collect();
        scene.assign(ids[0], &scaled);
        let renderer = Renderer::new(&scene, &Settings::default()).unwrap();
        let result = renderer.loss_and_gradient(&scene, &Sum, &ids);
        let [texels, albedo, rotation] = ids.map(|id| result.gradient.get(id).iter().sum::<f64>());
        [result.loss, texels * factor, albedo, rotation]
    };
    let ordinary = of(1.0);
    assert!(ordinary[..3].iter().all(|value| *value > 0.0) && ordinary[3] != 0.0, "{ordinary:?}");
    for factor in [f64::powi(2.0, -66), f64::powi(2.0, 66)] {
        for (found, expected) in of(factor).into_iter().zip(ordinary) {
            assert_close(found / factor, expected, 1e-5);
        }
    }
    let black = of(0.0);
    assert_eq!(black[0], 0.0);
    assert!(black.iter().all(|value| value.is_finite()), "{black:?}");
}
