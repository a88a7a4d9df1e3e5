//! Edges of light that comes by several surfaces, and of soft light, beside differences of finely sampled images.

use glam::{DVec3, dvec3};
use renderer::scene::{Environment, Integrator, MaterialObject, PathTracing};
use renderer::settings::GradientSamples;
use renderer::{
    Camera, DistantLight, Edges, Material, Mesh, Renderer, Samples, Sampling, Scene, Settings,
    SphereObject,
};

use crate::differences::{differences, gradient, relative_error};
use crate::moving_paths::{Weights, card};
use crate::paths::{emitting, paths};
use crate::sky::{under, uneven};

fn quad(name: &str, corners: [[f64; 3]; 4]) -> Mesh {
    Mesh::new(name, corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]])
}

/// The camera sees a screen that is lit by a reflector alone, past a card: neither is seen, and the light that comes to
/// the reflector grazes the screen.
fn screen() -> Scene {
    let camera = Camera { vfov: 30.0, ..Camera::looking(DVec3::Z * 3.0, DVec3::ZERO) };
    let mut scene = Scene::new(16, 16, camera);
    scene.add_material("white", Material::lambertian(DVec3::splat(0.8))).unwrap();
    let red = scene.add_material("red", Material::lambertian(dvec3(0.7, 0.3, 0.2))).unwrap();
    let wall = [[-1.0, -1.0, 0.0], [1.2, -1.0, 0.0], [1.2, 1.0, 0.0], [-1.0, 1.0, 0.0]];
    let reflector = [[2.0, -0.6, 0.4], [2.0, 0.7, 0.5], [2.1, 0.6, 1.6], [2.1, -0.7, 1.5]];
    let card = [[1.25, -0.5, 0.3], [1.3, 0.5, 0.3], [1.4, 0.5, 1.1], [1.3, -0.4, 1.1]];
    scene.add_mesh(quad("wall", wall)).unwrap();
    scene.add_mesh(quad("reflector", reflector)).unwrap();
    scene.add_mesh(quad("card", card).material(red)).unwrap();
    scene.integrator = paths(3, 1024);
    scene
}

/// The gradient is that of images of many paths within `most`; that without edges is not.
#[track_caller]
fn check(scene: &Scene, path: &str, samples: u32, most: f64) {
    let settings = Settings::default();
    let found = gradient(scene, &settings, &Weights, path);
    let Integrator::Path(limits) = scene.integrator else { panic!("paths") };
    let finer = PathTracing { samples, seed: 5, ..limits };
    let finer = Scene { integrator: Integrator::Path(finer), ..scene.clone() };
    let without = Settings { edges: Edges::Off, ..settings };
    let expected = differences(&finer, &without, &Weights, path, 0.02);
    let off = relative_error(&found, &expected);
    assert!(off < most, "{path}: {off:.3} off: {found:?}, by differences {expected:?}");
    let off = relative_error(&gradient(scene, &without, &Weights, path), &expected);
    assert!(off > most, "{path}: {off:.3} off without edges");
}

/// A light, whose shadow the card casts on the reflector.
fn add_light(scene: &mut Scene) {
    let light = DistantLight { direction: -DVec3::X, color: DVec3::ONE, irradiance: 9.0 };
    scene.add_light("sun", light).unwrap();
}

#[test]
fn hard_shadows_on_what_is_not_seen_move() {
    let mut scene = screen();
    add_light(&mut scene);
    check(&scene, "mesh.card.translation", 8192, 0.1);
}

/// A lamp that shines on the reflector and on the back of the card.
#[test]
#[ignore = "takes two minutes"]
fn soft_shadows_on_what_is_not_seen_move() {
    let mut scene = screen();
    let lamp = scene.add_material("lamp", emitting(20.0, 0.0)).unwrap();
    let corners = [[-1.0, -1.0, 2.0], [-1.0, -1.0, 1.2], [-1.0, 0.9, 1.2], [-1.0, 1.0, 1.9]];
    scene.add_mesh(quad("lamp", corners).material(lamp)).unwrap();
    let shield = [[-1.2, -1.5, 1.0], [1.0, -1.5, 0.7], [1.0, 1.5, 0.7], [-1.2, 1.5, 1.0]];
    let black = scene.add_material("black", Material::lambertian(DVec3::ZERO)).unwrap();
    scene.add_mesh(quad("shield", shield).material(black)).unwrap();
    scene.camera.look_from = dvec3(0.0, 0.0, 0.6);
    scene.camera.vfov = 90.0;
    scene.integrator = paths(3, 16384);
    check(&scene, "mesh.card.translation", 32768, 0.1);
    check(&scene, "mesh.lamp.translation", 32768, 0.1);
}

/// Tangents of a ball are edges.
#[test]
fn balls_move_in_indirect_light() {
    let mut scene = screen();
    add_light(&mut scene);
    scene.meshes.remove(2);
    let black = scene.add_material("black", Material::lambertian(DVec3::ZERO)).unwrap();
    let ball = SphereObject::new("ball", dvec3(1.4, 0.1, 0.75), 0.4).material(black);
    scene.add_sphere(ball).unwrap();
    check(&scene, "sphere.ball.center", 8192, 0.1);
    check(&scene, "sphere.ball.radius", 8192, 0.1);
}

/// A box above a floor, under an even sky: its ridges are edges too, between faces that are not as bright.
#[test]
fn boxes_move_under_the_sky() {
    let camera = Camera::looking(dvec3(0.5, 2.5, 4.5), dvec3(0.0, 0.6, 0.0));
    let mut scene = Scene::new(24, 18, camera);
    scene.add_material("grey", Material::lambertian(dvec3(0.7, 0.6, 0.5))).unwrap();
    let floor = [[-3.0, 0.0, 3.0], [3.0, 0.0, 3.0], [3.0, 0.0, -3.0], [-3.0, 0.0, -3.0]];
    scene.add_mesh(quad("floor", floor)).unwrap();
    let corner = |i: u32| {
        let at = |axis: u32, ends: [f64; 2]| ends[(i >> axis & 1) as usize];
        [at(0, [-0.5, 0.4]), at(1, [0.2, 1.1]), at(2, [-0.5, 0.5])]
    };
    let sides: [[u32; 4]; 6] =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = sides.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]);
    let triangles = triangles.collect();
    scene.add_mesh(Mesh::new("box", (0..8).map(corner).collect(), triangles)).unwrap();
    scene.environment = Some(Environment::constant(DVec3::splat(0.5)).into());
    scene.integrator = paths(3, 256);
    check(&scene, "mesh.box.translation", 2048, 0.06);
    check(&scene, "camera.look_from", 2048, 0.06);
}

/// A metal that shows a floor and a lamp between a ball and a box: without the edges of indirect light, its derivative
/// would be a third off.
#[test]
fn what_rough_metal_shows_moves() {
    let camera = Camera::looking(dvec3(0.5, 2.5, 4.5), dvec3(0.2, 0.6, 0.0));
    let mut scene = Scene::new(24, 18, camera);
    scene.add_material("grey", Material::lambertian(DVec3::splat(0.6))).unwrap();
    let metal = MaterialObject::metallic_roughness(dvec3(0.9, 0.6, 0.4), 0.7, 0.5);
    let metal = scene.add_material("metal", metal).unwrap();
    let lamp = scene.add_material("lamp", emitting(6.0, 0.0)).unwrap();
    let floor = [[-3.0, 0.0, 3.0], [3.0, 0.0, 3.0], [3.0, 0.0, -3.0], [-3.0, 0.0, -3.0]];
    let square = [[-0.7, 3.0, 0.7], [0.7, 3.0, 0.7], [0.7, 3.0, -0.7], [-0.7, 3.0, -0.7]];
    scene.add_mesh(quad("floor", floor)).unwrap();
    scene.add_mesh(quad("lamp", square).material(lamp)).unwrap();
    let ball = SphereObject::new("ball", dvec3(0.9, 0.8, 0.3), 0.6).material(metal);
    scene.add_sphere(ball).unwrap();
    scene.integrator = paths(3, 1024);
    check(&scene, "sphere.ball.radius", 2048, 0.1);
}

/// A map with a bright spot casts shadows that are sharp, and soft ones besides.
#[test]
fn shadows_of_maps_move() {
    let mut scene = card(2, 256);
    under(&mut scene, 16, uneven(16, 8), 30.0);
    check(&scene, "mesh.card.translation", 2048, 0.1);
}

/// Where materials and lights are so, all ways to find edges are taken: forwards and backwards.
#[test]
fn forwards_and_backwards_are_transposed() {
    let mut scene = screen();
    add_light(&mut scene);
    let lamp = scene.add_material("lamp", emitting(4.0, 0.2)).unwrap();
    let lamps = [[1.2, 1.2, 0.3], [1.8, 1.2, 0.4], [1.8, 1.3, 1.2], [1.2, 1.4, 1.0]];
    scene.add_mesh(quad("lamp", lamps).material(lamp)).unwrap();
    let bulb = SphereObject::new("bulb", dvec3(0.6, -0.9, 1.2), 0.1).material(lamp);
    scene.add_sphere(bulb).unwrap();
    scene.environment = Some(Environment::constant(DVec3::splat(0.1)).into());
    scene.meshes[2] = scene.meshes[2].clone().smooth();
    scene.integrator = paths(4, 4);
    let samples = Samples { count: 4, seed: 3, gradient: GradientSamples::Same };
    let sampling = Sampling::Sobol(samples);
    let settings = Settings { sampling, ..Settings::default() }.in_double_precision();
    let paths = [
        ("camera.look_from", 3),
        ("mesh.card.translation", 3),
        ("mesh.lamp.translation", 3),
        ("sphere.bulb.center", 3),
        ("sphere.bulb.radius", 1),
        ("light.sun.direction", 3),
    ];
    let renderer = Renderer::new(&scene, &settings).unwrap();
    let direction: Vec<_> = paths
        .iter()
        .map(|&(path, count)| {
            let along = (0..count).map(|i| 0.3 + 0.4 * f64::from(i)).collect::<Vec<_>>();
            (scene.parameter(path).unwrap(), along)
        })
        .collect();
    let ids: Vec<_> = direction.iter().map(|(id, _)| *id).collect();
    let (_, along) = renderer.loss_jvp(&scene, &Weights, &direction).unwrap();
    let gradient = renderer.loss_and_gradient(&scene, &Weights, &ids).gradient;
    let of_id = |(id, along): &(_, Vec<f64>)| {
        gradient.get(*id).iter().zip(along).map(|(a, b)| a * b).sum::<f64>()
    };
    let sum: f64 = direction.iter().map(of_id).sum();
    assert!((sum - along).abs() < 1e-6 * along.abs(), "{sum} {along}");
}

/// A scene 10^6 times larger or smaller has the same derivatives by lengths of its own.
#[test]
fn scale_does_not_count() {
    let at = |scale: f64| {
        let mut scene = screen();
        add_light(&mut scene);
        scene.integrator = paths(3, 64);
        scene.camera.look_from *= scale;
        for mesh in &mut scene.meshes {
            mesh.vertices.as_flattened_mut().iter_mut().for_each(|x| *x *= scale);
        }
        let found = gradient(&scene, &Settings::default(), &Weights, "mesh.card.translation");
        found.into_iter().map(|x| x * scale).collect::<Vec<_>>()
    };
    let expected = at(1.0);
    for scale in [1e-6, 1e6] {
        assert!(relative_error(&at(scale), &expected) < 0.03, "{scale}");
    }
}

/// Where nothing has an edge, or nothing shines, derivatives are zeros.
#[test]
fn scenes_without_edges_or_light_have_none() {
    let mut empty = Scene::new(1, 1, Camera::looking(DVec3::Z, DVec3::ZERO));
    empty.integrator = paths(4, 4);
    empty.environment = Some(Environment::constant(DVec3::ONE).into());
    assert_eq!(gradient(&empty, &Settings::default(), &Weights, "camera.look_from"), [0.0; 3]);
    let mut dark = screen();
    dark.integrator = paths(4, 16);
    assert_eq!(gradient(&dark, &Settings::default(), &Weights, "mesh.card.translation"), [0.0; 3]);
}
