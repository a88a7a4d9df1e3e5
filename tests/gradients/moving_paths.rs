//! Gradients by what moves, where light takes all paths: beside closed forms, and beside differences of finely
//! sampled images.

use std::f64::consts::PI;

use glam::{DVec3, dvec3};
use renderer::scene::{Environment, Integrator, MaterialObject, PathTracing};
use renderer::settings::GradientSamples;
use renderer::{
    Camera, Edges, Material, Mesh, PixelLoss, PointLight, Renderer, Samples, Sampling, Scene,
    Settings, SphereObject,
};

use crate::differences::{differences, gradient, relative_error};
use crate::paths::{Sum, assert_close, emitting, floor_scene, paths};
use crate::scenes::set;

/// The irradiance by a ball that shines is that of a disc as wide; here are its derivatives.
#[test]
fn light_of_a_sphere_moves_as_the_closed_form_says() {
    let (center, radius, emission) = (dvec3(1.0, 3.5, -1.0), 1.5, 7.0);
    let mut scene = floor_scene();
    scene.integrator = paths(2, 1024);
    let lamp = scene.add_material("lamp", emitting(emission, 0.0)).unwrap();
    scene.add_sphere(SphereObject::new("lamp", center, radius).material(lamp)).unwrap();
    let distance = center.length();
    // Of pixels of three channels, which all show one point.
    let factor = 192.0 * 0.6 * emission * radius * radius;
    let settings = Settings::default();
    let by_radius = gradient(&scene, &settings, &Sum, "sphere.lamp.radius")[0];
    assert_close(by_radius, factor * 2.0 / radius * center.y / distance.powi(3), 3e-3);
    let by_center = gradient(&scene, &settings, &Sum, "sphere.lamp.center");
    let expected =
        factor * (DVec3::Y / distance.powi(3) - center * (3.0 * center.y / distance.powi(5)));
    for (found, expected) in by_center.into_iter().zip(expected.to_array()) {
        assert!((found - expected).abs() < 5e-3 * factor / distance.powi(3), "{found} {expected}");
    }
}

/// A small patch that shines far above: the irradiance is that of a point, by the fourth power of a cosine.
#[test]
fn light_of_a_patch_moves_as_that_of_a_point() {
    let (at, half) = (dvec3(0.8, 2.0, 0.5), 1e-3);
    let mut scene = floor_scene();
    scene.integrator = paths(2, 64);
    let lamp = scene.add_material("lamp", emitting(1e6, 0.0)).unwrap();
    let corners = [[-half, -half], [half, -half], [half, half], [-half, half]];
    let corners = corners.map(|[x, z]| [at.x + x, at.y, at.z + z]).to_vec();
    let patch = Mesh::new("patch", corners, vec![[0, 1, 2], [0, 2, 3]]).material(lamp);
    scene.add_mesh(patch).unwrap();
    let found = gradient(&scene, &Settings::default(), &Sum, "mesh.patch.translation");
    let (squared, power) = (at.length_squared(), 192.0 * 0.6 / PI * 1e6 * 4.0 * half * half);
    let expected = power
        * (DVec3::Y * (2.0 * at.y / squared.powi(2)) - at * (4.0 * at.y * at.y / squared.powi(3)));
    for (found, expected) in found.into_iter().zip(expected.to_array()) {
        assert_close(found, expected, 2e-3);
    }
}

/// Paths of one piece end at what the camera sees: nothing is lit, and no shadow has an edge.
#[test]
fn what_is_not_lit_has_no_shadows() {
    let mut scene = card(1, 4);
    add_key(&mut scene);
    let place =
        |scene: &Scene| gradient(scene, &Settings::default(), &Weights, "light.key.position");
    assert_eq!(place(&scene), [0.0; 3]);
    scene.integrator = paths(2, 4);
    assert_ne!(place(&scene), [0.0; 3]);
}

/// Weights that vary slowly over the image.
pub struct Weights;

impl PixelLoss for Weights {
    fn evaluate(&self, x: u32, y: u32, radiance: DVec3) -> (f64, DVec3) {
        let weights = DVec3::splat(1.0 + 0.03 * f64::from(x) - 0.02 * f64::from(y));
        (weights.dot(radiance), weights)
    }
}

/// Strips, bands of edges and packets of crossings add up in one order.
#[test]
fn gradients_are_bit_identical_on_any_number_of_threads() {
    let mut scene = card(3, 1);
    (scene.width, scene.height) = (72, 40);
    add_panel(&mut scene);
    let ids = ["camera.look_from", "mesh.card.vertices", "mesh.panel.translation"];
    let ids = ids.map(|path| scene.parameter(path).unwrap());
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let renderer = Renderer::new(&scene, &Settings::default()).unwrap();
            renderer.loss_and_gradient(&scene, &Weights, &ids)
        })
    };
    let one = run(1);
    assert!(one.gradient.concat().iter().all(|number| number.is_finite()));
    assert_eq!(one, run(2));
    assert_eq!(one, run(5));
}

/// A card above a floor, under what is added.
pub fn card(max_depth: u32, samples: u32) -> Scene {
    let camera = Camera::looking(dvec3(0.4, 1.9, 2.6), dvec3(0.0, 0.2, 0.0));
    let mut scene = Scene::new(32, 32, camera);
    scene.add_material("grey", Material::lambertian(DVec3::splat(0.6))).unwrap();
    let red = scene.add_material("red", Material::lambertian(dvec3(0.7, 0.3, 0.2))).unwrap();
    let floor = [[-3.0, 0.0, 3.0], [3.0, 0.0, 3.0], [3.0, 0.0, -3.0], [-3.0, 0.0, -3.0]];
    let card = [[-0.4, 0.4, 0.3], [0.5, 0.5, 0.3], [0.5, 0.6, -0.4], [-0.4, 0.45, -0.4]];
    let quad = |name, corners: [[f64; 3]; 4]| {
        Mesh::new(name, corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]])
    };
    scene.add_mesh(quad("floor", floor)).unwrap();
    scene.add_mesh(quad("card", card).material(red)).unwrap();
    scene.integrator = Integrator::Path(PathTracing { max_depth, samples, seed: 3 });
    scene
}

fn add_key(scene: &mut Scene) {
    let position = dvec3(0.3, 2.0, 0.4);
    let key = PointLight { position, color: DVec3::ONE, radiant_intensity: 5.0 };
    scene.add_light("key", key).unwrap();
}

/// Paths of two pieces end at what a mirror shows, which is dark, and has no edges.
#[test]
fn what_a_mirror_shows_in_the_dark_has_no_edges() {
    let mut scene = card(2, 16);
    add_key(&mut scene);
    let chrome = Material { mirror: DVec3::splat(0.9), ..Material::lambertian(DVec3::ZERO) };
    let chrome = scene.add_material("chrome", chrome).unwrap();
    let wall = [[-2.0, 0.0, -0.8], [2.0, 0.0, -0.8], [2.0, 1.8, -0.8], [-2.0, 1.8, -0.8]];
    let wall = Mesh::new("wall", wall.to_vec(), vec![[0, 1, 2], [0, 2, 3]]).material(chrome);
    scene.add_mesh(wall).unwrap();
    check(&scene, "mesh.card.translation", 0.05);
}

fn add_panel(scene: &mut Scene) {
    let lamp = scene.add_material("lamp", emitting(5.0, 0.0)).unwrap();
    let corners = [[-0.5, 2.0, 0.5], [0.5, 2.1, 0.5], [0.5, 2.0, -0.5], [-0.5, 2.2, -0.5]];
    let panel = Mesh::new("panel", corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]]).material(lamp);
    scene.add_mesh(panel).unwrap();
}

fn add_bulb(scene: &mut Scene) {
    let lamp = scene.add_material("lamp", emitting(5.0, 0.0)).unwrap();
    let bulb = SphereObject::new("bulb", dvec3(0.9, 1.8, 0.2), 0.25).material(lamp);
    scene.add_sphere(bulb).unwrap();
}

/// The gradient with edges is that of an image of a thousand paths through each pixel, without edges, within
/// `most`; without edges it is farther off, where they move.
#[track_caller]
pub fn check(scene: &Scene, path: &str, most: f64) {
    let of = |edges| gradient(scene, &Settings { edges, ..Settings::default() }, &Weights, path);
    let (found, interior) = (of(Edges::Auto), of(Edges::Off));
    let Integrator::Path(limits) = scene.integrator else { panic!("paths") };
    let mut fine = scene.clone();
    fine.integrator = Integrator::Path(PathTracing { samples: 1024, seed: 5, ..limits });
    let step = if path.ends_with("vfov") { 0.5 } else { 0.02 };
    let reference = Settings { edges: Edges::Off, ..Settings::default() };
    let expected = differences(&fine, &reference, &Weights, path, step);
    let [with, without] = [found.clone(), interior].map(|of| relative_error(&of, &expected));
    assert!(with < most, "{path}: {with:.3} off: {found:?}, by differences {expected:?}");
    assert!(without > most, "{path}: {without:.3} off without edges");
}

#[test]
fn soft_shadows_move_with_what_casts_them_and_with_what_shines() {
    let mut scene = card(2, 16);
    add_panel(&mut scene);
    for (path, most) in [
        ("camera.look_from", 0.03),
        ("mesh.card.translation", 0.06),
        ("mesh.floor.translation", 0.03),
        ("mesh.panel.translation", 0.02),
    ] {
        check(&scene, path, most);
    }
    let mut scene = card(2, 16);
    add_bulb(&mut scene);
    check(&scene, "mesh.card.translation", 0.1);
    check(&scene, "sphere.bulb.center", 0.02);
}

/// Light comes through both sides of a ball if paths have so many pieces left, which few paths find.
#[test]
fn shadows_of_transparent_surfaces_move() {
    for (max_depth, most) in [(3, 0.05), (4, 0.3)] {
        let mut scene = card(max_depth, 64);
        add_panel(&mut scene);
        let veil = MaterialObject::from(Material::lambertian(DVec3::splat(0.3))).with_opacity(0.4);
        let veil = scene.add_material("veil", veil).unwrap();
        let ball = SphereObject::new("ball", dvec3(0.2, 1.1, 0.1), 0.3).material(veil);
        scene.add_sphere(ball).unwrap();
        check(&scene, "sphere.ball.radius", most);
    }
}

#[test]
fn hard_shadows_move() {
    let mut scene = card(2, 16);
    let position = dvec3(-0.3, 1.5, 1.0);
    let key = PointLight { position, color: DVec3::ONE, radiant_intensity: 2.0 };
    scene.add_light("key", key).unwrap();
    for (path, most) in [
        ("camera.look_from", 0.02),
        ("mesh.card.translation", 0.06),
        ("mesh.floor.translation", 0.02),
        ("light.key.position", 0.01),
    ] {
        check(&scene, path, most);
    }
}

/// The inner side of a smooth ring, whose triangles stand with their backs to a lamp that their normals face: shadows of
/// many points of it end at one edge.
#[test]
fn shadows_of_a_smooth_ring_on_itself_move() {
    let camera = Camera::looking(dvec3(0.3, 1.6, 4.0), dvec3(0.0, 0.3, 0.0));
    let mut scene = Scene::new(16, 12, Camera { vfov: 40.0, ..camera });
    scene.add_material("grey", Material::lambertian(DVec3::splat(0.8))).unwrap();
    let lamp = scene.add_material("lamp", emitting(400.0, 0.0)).unwrap();
    let (around, across) = (16, 10);
    let corner = |index: u32| {
        let angle = |step: u32, of: u32| 2.0 * PI * f64::from(step) / f64::from(of);
        let (u, v) = (angle(index / across, around), angle(index % across, across));
        let distance = 0.8 + 0.3 * v.cos();
        [distance * u.cos(), 0.3 * v.sin(), distance * u.sin()]
    };
    let sides = |index: u32| {
        let at =
            |u: u32, v: u32| (index / across + u) % around * across + (index % across + v) % across;
        let [a, b, c, d] = [at(0, 0), at(0, 1), at(1, 1), at(1, 0)];
        [[a, b, c], [a, c, d]]
    };
    let vertices = (0..around * across).map(corner).collect();
    let ring = Mesh::new("ring", vertices, (0..around * across).flat_map(sides).collect());
    scene.add_mesh(ring.material(0).smooth()).unwrap();
    set(&mut scene, "mesh.ring.translation", &[0.0, 0.6, 0.0]);
    set(&mut scene, "mesh.ring.rotation", &[40.0, 20.0, 10.0]);
    scene.add_sphere(SphereObject::new("lamp", dvec3(0.9, 1.2, 0.6), 0.03).material(lamp)).unwrap();
    scene.integrator = paths(2, 16);
    check(&scene, "mesh.ring.translation", 0.1);
}

/// More paths find finer shadows.
#[test]
fn thin_shadows_converge() {
    let mut scene = card(2, 1024);
    add_key(&mut scene);
    let rod = [[-0.4, 0.6, 0.3], [0.5, 0.6, 0.33], [0.5, 0.6, 0.34], [-0.4, 0.6, 0.31]];
    scene.meshes[1].vertices = rod.to_vec();
    let path = "mesh.card.translation";
    let expected = differences(&scene, &Settings::default(), &Weights, path, 0.02);
    let errors = [64, 1024].map(|samples| {
        scene.integrator = paths(2, samples);
        relative_error(&gradient(&scene, &Settings::default(), &Weights, path), &expected)
    });
    assert!(errors[1] < 0.25 * errors[0], "{errors:?}");
}

/// What is seen against the sky, and the shadows of an overcast one.
#[test]
fn silhouettes_before_the_sky_move() {
    let mut scene = card(2, 16);
    scene.environment = Some(Environment::constant(DVec3::splat(0.5)).into());
    check(&scene, "camera.look_from", 0.08);
    check(&scene, "camera.vfov", 0.08);
}

/// With more paths shadows of the sky are known better.
#[test]
fn shadows_of_the_sky_converge() {
    let mut scene = card(2, 2048);
    scene.environment = Some(Environment::constant(DVec3::splat(0.5)).into());
    let path = "mesh.card.translation";
    let expected = differences(&scene, &Settings::default(), &Weights, path, 0.02);
    let errors = [16, 64, 256].map(|samples| {
        scene.integrator = paths(2, samples);
        relative_error(&gradient(&scene, &Settings::default(), &Weights, path), &expected)
    });
    assert!(errors.is_sorted_by(|a, b| a > b) && errors[0] < 0.3 && errors[2] < 0.05, "{errors:?}");
}

/// Gradients of independent samples are right on average over their seeds.
#[test]
fn gradients_of_independent_samples_are_right_on_average() {
    let mut scene = card(2, 2048);
    scene.environment = Some(Environment::constant(DVec3::splat(0.5)).into());
    add_panel(&mut scene);
    let path = "mesh.card.translation";
    let expected = differences(&scene, &Settings::default(), &Weights, path, 0.02);
    let of_seed = |seed| {
        let samples = Samples { count: 16, seed, gradient: GradientSamples::Independent };
        let settings = Settings { sampling: Sampling::Sobol(samples), ..Settings::default() };
        gradient(&scene, &settings, &Weights, path)
    };
    let seeds = 100;
    let mut mean = vec![0.0; 3];
    for gradient in (0..seeds).map(of_seed) {
        mean.iter_mut().zip(gradient).for_each(|(mean, x)| *mean += x / f64::from(seeds));
    }
    let error = relative_error(&mean, &expected);
    assert!(error < 0.06, "{error}: {mean:?}, by differences {expected:?}");
}

/// Floor and card reflect much to each other: edges of indirect light count.
#[test]
fn indirect_light_moves() {
    let mut scene = card(4, 64);
    add_panel(&mut scene);
    for (path, most) in [("camera.look_from", 0.05), ("mesh.card.translation", 0.06)] {
        check(&scene, path, most);
    }
}

/// In a closed room of smooth walls no edge is seen.
fn room(wall: MaterialObject) -> Scene {
    let from = dvec3(0.3, 0.1, 0.2);
    let camera = Camera { vfov: 30.0, ..Camera::looking(from, dvec3(-1.0, 0.2, 0.1)) };
    let mut scene = Scene::new(12, 12, camera);
    scene.add_material("wall", wall).unwrap();
    scene.add_sphere(SphereObject::new("room", DVec3::ZERO, 1.0)).unwrap();
    let position = dvec3(-0.4, 0.5, -0.3);
    let glow = PointLight { position, color: DVec3::ONE, radiant_intensity: 1.0 };
    scene.add_light("glow", glow).unwrap();
    scene.integrator = paths(4, 256);
    scene
}

/// Gradients in a room are those of finer images, by differences of this step.
#[track_caller]
fn check_in_room(scene: &Scene, path: &str, step: f64) {
    let settings = Settings::default().in_double_precision();
    let found = gradient(scene, &settings, &Weights, path);
    let finer = Scene { integrator: paths(4, 512), ..scene.clone() };
    let expected = differences(&finer, &settings, &Weights, path, step);
    let size = expected.iter().map(|x| x * x).sum::<f64>().sqrt();
    for (of_found, of_expected) in found.iter().zip(&expected) {
        let error = (of_found - of_expected).abs();
        assert!(error < 0.03 * size, "{path}: {found:?}, by differences {expected:?}");
    }
}

#[test]
fn matt_and_glossy_rooms_move() {
    let color = dvec3(0.7, 0.5, 0.4);
    let glossy = MaterialObject::metallic_roughness(color, 0.6, 0.5);
    for wall in [Material::lambertian(color).into(), glossy] {
        let scene = room(wall);
        for path in ["sphere.room.radius", "light.glow.position", "camera.look_from"] {
            check_in_room(&scene, path, 0.04);
        }
    }
}

/// The camera is inside of a ball of glass, through whose surface it sees the room.
#[test]
fn what_is_seen_through_glass_moves() {
    let mut scene = room(Material::lambertian(dvec3(0.7, 0.5, 0.4)).into());
    let glass = scene.add_material("glass", MaterialObject::dielectric(1.4)).unwrap();
    let lens = SphereObject::new("lens", dvec3(0.32, 0.18, 0.15), 0.2).material(glass);
    scene.add_sphere(lens).unwrap();
    for path in ["material.glass.ior", "sphere.lens.center", "camera.look_from"] {
        check_in_room(&scene, path, 4e-3);
    }
}

/// A ball of glass before an even sky: light that grazes it goes on, so that nothing jumps at its silhouette. Of paths of
/// two pieces it shows what is reflected; seen from afar, what the image lacks grows as the square of the radius.
#[test]
fn silhouettes_of_glass_are_continuous() {
    let camera = Camera { vfov: 2.0, ..Camera::looking(dvec3(0.0, 0.0, 80.0), DVec3::ZERO) };
    let mut scene = Scene::new(24, 24, camera);
    scene.integrator = paths(2, 2048);
    scene.environment = Some(Environment::constant(DVec3::ONE).into());
    let glass = scene.add_material("glass", MaterialObject::dielectric(1.4)).unwrap();
    scene.add_sphere(SphereObject::new("ball", DVec3::ZERO, 1.0).material(glass)).unwrap();
    let renderer = Renderer::new(&scene, &Settings::default()).unwrap();
    let radius = scene.parameter("sphere.ball.radius").unwrap();
    let found = renderer.loss_and_gradient(&scene, &Sum, &[radius]);
    let lacking = f64::from(3 * scene.width * scene.height) - found.loss;
    println!("{} {lacking}", found.gradient.get(radius)[0]);
    assert_close(found.gradient.get(radius)[0], -2.0 * lacking, 0.03);
}
