//! Derivatives of fine images, and of those of a camera far away: rays of single precision tell what lies next to an edge
//! less closely than samples are apart by far.
//!
//! Pixels of an image with many times as many are their means, and so are their derivatives.

use std::f64::consts::{PI, TAU};

use renderer::glam::DVec3;
use renderer::scene::MaterialObject;
use renderer::{Camera, Edges, Image, Material, Mesh, PointLight, Scene, Settings, render_jvp};

use crate::edges::{add_floor, add_lamp, add_sun, paint, veil};

/// The derivative of an image of `side` x `side` pixels by a parameter along x, in 64 x 64 pixels.
pub fn derivative(scene: &Scene, side: u32, path: &str) -> Image {
    let mut scene = scene.clone();
    (scene.width, scene.height) = (side, side);
    let settings = Settings { edges: Edges::On, ..Settings::default() };
    let direction = (scene.parameter(path).unwrap(), vec![1.0, 0.0, 0.0]);
    render_jvp(&scene, &settings, &[direction]).unwrap().1.reduced(64, 64)
}

/// How far the derivatives of a coarse and a fine image are apart, as a part of that of the fine one.
fn change(scene: &Scene, sides: [u32; 2], path: &str) -> f64 {
    let [coarse, fine] = sides.map(|side| derivative(scene, side, path));
    distance(&coarse, &fine)
}

/// How far an image is from another one, as a part of that.
pub fn distance(from: &Image, to: &Image) -> f64 {
    let of = |image: &Image| image.pixels.concat().into_iter().map(f64::from).collect::<Vec<_>>();
    let (from, to) = (of(from), of(to));
    let off: f64 = from.iter().zip(&to).map(|(a, b)| (a - b).abs()).sum();
    off / to.iter().map(|value| value.abs()).sum::<f64>()
}

/// A surface of a grid of vertices that is closed in the first of two directions, and in the second one if `is_torus`.
pub fn add_round(
    scene: &mut Scene,
    [columns, rows]: [u32; 2],
    is_torus: bool,
    paint: u32,
    at: impl Fn(f64, f64) -> DVec3,
) {
    let rings = if is_torus { rows } else { rows + 1 };
    let places = (0..rings * columns).map(|i| [i % columns, i / columns].map(f64::from));
    let vertices = places.map(|[i, j]| at(i / f64::from(columns), j / f64::from(rows)).to_array());
    let faces = (0..rows * columns).flat_map(|i| {
        let (row, column, next) = (i / columns, i % columns, (i + 1) % columns);
        let below = (row + 1) % rings;
        let [a, b] = [column, next].map(|column| row * columns + column);
        let [c, d] = [column, next].map(|column| below * columns + column);
        [[a, b, c], [b, d, c]]
    });
    let mesh = Mesh::new("round", vertices.collect(), faces.collect()).material(paint).smooth();
    scene.add_mesh(mesh).unwrap();
}

/// A coarse smooth ball in the shadow of a sheet, seen from `distance` times as far away as at first.
fn in_shadow(distance: f64, sheet: impl Fn(&mut Scene) -> u32) -> Scene {
    let from = DVec3::new(2.2, 2.4, 3.1);
    let mut camera = Camera::looking(DVec3::new(0.0, 0.2, 0.0) + distance * from, DVec3::Y * 0.2);
    camera.vfov = 2.0 * (0.34 / distance).atan().to_degrees();
    let mut scene = Scene::new(64, 64, camera);
    let ball = paint(&mut scene, "ball", [0.7, 0.6, 0.5], 0.0);
    add_round(&mut scene, [10, 6], false, ball, |u, v| {
        let ((out, y), (z, x)) = ((PI * v).sin_cos(), (TAU * u).sin_cos());
        DVec3::new(out * x, y, out * z)
    });
    let sheet = sheet(&mut scene);
    let corners = vec![[-0.7, 1.6, -0.5], [0.6, 1.7, -0.6], [0.7, 1.5, 0.6], [-0.5, 1.8, 0.5]];
    let mesh = Mesh::new("sheet", corners, vec![[0, 1, 2], [0, 2, 3]]).material(sheet);
    scene.add_mesh(mesh).unwrap();
    let position = DVec3::new(0.7, 5.0, 0.9);
    let lamp = PointLight { position, color: DVec3::ONE, radiant_intensity: 60.0 };
    scene.add_light("lamp", lamp).unwrap();
    scene
}

#[test]
fn shadows_of_transparent_surfaces() {
    let scene = in_shadow(1.0, veil);
    let change = change(&scene, [256, 1024], "mesh.sheet.translation");
    assert!(change < 0.01, "{change}");
}

#[test]
fn shadows_of_opaque_surfaces_seen_from_afar() {
    let scene = in_shadow(40.0, |scene| paint(scene, "sheet", [0.2, 0.4, 0.7], 0.0));
    let change = change(&scene, [512, 2048], "mesh.sheet.translation");
    assert!(change < 0.02, "{change}");
}

/// Light comes to the back of a box through its front, also next to the silhouette where they meet.
#[test]
fn silhouettes_of_transparent_boxes() {
    let mut scene = Scene::new(64, 64, Camera::looking(DVec3::new(2.1, 2.3, 3.4), DVec3::Y * 0.5));
    add_floor(&mut scene, 0.0);
    let veil = MaterialObject::from(Material::lambertian(DVec3::new(0.6, 0.7, 0.4)));
    let veil = scene.add_material("veil", veil.with_opacity(0.5)).unwrap();
    let corner = |i: u32| [i & 1, i >> 1 & 1, i >> 2].map(|bit| f64::from(bit) - 0.5);
    let turned = |[x, y, z]: [f64; 3]| [x + 0.4 * z, y + 0.3 * x + 0.8, z - 0.4 * x];
    let faces =
        [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
    let faces = faces.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    let mesh = Mesh::new("box", (0..8).map(corner).map(turned).collect(), faces).material(veil);
    scene.add_mesh(mesh).unwrap();
    add_lamp(&mut scene);
    add_sun(&mut scene);
    let change = change(&scene, [512, 2048], "mesh.box.translation");
    assert!(change < 0.02, "{change}");
}

/// What a mirror shows that bends rays onto itself is fine, but no pixel shows a thousand times as much as others.
#[test]
fn curved_mirrors_that_show_themselves() {
    let mut scene = Scene::new(64, 64, Camera::looking(DVec3::new(-2.6, 2.4, 0.8), DVec3::ZERO));
    add_floor(&mut scene, 0.0);
    let mirror = paint(&mut scene, "mirror", [0.4, 0.4, 0.2], 0.6);
    add_round(&mut scene, [8, 9], true, mirror, |u, v| {
        let ((sine, cosine), (z, x)) = ((TAU * v).sin_cos(), (TAU * u).sin_cos());
        let thickness = 0.3 * (1.0 + 0.3 * (3.0 * TAU * u).sin() * (2.0 * TAU * v).cos());
        let out = 0.7 + thickness * cosine;
        DVec3::new(out * x, 0.5 + thickness * sine + 0.3 * x, out * z)
    });
    add_lamp(&mut scene);
    add_sun(&mut scene);
    let change = change(&scene, [256, 1024], "mesh.round.translation");
    assert!(change < 0.3, "{change}");
}
