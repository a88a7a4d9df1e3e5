//! Gradients with edges: against differences of finely sampled images, and of the coverage image.

use renderer::glam::DVec3;
use renderer::scene::{MaterialObject, Slot, Wrap};
use renderer::{
    Camera, DistantLight, Edges, Image, Material, Mesh, Pass, PixelLoss, PointLight, Renderer,
    Sampling, Scene, Settings, SphereObject, Texture, render, render_jvp, render_vjp,
};

use crate::curved_edges::add_facets;
use crate::differences::{self, relative_error};

const WIDTH: u32 = 48;
const HEIGHT: u32 = 40;

/// A loss that is linear in the image, with weights that vary slowly over it.
struct Weights;

impl PixelLoss for Weights {
    fn evaluate(&self, x: u32, y: u32, radiance: DVec3) -> (f64, DVec3) {
        let (x, y) = (f64::from(x), f64::from(y));
        let weight = 1.0 + (0.21 * x + 0.4).sin() + (0.17 * y + 0.1 * x).cos();
        let weights = DVec3::new(1.0, 0.5, 0.7) * weight;
        (weights.dot(radiance), weights)
    }
}

pub fn settings(edges: Edges, side: u32) -> Settings {
    let settings = Settings { edges, sampling: Sampling::Grid(side), ..Settings::default() };
    settings.in_double_precision()
}

pub fn scene() -> Scene {
    let (from, at) = (DVec3::new(0.3, 1.6, 4.0), DVec3::new(0.05, 0.35, 0.0));
    Scene::new(WIDTH, HEIGHT, Camera::looking(from, at))
}

pub fn paint(scene: &mut Scene, name: &str, albedo: [f64; 3], mirror: f64) -> u32 {
    let material = Material { mirror: DVec3::splat(mirror), ..Material::lambertian(albedo.into()) };
    scene.add_material(name, material).unwrap()
}

pub fn add_floor(scene: &mut Scene, mirror: f64) {
    let paint = paint(scene, "floor", [0.3, 0.7, 0.4], mirror);
    let corners = vec![[-6.0, 0.0, -6.0], [6.0, 0.0, -6.0], [6.0, 0.0, 6.0], [-6.0, 0.0, 6.0]];
    let floor = Mesh::new("floor", corners, vec![[0, 2, 1], [0, 3, 2]]).material(paint);
    scene.add_mesh(floor).unwrap();
}

pub fn add_triangle(scene: &mut Scene) {
    let paint = paint(scene, "triangle", [0.8, 0.3, 0.2], 0.0);
    let corners = vec![[-0.61, 0.33, 0.1], [0.73, 0.21, 0.3], [0.14, 1.17, -0.2]];
    scene.add_mesh(Mesh::new("shape", corners, vec![[0, 1, 2]]).material(paint)).unwrap();
}

/// Three faces, two of which meet in a ridge.
pub fn add_wedge(scene: &mut Scene) {
    let paint = paint(scene, "wedge", [0.8, 0.3, 0.2], 0.0);
    let corners = vec![
        [-0.8, 0.1, 0.0],
        [0.03, 0.1, 0.6],
        [0.05, 1.3, 0.55],
        [-0.8, 1.3, 0.0],
        [0.9, 0.1, -0.1],
        [0.9, 1.3, -0.1],
    ];
    let faces = vec![[0, 1, 2], [0, 2, 3], [1, 4, 5], [1, 5, 2]];
    scene.add_mesh(Mesh::new("shape", corners, faces).material(paint)).unwrap();
}

pub fn add_ball(scene: &mut Scene) {
    let paint = paint(scene, "ball", [0.8, 0.3, 0.2], 0.0);
    let ball = SphereObject::new("ball", DVec3::new(0.1, 0.7, 0.0), 0.55).material(paint);
    scene.add_sphere(ball).unwrap();
}

/// A ball with a texture of a few texels.
fn add_textured_ball(scene: &mut Scene) {
    let texel = |index: u32| [index * index, 3 * index, 5 * index].map(|x| f64::from(x % 7) / 7.0);
    let texels = (0..12).map(texel).collect::<Vec<[f64; 3]>>().into();
    let texture =
        Texture { name: "stripes".into(), width: 4, height: 3, wrap: Wrap::Repeat, texels };
    let stripes = scene.add_texture(texture).unwrap();
    let material = MaterialObject::from(Material::lambertian(DVec3::splat(0.9)));
    let paint = scene.add_material("stripes", material.with_texture(Slot::Diffuse, stripes));
    let ball = SphereObject::new("ball", DVec3::new(0.1, 0.7, 0.0), 0.55);
    scene.add_sphere(ball.material(paint.unwrap())).unwrap();
}

pub fn add_lamp(scene: &mut Scene) {
    let position = DVec3::new(1.1, 3.0, 2.0);
    let lamp = PointLight { position, color: DVec3::ONE, radiant_intensity: 12.0 };
    scene.add_light("lamp", lamp).unwrap();
}

pub fn add_sun(scene: &mut Scene) {
    let direction = DVec3::new(0.5, 1.0, 0.6);
    let sun = DistantLight { direction, color: DVec3::ONE, irradiance: 2.0 };
    scene.add_light("sun", sun).unwrap();
}

pub fn gradient(scene: &Scene, settings: &Settings, path: &str) -> Vec<f64> {
    differences::gradient(scene, settings, &Weights, path)
}

fn differences(scene: &Scene, settings: &Settings, path: &str, step: f64) -> Vec<f64> {
    differences::differences(scene, settings, &Weights, path, step)
}

/// The derivative of the weighted image along a direction of a parameter, in forward mode.
pub fn weighted_jvp(scene: &Scene, settings: &Settings, path: &str, direction: Vec<f64>) -> f64 {
    let id = scene.parameter(path).unwrap();
    let derivative = render_jvp(scene, settings, &[(id, direction)]).unwrap().1;
    let weighted = |(index, pixel): (usize, &[f32; 3])| {
        let (x, y) = (index as u32 % WIDTH, index as u32 / WIDTH);
        Weights.evaluate(x, y, DVec3::ZERO).1.dot(DVec3::from(pixel.map(f64::from)))
    };
    derivative.pixels.iter().enumerate().map(weighted).sum()
}

/// What moves neither edges nor points has the gradient of the image with edges at hand, exactly: a mirror, beside
/// materials that are none, textures that turn, and their coordinates on a smooth mesh.
#[test]
fn what_moves_no_edges_is_exact_with_edges() {
    let mut scene = scene();
    add_floor(&mut scene, 0.4);
    add_facets(&mut scene, true);
    add_textured_ball(&mut scene);
    add_lamp(&mut scene);
    let material = scene.spheres[0].material;
    let mut shape = scene.meshes.pop().unwrap();
    shape.vertices.iter_mut().for_each(|vertex| vertex[0] -= 1.1);
    let uvs = shape.vertices.iter().map(|[x, y, z]| [x + 0.3 * z, y - 0.2 * z]).collect();
    let shape = shape.clone().texture_coordinates(uvs, shape.triangles.clone());
    scene.add_mesh(shape.smooth().material(material)).unwrap();
    let paths = ["material.floor.mirror", "sphere.ball.rotation", "mesh.shape.texture_coordinates"];
    for path in paths {
        let settings = settings(Edges::On, 1);
        let expected = differences(&scene, &settings, path, 1e-5);
        let error = relative_error(&gradient(&scene, &settings, path), &expected);
        assert!(error < 1e-6, "{path}: {error:.1e}");
    }
}

/// The gradient is that of a finely sampled image, up to so much with so many rays side by side in a pixel; the interior
/// term alone is far from it.
#[track_caller]
pub fn check<const N: usize>(scene: &Scene, path: &str, bounds: [(u32, f64); N]) {
    check_pass(scene, Pass::Radiance, path, bounds);
}

#[track_caller]
fn check_pass<const N: usize>(scene: &Scene, pass: Pass, path: &str, bounds: [(u32, f64); N]) {
    let is_in_degrees = path.ends_with("vfov") || path.ends_with("rotation");
    let step = if is_in_degrees { 0.2 } else { 5e-3 };
    let settings = |edges, side| Settings { pass, ..settings(edges, side) };
    let expected = differences(scene, &settings(Edges::Off, 32), path, step);
    for (side, most) in bounds {
        let found = gradient(scene, &settings(Edges::On, side), path);
        let error = relative_error(&found, &expected);
        assert!(error < most, "{pass:?} {path}, {side}: {error:.1e}: {found:?} {expected:?}");
    }
}

#[test]
fn silhouettes_of_a_triangle() {
    let mut scene = scene();
    add_triangle(&mut scene);
    add_sun(&mut scene);
    for path in ["camera.look_at", "mesh.shape.vertices", "mesh.shape.translation"] {
        check(&scene, path, [(1, 1e-2)]);
    }
    let interior = gradient(&scene, &settings(Edges::Off, 1), "mesh.shape.translation");
    // A flat face under a distant light looks the same everywhere.
    assert!(interior.iter().all(|part| part.abs() < 1e-12), "{interior:?}");
}

/// A beam of four sides, `width` thick, from one border of the image to another: a pixel is 0.08 wide there.
fn add_rod(scene: &mut Scene, width: f64) {
    let paint = paint(scene, "rod", [0.8, 0.3, 0.2], 0.0);
    let (from, to) = (DVec3::new(-3.1, -0.6, 0.1), DVec3::new(3.3, 1.93, -0.1));
    let along = (to - from).normalize();
    let [up, out] = [DVec3::Y, DVec3::Z].map(|axis| width * 0.5 * axis.reject_from(along));
    let ends =
        [from, to].map(|end| [end + up + out, end + up - out, end - up - out, end - up + out]);
    let corners = ends.concat().into_iter().map(|corner| corner.to_array()).collect();
    let sides = (0..4).flat_map(|a| {
        let b = (a + 1) % 4;
        [[a, a + 4, b + 4], [a, b + 4, b]]
    });
    let caps = [[0, 1, 2], [0, 2, 3], [4, 6, 5], [4, 7, 6]];
    let faces = sides.chain(caps).collect();
    scene.add_mesh(Mesh::new("shape", corners, faces).material(paint)).unwrap();
}

/// Both borders of a rod nearly cancel, so that finite differences are noisy; finer grids see it.
#[test]
fn rods_thinner_than_a_pixel() {
    for width in [0.04, 0.012] {
        let mut scene = scene();
        add_rod(&mut scene, width);
        add_sun(&mut scene);
        for path in ["mesh.shape.translation", "camera.look_at"] {
            check(&scene, path, [(1, 0.2)]);
            let [coarse, fine] =
                [1, 16].map(|side| gradient(&scene, &settings(Edges::On, side), path));
            let error = relative_error(&coarse, &fine);
            assert!(error < 3e-2, "{path}: {error:.1e}: {coarse:?} {fine:?}");
        }
    }
}

/// The derivative image along a direction is that of finely sampled images, at one ray a pixel and at 4 x 4 to within
/// these relative errors.
#[track_caller]
pub fn check_pixels(scene: &Scene, path: &str, direction: &[f64], [one, sixteen]: [f64; 2]) {
    check_pixels_by(scene, path, direction, [(1, one), (4, sixteen)]);
}

/// The same with so many rays side by side in a pixel.
#[track_caller]
pub fn check_pixels_by<const N: usize>(
    scene: &Scene,
    path: &str,
    direction: &[f64],
    bounds: [(u32, f64); N],
) {
    let id = scene.parameter(path).unwrap();
    let image = |by: f64| {
        let mut moved = scene.clone();
        let mut place = scene.get(id).to_vec();
        place.iter_mut().zip(direction).for_each(|(at, along)| *at += by * along);
        moved.set(id, &place).unwrap();
        render(&moved, &settings(Edges::Off, 32)).unwrap()
    };
    let step = 5e-3;
    let [before, after] = [-step, step].map(image);
    let pixels = after.pixels.as_flattened().iter().zip(before.pixels.as_flattened());
    let expected: Vec<f64> =
        pixels.map(|(after, before)| f64::from(after - before) / (2.0 * step)).collect();
    for (side, most) in bounds {
        let moves = [(id, direction.to_vec())];
        let (_, derivative) = render_jvp(scene, &settings(Edges::On, side), &moves).unwrap();
        let found = derivative.pixels.as_flattened().iter().map(|&part| f64::from(part));
        let error = relative_error(&found.collect::<Vec<f64>>(), &expected);
        assert!(error < most, "{path}, {side}: {error}");
    }
}

/// Where nothing moves, derivatives are those of the image itself, at silhouettes of spheres and smooth meshes, too.
#[test]
fn what_moves_nothing_is_exact() {
    let mut scene = scene();
    add_facets(&mut scene, true);
    scene.meshes[0] = scene.meshes[0].clone().smooth();
    let ball = SphereObject::new("ball", DVec3::new(-0.7, 0.6, 0.4), 0.5);
    let paint = paint(&mut scene, "ball", [0.2, 0.6, 0.4], 0.0);
    scene.add_sphere(ball.material(paint)).unwrap();
    add_sun(&mut scene);
    let settings = settings(Edges::On, 1);
    for path in ["material.ball.diffuse", "material.facets.diffuse", "light.sun.irradiance"] {
        let expected = differences(&scene, &settings, path, 1e-3);
        let backwards = gradient(&scene, &settings, path);
        let error = relative_error(&backwards, &expected);
        assert!(error < 1e-6, "{path}: {error:.1e}");
        let along = vec![1.0; backwards.len()];
        let forwards = weighted_jvp(&scene, &settings, path, along);
        let sum: f64 = backwards.iter().sum();
        assert!((forwards - sum).abs() < 1e-5 * sum.abs(), "{path}: {forwards} {sum}");
    }
}

#[test]
fn shadows_on_a_floor() {
    let mut scene = scene();
    add_floor(&mut scene, 0.0);
    add_triangle(&mut scene);
    add_lamp(&mut scene);
    for path in ["light.lamp.position", "mesh.shape.translation", "camera.look_at"] {
        check(&scene, path, [(4, 4e-2)]);
    }
}

/// A material that is partly transparent.
pub fn veil(scene: &mut Scene) -> u32 {
    let veil = MaterialObject::from(Material::lambertian(DVec3::new(0.2, 0.5, 0.6)));
    scene.add_material("veil", veil.with_opacity(0.6)).unwrap()
}

/// Light comes through one surface, through another, through both, and through front and back of a ball; a part of
/// it is in the shadow of what is opaque.
fn add_transparent(scene: &mut Scene) {
    let veil = veil(scene);
    let corners = vec![
        [-0.61, 1.33, 0.1],
        [0.73, 1.21, 0.3],
        [0.14, 1.5, -0.7],
        [0.3, 1.9, 0.4],
        [1.1, 1.8, 0.5],
        [0.8, 1.9, -0.6],
    ];
    let panes = Mesh::new("panes", corners, vec![[0, 1, 2], [3, 4, 5]]).material(veil);
    scene.add_mesh(panes).unwrap();
    let ball = SphereObject::new("glass", DVec3::new(-0.9, 0.7, -0.2), 0.4).material(veil);
    scene.add_sphere(ball).unwrap();
}

#[test]
fn shadows_of_transparent_surfaces() {
    let mut scene = scene();
    add_floor(&mut scene, 0.0);
    add_transparent(&mut scene);
    add_triangle(&mut scene);
    add_lamp(&mut scene);
    add_sun(&mut scene);
    for path in ["light.lamp.position", "light.sun.direction"] {
        check(&scene, path, [(4, 1e-2)]);
    }
    for path in ["mesh.panes.translation", "sphere.glass.center"] {
        check(&scene, path, [(4, 0.1)]);
    }
}

/// A light in two halves casts two shadows in one place; each has its own half of the edge.
#[test]
fn edges_of_two_lights_in_one_place() {
    let [whole, halves] = [1, 2].map(|parts| {
        let mut scene = scene();
        add_floor(&mut scene, 0.0);
        add_transparent(&mut scene);
        for part in 0..parts {
            let position = DVec3::new(1.1, 3.0, 2.0);
            let radiant_intensity = 12.0 / f64::from(parts);
            let lamp = PointLight { position, color: DVec3::ONE, radiant_intensity };
            scene.add_light(format!("lamp {part}"), lamp).unwrap();
        }
        gradient(&scene, &settings(Edges::On, 1), "mesh.panes.translation")
    });
    let error = relative_error(&halves, &whole);
    assert!(error < 1e-9, "{error:.1e}: {halves:?} {whole:?}");
}

/// The shadow of a light at the camera ends next to what casts it.
#[test]
fn transparent_surfaces_before_a_light_at_the_camera() {
    let mut scene = scene();
    add_floor(&mut scene, 0.0);
    let veil = veil(&mut scene);
    let corners = vec![[-0.6, 0.5, 0.1], [0.6, 0.4, -0.1], [0.4, 1.1, -1.0]];
    scene.add_mesh(Mesh::new("pane", corners, vec![[0, 1, 2]]).material(veil)).unwrap();
    let position = scene.camera.look_from;
    let lamp = PointLight { position, color: DVec3::ONE, radiant_intensity: 30.0 };
    scene.add_light("lamp", lamp).unwrap();
    check(&scene, "mesh.pane.translation", [1, 2, 4].map(|side| (side, 2e-2)));
}

/// What transparent surfaces leave of a light ends where they pierce what it falls on.
#[test]
fn transparent_surfaces_pierce_others() {
    let mut scene = scene();
    add_triangle(&mut scene);
    let veil = veil(&mut scene);
    let corners = vec![[0.1, 0.6, 0.4], [0.9, 0.5, 0.5], [0.6, 0.7, -0.6]];
    scene.add_mesh(Mesh::new("pane", corners, vec![[0, 1, 2]]).material(veil)).unwrap();
    add_sun(&mut scene);
    for path in ["mesh.pane.translation", "light.sun.direction"] {
        check(&scene, path, [(4, 3e-2)]);
    }
}

#[test]
fn ridges() {
    let mut scene = scene();
    add_wedge(&mut scene);
    add_lamp(&mut scene);
    for path in ["mesh.shape.vertices", "camera.look_from", "camera.vfov"] {
        check(&scene, path, [(4, 2e-2)]);
    }
}

/// Two ridges between three facets meet behind a bar, in whose cells they end.
#[test]
fn ridges_that_end_behind_an_edge() {
    let mut scene = scene();
    let facets = paint(&mut scene, "facets", [0.8, 0.3, 0.2], 0.0);
    let corners = vec![
        [0.05, 0.6, 0.5],
        [-0.07, -1.0, 0.2],
        [0.1, -1.0, 0.6],
        [-2.0, 0.3, -1.5],
        [2.0, 0.2, 1.5],
        [0.0, 2.0, 0.4],
    ];
    let faces = vec![[0, 1, 2], [0, 3, 1], [0, 2, 4], [0, 5, 3], [0, 4, 5]];
    scene.add_mesh(Mesh::new("shape", corners, faces).material(facets)).unwrap();
    let bar = paint(&mut scene, "bar", [0.2, 0.2, 0.7], 0.0);
    let corners = vec![[-1.0, 0.5, 1.2], [1.0, 0.52, 1.2], [1.0, 0.9, 1.2], [-1.0, 0.9, 1.2]];
    let faces = vec![[0, 1, 2], [0, 2, 3]];
    scene.add_mesh(Mesh::new("bar", corners, faces).material(bar)).unwrap();
    add_sun(&mut scene);
    for shift in 0..12 {
        let id = scene.parameter("mesh.shape.translation").unwrap();
        scene.set(id, &[0.01 * f64::from(shift), 0.0, 0.0]).unwrap();
        check_pixels(&scene, "mesh.shape.translation", &[1.0, 0.0, 0.0], [0.16, 0.13]);
    }
}

/// Edges of what passes show: silhouettes before each other and before nothing, and ridges.
#[test]
fn edges_of_depth_places_and_normals() {
    let mut scene = scene();
    add_wedge(&mut scene);
    add_ball(&mut scene);
    for pass in [Pass::Depth, Pass::Position, Pass::Normals] {
        check_pass(&scene, pass, "mesh.shape.vertices", [(4, 0.02)]);
        for path in ["camera.look_from", "sphere.ball.center"] {
            check_pass(&scene, pass, path, [(4, 0.1)]);
        }
    }
    for pass in [Pass::Depth, Pass::Position, Pass::Normals] {
        let settings = Settings { pass, ..settings(Edges::On, 1) };
        let id = scene.parameter("camera.look_at").unwrap();
        let along = vec![0.3, -0.4, 0.2];
        let forward = Renderer::new(&scene, &settings).unwrap();
        let (_, forward) = forward.loss_jvp(&scene, &Weights, &[(id, along.clone())]).unwrap();
        let reverse = gradient(&scene, &settings, "camera.look_at");
        let reverse: f64 = reverse.iter().zip(&along).map(|(a, b)| a * b).sum();
        assert!((reverse - forward).abs() < 1e-6 * reverse.abs(), "{reverse} {forward}");
    }
}

/// Two triangles that pierce each other.
#[test]
fn curves_in_which_surfaces_pierce_each_other() {
    let mut scene = scene();
    add_triangle(&mut scene);
    let paint = paint(&mut scene, "other", [0.3, 0.7, 0.4], 0.0);
    let corners = vec![[-0.9, 0.3, 0.9], [0.9, 0.45, 0.9], [0.0, 1.1, -0.9]];
    scene.add_mesh(Mesh::new("other", corners, vec![[0, 1, 2]]).material(paint)).unwrap();
    add_sun(&mut scene);
    for path in ["mesh.other.translation", "mesh.shape.translation"] {
        check(&scene, path, [(4, 3e-2)]);
    }
}

/// A square that faces the camera and moves in its plane: nothing turns, so the coverage image changes
/// exactly as its gradient says.
#[test]
fn the_coverage_image_agrees_with_its_gradient() {
    let mut scene = Scene::new(24, 20, Camera::looking(DVec3::Z * 4.0, DVec3::ZERO));
    let glow = Material { emission: DVec3::ONE, ..Material::lambertian(DVec3::ZERO) };
    let glow = scene.add_material("glow", glow).unwrap();
    let corners =
        vec![[-0.71, -0.52, 0.0], [0.83, -0.61, 0.0], [0.64, 0.57, 0.0], [-0.55, 0.69, 0.0]];
    let square = Mesh::new("square", corners, vec![[0, 1, 2], [0, 2, 3]]).material(glow);
    scene.add_mesh(square).unwrap();
    for side in [1, 2, 3] {
        let settings = settings(Edges::On, side);
        let found = gradient(&scene, &settings, "mesh.square.translation");
        let expected = differences(&scene, &settings, "mesh.square.translation", 1e-6);
        let error = relative_error(&found[..2], &expected[..2]);
        assert!(error < 1e-8, "{side}: {error:.1e}: {found:?} {expected:?}");
    }
}

/// Edges through the middles of samples and along the borders of pixels count once.
#[test]
fn areas_are_exact_wherever_edges_lie() {
    for offset in [0.0, 0.25, 0.5, 0.75] {
        // One scene unit is one pixel, seen from far away.
        let mut camera = Camera::looking(DVec3::Z * 1e4, DVec3::ZERO);
        camera.vfov = 2.0 * (8.0_f64 / 1e4).atan().to_degrees();
        let mut scene = Scene::new(16, 16, camera);
        let glow = Material { emission: DVec3::ONE, ..Material::lambertian(DVec3::ZERO) };
        let glow = scene.add_material("glow", glow).unwrap();
        let [left, right] = [-4.0 + offset, 3.0 + offset];
        let corners =
            vec![[left, -3.0, 0.0], [right, -3.0, 0.0], [right, 2.0, 0.0], [left, 2.0, 0.0]];
        let square = Mesh::new("square", corners, vec![[0, 1, 2], [0, 2, 3]]).material(glow);
        scene.add_mesh(square).unwrap();
        let image = render(&scene, &settings(Edges::On, 1)).unwrap();
        let area: f64 = image.pixels.iter().map(|pixel| f64::from(pixel[0])).sum();
        assert!((area - 35.0).abs() < 1e-3, "{offset}: {area}");
    }
}

/// Everything together moves nothing.
#[test]
fn moving_the_scene_with_its_camera_changes_nothing() {
    let mut scene = scene();
    add_floor(&mut scene, 0.0);
    add_wedge(&mut scene);
    add_lamp(&mut scene);
    let paths = [
        "camera.look_from",
        "camera.look_at",
        "light.lamp.position",
        "mesh.shape.translation",
        "mesh.floor.translation",
    ];
    let settings = settings(Edges::On, 1);
    let blocks: Vec<Vec<f64>> = paths.map(|path| gradient(&scene, &settings, path)).into();
    for axis in 0..3 {
        let parts = blocks.iter().map(|block| block[axis]);
        let (sum, size) =
            parts.fold((0.0, 0.0_f64), |(sum, size), x: f64| (sum + x, size.max(x.abs())));
        assert!(sum.abs() < 1e-9 * size, "{sum:e} of {size:e}");
    }
}

#[test]
fn forward_and_reverse_mode_agree() {
    let mut scene = scene();
    add_floor(&mut scene, 0.4);
    add_wedge(&mut scene);
    add_transparent(&mut scene);
    scene.spheres.clear();
    add_lamp(&mut scene);
    let paths = ["camera.look_from", "mesh.shape.vertices", "light.lamp.position"];
    modes_agree(&scene, &paths);
}

/// With the limb of spheres, and of a texture that turns with one.
#[test]
fn forward_and_reverse_mode_agree_on_spheres() {
    let mut scene = scene();
    add_floor(&mut scene, 0.0);
    add_textured_ball(&mut scene);
    add_lamp(&mut scene);
    let of_ball = ["center", "radius", "rotation"].map(|field| format!("sphere.ball.{field}"));
    let [center, radius, rotation] = of_ball.each_ref().map(String::as_str);
    modes_agree(&scene, &["camera.look_from", center, radius, rotation, "light.lamp.position"]);
}

#[track_caller]
fn modes_agree(scene: &Scene, paths: &[&str]) {
    for path in paths {
        let id = scene.parameter(path).unwrap();
        let direction: Vec<f64> =
            (0..scene.get(id).len()).map(|index| (1.7 * index as f64).sin() + 0.2).collect();
        let settings = settings(Edges::Auto, 1);
        let (image, pullback) = render_vjp(scene, &settings, &[id]).unwrap();
        let (same, along) = render_jvp(scene, &settings, &[(id, direction.clone())]).unwrap();
        let mut pixels = image.pixels.as_flattened().iter().zip(same.pixels.as_flattened().iter());
        let differing = pixels.find(|(a, b)| (*a - *b).abs() > 1e-6);
        assert_eq!(differing, None, "{path}");
        let weights = |x: u32, y: u32| Weights.evaluate(x, y, DVec3::ZERO).1.as_vec3().to_array();
        let pixels = (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| weights(x, y))).collect();
        let cotangent = Image { width: WIDTH, height: HEIGHT, pixels };
        let gradient = pullback(&cotangent).concat();
        let reverse: f64 = gradient.iter().zip(&direction).map(|(a, b)| a * b).sum();
        let products = along.pixels.as_flattened().iter().zip(cotangent.pixels.as_flattened());
        let forward: f64 = products.map(|(a, b)| f64::from(*a) * f64::from(*b)).sum();
        assert!((reverse - forward).abs() < 1e-5 * reverse.abs(), "{path}: {reverse} {forward}");
    }
}

#[test]
fn edges_are_the_same_in_single_precision_and_on_any_number_of_threads() {
    let mut scene = scene();
    add_floor(&mut scene, 0.3);
    add_wedge(&mut scene);
    add_ball(&mut scene);
    add_lamp(&mut scene);
    let single = Settings { edges: Edges::On, ..Settings::default() };
    for path in ["camera.look_at", "mesh.shape.vertices", "sphere.ball.center"] {
        let on_threads = |threads: usize, settings: &Settings| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| gradient(&scene, settings, path))
        };
        let [one, three] = [1, 3].map(|threads| on_threads(threads, &single));
        assert_eq!(one, three);
        let error = relative_error(&one, &gradient(&scene, &single.in_double_precision(), path));
        assert!(error < 1e-3, "{path}: {error:.1e}");
    }
}

/// Parameters that move no edge have the gradient that they have without edges.
#[test]
fn who_moves_no_edge_pays_nothing() {
    let mut scene = scene();
    add_floor(&mut scene, 0.0);
    add_triangle(&mut scene);
    add_lamp(&mut scene);
    for path in ["light.lamp.radiant_intensity", "material.triangle.diffuse"] {
        let [auto, off] = [Edges::Auto, Edges::Off]
            .map(|edges| gradient(&scene, &Settings { edges, ..Settings::default() }, path));
        assert_eq!(auto, off);
    }
}
