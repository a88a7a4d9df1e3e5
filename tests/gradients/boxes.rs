//! Gradients of boxes: with faces that the camera grazes, and where they stand on what is under them.

use renderer::glam::DVec3;
use renderer::{
    Arithmetic, Camera, DistantLight, Edges, Image, Mesh, PixelLoss, PointLight, Precision, Scene,
    Settings,
};

use crate::differences::gradient;
use crate::edges::{add_floor, paint, settings};

const HEIGHT: u32 = 18;

/// A loss that is linear in the image, with weights that vary slowly over it: most of what is near its lower border.
struct Weights;

impl PixelLoss for Weights {
    fn evaluate(&self, x: u32, y: u32, radiance: DVec3) -> (f64, DVec3) {
        let down = f64::from(y) / f64::from(HEIGHT);
        let weight = (1.2 + (0.21 * f64::from(x) + 0.4).sin()) * down * down * down;
        let weights = DVec3::new(1.0, 0.5, 0.7) * weight;
        (weights.dot(radiance), weights)
    }
}

/// A box of width 1 on the plane y = 0, turned by 30 degrees, before a camera that is tilted, so that no edge goes along
/// samples.
fn scene(look_from: DVec3, look_at: DVec3) -> Scene {
    let camera = Camera { up: DVec3::new(0.3, 1.0, 0.0), ..Camera::looking(look_from, look_at) };
    let mut scene = Scene::new(24, HEIGHT, camera);
    let paint = paint(&mut scene, "box", [0.2, 0.3, 0.8], 0.0);
    let corner = |index: u32| {
        let [x, y, z] = [0, 1, 2].map(|axis| f64::from(index >> axis & 1));
        let (sin, cos) = 30.0_f64.to_radians().sin_cos();
        let (x, z) = (x - 0.5, z - 0.5);
        [0.1 + x * cos + z * sin, y, 0.2 - x * sin + z * cos]
    };
    let sides =
        [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    let faces = sides.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    let mesh = Mesh::new("box", (0..8).map(corner).collect(), faces).material(paint);
    scene.add_mesh(mesh).unwrap();
    let position = DVec3::new(1.0, 3.0, 3.0);
    let lamp = PointLight { position, color: DVec3::ONE, radiant_intensity: 50.0 };
    scene.add_light("lamp", lamp).unwrap();
    scene
}

/// The loss of a finely sampled image after a translation of a mesh along y.
fn moved(scene: &Scene, path: &str, by: f64, side: u32) -> f64 {
    let mut scene = scene.clone();
    scene.set(scene.parameter(path).unwrap(), &[0.0, by, 0.0]).unwrap();
    let settings: Settings = settings(Edges::Off, side);
    renderer::Renderer::new(&scene, &settings).unwrap().loss(&Weights)
}

/// The face on top is a few hundredths of a pixel wide, and less: hardly a sample meets it, and the point that such a one
/// meets moves by hundreds of times the way of the box.
#[test]
fn faces_that_the_camera_grazes() {
    for above in [0.02, 0.003] {
        let scene = scene(DVec3::new(0.3, 1.0 + above, 4.0), DVec3::new(0.0, 0.6, 0.0));
        let path = "mesh.box.translation";
        let step = 0.25 * above;
        let loss = |by: f64| moved(&scene, path, by, 96);
        let expected = (loss(step) - loss(-step)) / (2.0 * step);
        for side in [1, 4] {
            let found = gradient(&scene, &settings(Edges::On, side), &Weights, path)[1];
            let error = (found - expected).abs() / expected.abs();
            assert!(error < 0.05, "{above}, {side}: {found} instead of {expected}");
        }
    }
}

/// A box on a floor has two derivatives by its height: on the way up a gap opens, and a shadow in it. That on the way
/// down is given.
#[test]
fn boxes_that_stand_on_a_floor() {
    let mut scene = scene(DVec3::new(0.3, 1.6, 4.0), DVec3::new(0.0, 0.6, 0.0));
    add_floor(&mut scene, 0.0);
    for (path, into) in [("mesh.box.translation", -1.0), ("mesh.floor.translation", 1.0)] {
        let step = 5e-3;
        let loss = |steps: f64| moved(&scene, path, steps * step, 96);
        // Of second order, to one side.
        let one_sided =
            |way: f64| (4.0 * loss(way) - 3.0 * loss(0.0) - loss(2.0 * way)) / (2.0 * way * step);
        let (expected, other) = (one_sided(into), one_sided(-into));
        // With one ray a pixel the derivative is known less well.
        for (side, most) in [(1, 0.15), (4, 0.1)] {
            let found = gradient(&scene, &settings(Edges::On, side), &Weights, path)[1];
            let error = (found - expected).abs() / (other - expected).abs();
            assert!(error < most, "{path}, {side}: {found}, not {expected}, nor {other}");
        }
    }
}

/// Single precision rounds the corners of a turned face off its plane, the more the smaller it is where it stands.
/// The line in which it is cut into triangles is no edge for that.
#[test]
fn faces_stay_flat_in_single_precision() {
    let image = |scene: &Scene, precision| {
        let arithmetic = Arithmetic::fastest(precision);
        renderer::render(scene, &Settings { arithmetic, ..settings(Edges::On, 1) }).unwrap()
    };
    for (size, place) in [(1.0, DVec3::ZERO), (0.05, DVec3::new(9.0, -7.0, 11.0))] {
        let mut scene = scene(place + size * DVec3::new(0.3, 1.6, 4.0), place);
        let mut set = |path: &str, values: [f64; 3]| {
            let id = scene.parameter(path).unwrap();
            let one_for_all = scene.count(id) == 1;
            scene.set(id, if one_for_all { &values[..1] } else { &values }).unwrap();
        };
        set("light.lamp.position", (place + size * DVec3::new(1.0, 3.0, 3.0)).to_array());
        set("light.lamp.radiant_intensity", [50.0 * size * size; 3]);
        set("mesh.box.translation", place.to_array());
        set("mesh.box.scale", [size; 3]);
        for turn in 0..20 {
            let turn = f64::from(turn);
            let rotation = scene.parameter("mesh.box.rotation").unwrap();
            scene.set(rotation, &[17.3 * turn, 31.1 * turn + 2.0, 11.9 * turn]).unwrap();
            let [single, double] = [Precision::F32, Precision::F64].map(|of| image(&scene, of));
            let brightest = double.pixels.as_flattened().iter().fold(0.0_f32, |a, &b| a.max(b));
            let difference = single.absolute_difference(&double).unwrap();
            let most = difference.pixels.as_flattened().iter().fold(0.0_f32, |a, &b| a.max(b));
            assert!(most < 2e-3 * brightest, "size {size}, turn {turn}: {most} of {brightest}");
        }
    }
}

/// At the corners of a box whose faces are bent along a diagonal up to six edges meet: they cut a pixel into as many
/// parts, though one ray goes through it.
#[test]
fn pixels_at_corners_of_many_edges() {
    let (look_from, look_at) = (DVec3::new(0.394491, 2.12936, 5.93158), DVec3::new(0.0, 0.6, 0.0));
    let mut scene = Scene::new(32, 24, Camera::looking(look_from, look_at));
    let paint = paint(&mut scene, "box", [0.8; 3], 0.0);
    // A little off the faces of a cube.
    let corner = |index: u32| {
        [4, 2, 1].map(|bit| {
            let side = if index & bit == 0 { -1.0 } else { 1.0 };
            side + 1e-3 * f64::from((7 * index + bit) % 11) / 11.0
        })
    };
    let faces = [
        [[0, 1, 3], [0, 3, 2]],
        [[4, 6, 7], [4, 7, 5]],
        [[0, 4, 5], [0, 5, 1]],
        [[2, 3, 7], [2, 7, 6]],
        [[0, 2, 6], [0, 6, 4]],
        [[1, 5, 7], [1, 7, 3]],
    ];
    let mesh = Mesh::new("box", (0..8).map(corner).collect(), faces.concat()).material(paint);
    scene.add_mesh(mesh).unwrap();
    for (path, values) in [
        ("mesh.box.translation", [-1.0, 0.7, 0.0]),
        ("mesh.box.rotation", [8.08610263, 31.28219499, 3.62465681]),
        ("mesh.box.scale", [0.7; 3]),
    ] {
        let id = scene.parameter(path).unwrap();
        let count = scene.count(id);
        scene.set(id, &values[..count]).unwrap();
    }
    let position = DVec3::new(2.63, 4.617, 4.82);
    let lamp = PointLight { position, color: DVec3::ONE, radiant_intensity: 130.0 };
    scene.add_light("lamp", lamp).unwrap();
    let render = |edges, side| renderer::render(&scene, &settings(edges, side)).unwrap();
    let (image, fine) = (render(Edges::On, 1), render(Edges::Off, 64));
    let difference = image.absolute_difference(&fine).unwrap();
    let largest =
        |image: &Image| image.pixels.as_flattened().iter().fold(0.0_f32, |a, &b| a.max(b));
    let (error, brightest) = (largest(&difference), largest(&fine));
    assert!(error < 0.03 * brightest, "{error} of {brightest}");
}

/// Two ridges that run side by side within a pixel, as those of a bevel, are two edges, from whichever side links come to
/// each of them.
#[test]
fn ridges_side_by_side_within_a_pixel() {
    for turn in [0.7_f64, -0.7] {
        let (away, side) = (300.0, 32);
        let mut scene = Scene::new(side, side, Camera::looking(away * DVec3::Z, DVec3::ZERO));
        let vfov = 2.0 * (0.5 * f64::from(side) / away).atan().to_degrees();
        let id = scene.parameter("camera.vfov").unwrap();
        scene.set(id, &[vfov]).unwrap();
        let paint = paint(&mut scene, "bevel", [0.8; 3], 0.0);
        let (sin, cos) = turn.sin_cos();
        let corner = |across: f64, z: f64| {
            [-26.0, 26.0].map(|along| [across * cos - along * sin, across * sin + along * cos, z])
        };
        let corners = [corner(-14.0, -11.2), corner(0.0, 0.0), corner(0.6, 0.0), corner(14.6, 8.4)];
        let faces =
            (0..3).flat_map(|strip| [[0, 2, 3], [0, 3, 1]].map(|at| at.map(|i| i + 2 * strip)));
        let mesh = Mesh::new("bevel", corners.concat(), faces.collect()).material(paint);
        scene.add_mesh(mesh).unwrap();
        let direction = DVec3::new(0.5, 0.3, 0.8);
        let light = DistantLight { direction, color: DVec3::ONE, irradiance: 3.0 };
        scene.add_light("sun", light).unwrap();
        let render = |edges, side| renderer::render(&scene, &settings(edges, side)).unwrap();
        let (image, fine) = (render(Edges::On, 1), render(Edges::Off, 48));
        let (mut bias, mut most, mut brightest) = (0.0, 0.0_f64, 0.0_f64);
        for (value, expected) in image.pixels.into_iter().zip(fine.pixels) {
            let [value, expected] = [value, expected].map(|pixel| f64::from(pixel[0]));
            bias += value - expected;
            most = most.max((value - expected).abs());
            brightest = brightest.max(expected);
        }
        assert!(most < 0.02 * brightest, "turn {turn}: {most} of {brightest}");
        assert!(bias.abs() < 0.1 * brightest, "turn {turn}: {bias} of {brightest}");
    }
}
