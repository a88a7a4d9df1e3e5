//! Lights with an area.

use std::f64::consts::PI;

use glam::{DVec3, dvec3};
use renderer::scene::{AreaLight, MaterialObject};
use renderer::{
    Arithmetic, Camera, Edges, Light, LossKind, Material, Mesh, PointLight, Renderer, Sampling,
    Scene, Settings, SpotLight, render, render_vjp,
};

use crate::image::{check_parameter_with, in_arithmetic, target};
use crate::scenes::small_scene;

const LAMP: AreaLight<f64> = AreaLight {
    center: DVec3::new(0.4, 2.0, 0.3),
    right: DVec3::new(0.8, 0.1, 0.0),
    up: DVec3::new(0.1, 0.0, 0.6),
    color: DVec3::new(1.0, 0.8, 0.6),
    radiance: 3.0,
};

/// A white floor about the origin, of which one pixel from above sees nothing but the middle.
pub fn floor(samples: u32) -> Scene {
    let camera =
        Camera { up: DVec3::Z, vfov: 1e-2, ..Camera::looking(DVec3::Y * 9.0, DVec3::ZERO) };
    let mut scene = Scene::new(1, 1, camera);
    scene.light_samples = samples;
    scene.add_material("white", Material::lambertian(DVec3::ONE)).unwrap();
    let corners = [[-1.0, -1.0], [-1.0, 1.0], [1.0, 1.0], [1.0, -1.0]];
    let corners = corners.map(|[x, z]| [x, 0.0, z]).to_vec();
    scene.add_mesh(Mesh::new("floor", corners, vec![[0, 1, 2], [0, 2, 3]])).unwrap();
    scene
}

fn lit_by(light: Light<f64>, samples: u32) -> Scene {
    let mut scene = floor(samples);
    scene.add_light("lamp", light).unwrap();
    scene
}

pub fn irradiance(scene: &Scene) -> DVec3 {
    let image = render(scene, &in_arithmetic(Arithmetic::F64)).unwrap();
    PI * DVec3::from(image.pixels[0].map(f64::from))
}

/// The irradiance at the origin, facing up, of a polygon that is above it (Lambert 1760).
fn lambert(corners: &[DVec3]) -> f64 {
    let edges = corners.iter().zip(corners.iter().cycle().skip(1));
    let of_edge = |(a, b): (&DVec3, &DVec3)| a.angle_between(*b) * a.cross(*b).normalize().y;
    0.5 * edges.map(of_edge).sum::<f64>().abs()
}

#[test]
fn rectangles_bring_the_irradiance_of_polygons() {
    let AreaLight { center, right, up, color, radiance } = LAMP;
    let corners = [-right - up, right - up, right + up, up - right].map(|corner| center + corner);
    let expected = color * radiance * lambert(&corners);
    // It shines along right x up: downwards.
    assert!(right.cross(up).y < 0.0);
    for (samples, most) in [(16, 6e-3), (256, 4e-4), (4096, 4e-5)] {
        let off = irradiance(&lit_by(Light::Rectangle(LAMP), samples)) / expected - 1.0;
        assert!(off.abs().max_element() < most, "{samples}: {off}");
    }
    let back = AreaLight { right: -right, ..LAMP };
    assert_eq!(irradiance(&lit_by(Light::Rectangle(back), 16)), DVec3::ZERO);
}

#[test]
fn discs_bring_the_irradiance_of_discs() {
    let (radius, height) = (0.7, 1.9);
    let disc = AreaLight {
        center: DVec3::Y * height,
        right: DVec3::X * radius,
        up: DVec3::Z * radius,
        ..LAMP
    };
    let expected =
        disc.color * disc.radiance * PI * radius.powi(2) / (radius.powi(2) + height.powi(2));
    for (samples, most) in [(16, 2e-2), (1024, 4e-4)] {
        let off = irradiance(&lit_by(Light::Disc(disc), samples)) / expected - 1.0;
        assert!(off.abs().max_element() < most, "{samples}: {off}");
    }
}

/// Where a light does not shine it casts no shadows, and edges of others are not its own, where they would be.
#[test]
fn lights_that_are_turned_away_have_no_edges() {
    let mut scene = blocker_scene();
    scene.light_samples = 1;
    let veil = MaterialObject::from(Material::lambertian(DVec3::splat(0.5))).with_opacity(0.5);
    let veil = scene.add_material("veil", veil).unwrap();
    scene.meshes[1] = scene.meshes[1].clone().material(veil);
    let (position, color, radiant_intensity) = (dvec3(1.5, 6.0, 0.9), DVec3::ONE, 9.0);
    let bulb = PointLight { position, color, radiant_intensity };
    scene.add_light("bulb", bulb).unwrap();
    let (right, up) = position.normalize().any_orthonormal_pair();
    let lamp = AreaLight { center: position, right, up, color, radiance: 3.0 };
    scene.add_light("lamp", Light::Rectangle(lamp)).unwrap();
    let (direction, inner_angle, outer_angle) = (DVec3::X, 10.0, 20.0);
    let spot =
        SpotLight { position, direction, color, radiant_intensity, inner_angle, outer_angle };
    scene.add_light("spot", spot).unwrap();

    let settings = Settings { edges: Edges::On, ..Settings::default() }.in_double_precision();
    let renderer = Renderer::new(&scene, &settings).unwrap();
    for path in ["light.lamp.center", "light.spot.position", "light.bulb.position"] {
        let id = scene.parameter(path).unwrap();
        let (_, along) = renderer.jvp(&scene, &[(id, vec![0.3, 0.1, -0.2])]).unwrap();
        let is_zero = along.pixels.iter().all(|pixel| *pixel == [0.0; 3]);
        assert_eq!(is_zero, path != "light.bulb.position", "{path}");
    }
}

fn add_lamps(scene: &mut Scene) {
    scene.light_samples = 3;
    scene.add_light("panel", Light::Rectangle(LAMP)).unwrap();
    let center = dvec3(-2.0, 3.0, 2.0);
    // Shines towards the middle.
    let (right, up) = (dvec3(0.5, 0.1, 0.5), dvec3(-0.2, 0.6, 0.1));
    assert!(right.cross(up).dot(center) < 0.0 || up.cross(right).dot(center) < 0.0);
    let (right, up) = if right.cross(up).dot(center) < 0.0 { (right, up) } else { (up, right) };
    let disc = AreaLight { center, right, up, radiance: 12.0, ..LAMP };
    scene.add_light("disc", Light::Disc(disc)).unwrap();
}

#[test]
fn every_parameter_agrees_with_finite_differences() {
    let mut scene = small_scene(16);
    add_lamps(&mut scene);
    let target = target(&scene);
    let settings = in_arithmetic(Arithmetic::F64);
    for id in scene.parameters() {
        check_parameter_with(&settings, &scene, &target, LossKind::MeanSquared, id);
    }
}

/// A small triangle over a large floor, without lights.
pub fn blocker_scene() -> Scene {
    let mut scene = Scene::new(40, 32, Camera::looking(dvec3(0.3, 2.6, 4.0), dvec3(0.0, 0.2, 0.0)));
    scene.light_samples = 4;
    scene.add_material("white", Material::lambertian(DVec3::splat(0.8))).unwrap();
    let floor = vec![[-6.0, 0.0, -6.0], [6.0, 0.0, -6.0], [6.0, 0.0, 6.0], [-6.0, 0.0, 6.0]];
    scene.add_mesh(Mesh::new("floor", floor, vec![[0, 2, 1], [0, 3, 2]])).unwrap();
    let blocker = vec![[-0.6, 0.7, 0.1], [0.5, 0.6, 0.4], [0.1, 0.8, -0.7]];
    scene.add_mesh(Mesh::new("blocker", blocker, vec![[0, 1, 2]])).unwrap();
    scene
}

/// Derivatives by parameters that move shadows, from so many rays along a side of each pixel, against
/// differences of more finely sampled images, from which the interior terms are far.
pub fn shadows_agree_with_differences(scene: &Scene, paths: &[&str], sides: [u32; 2]) {
    let [side, fine] = sides;
    const STEP: f64 = 0.02;
    let settings = |edges, side| {
        let settings = Settings { edges, sampling: Sampling::Grid(side), ..Settings::default() };
        settings.in_double_precision()
    };
    let weights = |x: u32, y: u32| 1.0 + (0.3 * f64::from(x)).sin() + (0.2 * f64::from(y)).cos();
    let sum = |image: &renderer::Image| -> f64 {
        let weighted = |(index, pixel): (usize, &[f32; 3])| {
            weights(index as u32 % 40, index as u32 / 40) * f64::from(pixel[0])
        };
        image.pixels.iter().enumerate().map(weighted).sum()
    };
    for path in paths {
        let id = scene.parameter(path).unwrap();
        let values = scene.get(id).into_owned();
        let direction = &[0.4, -0.3, 0.6][..values.len()];
        let moved = |by: f64| {
            let mut moved = scene.clone();
            let values: Vec<f64> = values.iter().zip(direction).map(|(v, d)| v + by * d).collect();
            moved.set(id, &values).unwrap();
            sum(&render(&moved, &settings(Edges::Off, fine)).unwrap())
        };
        let expected = (moved(STEP) - moved(-STEP)) / (2.0 * STEP);
        let renderer = Renderer::new(scene, &settings(Edges::On, side)).unwrap();
        let (_, along) = renderer.jvp(scene, &[(id, direction.to_vec())]).unwrap();
        let found = sum(&along);
        assert!((found - expected).abs() < 1e-2 * expected.abs(), "{path}: {found} {expected}");
        let interior = Renderer::new(scene, &settings(Edges::Off, side)).unwrap();
        let interior = sum(&interior.jvp(scene, &[(id, direction.to_vec())]).unwrap().1);
        let is_far = (interior - expected).abs() > 0.01 * expected.abs();
        assert!(is_far, "{path}: {interior} {expected}");
    }
}

/// Soft shadows move with what casts them and with the light.
#[test]
fn edges_of_soft_shadows() {
    let mut scene = blocker_scene();
    scene.add_light("panel", Light::Rectangle(AreaLight { radiance: 9.0, ..LAMP })).unwrap();
    let of_light = ["light.panel.center", "light.panel.right", "light.panel.up"];
    shadows_agree_with_differences(&scene, &of_light, [4, 32]);
    shadows_agree_with_differences(
        &scene,
        &["mesh.blocker.translation", "camera.look_from"],
        [4, 32],
    );
}

#[test]
fn what_is_wrong_with_lights_with_an_area_is_said() {
    let mut scene = small_scene(8);
    let mut refused = |light: AreaLight<f64>| {
        scene.add_light("panel", Light::Rectangle(light)).unwrap_err().to_string()
    };
    let parallel = refused(AreaLight { up: 2.0 * LAMP.right, ..LAMP });
    assert_eq!(parallel, "light.panel.right: `right` and `up` must not point along one line");
    assert!(refused(AreaLight { up: DVec3::ZERO, ..LAMP }).starts_with("light.panel.up: "));
    assert!(refused(AreaLight { radiance: -1.0, ..LAMP }).contains("light.panel.radiance"));
    scene.light_samples = 65;
    scene.add_light("panel", Light::Rectangle(LAMP)).unwrap();
    let camera = scene.parameter("camera.look_from").unwrap();
    let gradient = |scene: &Scene, settings: &Settings| {
        render_vjp(scene, settings, &[camera]).map(|_| ()).map_err(|error| error.to_string())
    };
    let error = gradient(&scene, &Settings::default()).unwrap_err();
    assert!(error.starts_with("light: 67 lights, or points of them"), "{error}");
    gradient(&scene, &Settings { edges: Edges::Off, ..Settings::default() }).unwrap();
    scene.light_samples = 62;
    gradient(&scene, &Settings::default()).unwrap();
    scene.light_samples = 0;
    let error = render(&scene, &Settings::default()).unwrap_err().to_string();
    assert!(error.contains("light_samples: must lie between 1 and 4096, is 0"), "{error}");
}
