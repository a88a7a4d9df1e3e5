//! Light that takes all paths: radiances in closed form, and gradients of the same estimates.

use std::f64::consts::{FRAC_PI_2, PI};

use glam::{DVec3, dvec3};
use renderer::scene::{
    Environment, EnvironmentObject, Integrator, MaterialObject, PathTracing, Slot, Wrap,
};
use renderer::{
    Arithmetic, Camera, Edges, ImageLoss, LossKind, Material, Mesh, ParameterId, PixelLoss,
    PointLight, Renderer, Scene, Settings, SphereObject, Texture, render, render_jvp,
};

use crate::custom::kinds::Ellipsoid;
use crate::image::in_arithmetic;
use crate::scenes::set;
use crate::sky::sky_scene;
use crate::transparency::varied_scene;

pub fn paths(max_depth: u32, samples: u32) -> Integrator {
    Integrator::Path(PathTracing { max_depth, samples, seed: 3 })
}

pub fn emitting(emission: f64, albedo: f64) -> Material<f64> {
    let emission = DVec3::splat(emission);
    Material { emission, ..Material::lambertian(DVec3::splat(albedo)) }
}

/// A box from -1 to 1 whose sides wear material 0: left, right, floor, ceiling, back, front.
fn walls() -> Vec<Mesh> {
    let names = ["left", "right", "floor", "ceiling", "back", "front"];
    let side = |(index, name): (usize, &str)| {
        let (axis, at) = (index / 2, if index % 2 == 0 { -1.0 } else { 1.0 });
        let corner = |(u, v): (f64, f64)| {
            let mut corner = [at; 3];
            corner[(axis + 1) % 3] = u;
            corner[(axis + 2) % 3] = v;
            corner
        };
        let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(corner);
        Mesh::new(name, corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]])
    };
    names.into_iter().enumerate().map(side).collect()
}

pub fn mean(scene: &Scene, settings: &Settings) -> f64 {
    let image = render(scene, settings).unwrap();
    let values = image.pixels.as_flattened();
    values.iter().map(|&value| f64::from(value)).sum::<f64>() / values.len() as f64
}

#[track_caller]
pub fn assert_close(found: f64, expected: f64, relative: f64) {
    assert!((found - expected).abs() <= relative * expected.abs(), "{found}, expected {expected}");
}

/// In an enclosure that emits and reflects alike everywhere, the radiance is a geometric series, one term
/// for each piece of a path: in a box of triangles, and inside of a sphere.
#[test]
fn enclosures_have_the_radiance_of_the_series() {
    let camera = Camera::looking(dvec3(0.1, 0.2, 0.3), dvec3(0.3, 0.1, -1.0));
    let (emission, albedo) = (0.5, 0.7);
    let mut boxed = Scene::new(16, 16, camera);
    boxed.add_material("wall", emitting(emission, albedo)).unwrap();
    for wall in walls() {
        boxed.add_mesh(wall).unwrap();
    }
    let mut ball = Scene::new(16, 16, camera);
    ball.add_material("wall", emitting(emission, albedo)).unwrap();
    ball.add_sphere(SphereObject::new("ball", DVec3::ZERO, 1.5)).unwrap();
    for depth in [1, 2, 3, 6, 20] {
        let series: f64 = (0..depth).map(|k| emission * f64::powi(albedo, k)).sum();
        for scene in [&mut boxed, &mut ball] {
            scene.integrator = paths(depth as u32, 64);
            assert_close(mean(scene, &Settings::default()), series, 4e-3);
        }
    }
}

/// Under light from everywhere a convex body reflects as much as its albedo, without noise.
#[test]
fn a_white_ball_vanishes_in_a_white_furnace() {
    let camera = Camera::looking(dvec3(0.0, 0.0, 4.0), DVec3::ZERO);
    let mut scene = Scene::new(16, 16, camera);
    scene.add_material("white", Material::lambertian(DVec3::ONE)).unwrap();
    scene.add_sphere(SphereObject::new("ball", DVec3::ZERO, 1.0)).unwrap();
    scene.environment = Some(Environment::constant(DVec3::splat(2.5)).into());
    scene.integrator = paths(4, 4);
    let image = render(&scene, &Settings::default()).unwrap();
    for pixel in image.pixels {
        assert!(pixel.iter().all(|value| (value - 2.5).abs() < 1e-5), "{pixel:?}");
    }
}

/// A floor of albedo 0.6 at y = 0, one point of which fills the image.
pub fn floor_scene() -> Scene {
    let mut camera = Camera::looking(dvec3(0.3, 1.0, 0.2), DVec3::ZERO);
    camera.film_scale = 1e-3;
    let mut scene = Scene::new(8, 8, camera);
    scene.add_material("grey", Material::lambertian(DVec3::splat(0.6))).unwrap();
    let corners = [[-9.0, 0.0, 9.0], [9.0, 0.0, 9.0], [9.0, 0.0, -9.0], [-9.0, 0.0, -9.0]];
    let floor = Mesh::new("floor", corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]]);
    scene.add_mesh(floor).unwrap();
    scene.integrator = paths(2, 256);
    scene
}

/// A ball that shines, high above, low and large, and nearly a point.
#[test]
fn a_sphere_lights_a_plane_as_the_closed_form_says() {
    for (center, radius) in [
        (dvec3(0.0, 3.0, 0.0), 1.0),
        (dvec3(2.0, 3.5, -1.0), 2.0),
        (dvec3(4.0, 1.5, 1.0), 1.2),
        (dvec3(1.0, 4.0, 2.0), 1e-4),
    ] {
        let mut scene = floor_scene();
        let lamp = scene.add_material("lamp", emitting(7.0, 0.0)).unwrap();
        scene.add_sphere(SphereObject::new("lamp", center, radius).material(lamp)).unwrap();
        let distance = center.length();
        let irradiance = 7.0 * PI * (radius / distance).powi(2) * center.y / distance;
        assert_close(mean(&scene, &Settings::default()), irradiance * 0.6 / PI, 2e-3);
    }
}

/// A lamp that is half transparent lights half as much, by which its opacity has a gradient.
#[test]
fn what_is_transparent_lights_by_its_opacity() {
    let mut scene = floor_scene();
    scene.integrator = paths(2, 1024);
    let lamp = MaterialObject::from(emitting(7.0, 0.0)).with_opacity(0.5);
    let lamp = scene.add_material("lamp", lamp).unwrap();
    let corners = [[-4.0, 2.0, -4.0], [4.0, 2.0, -4.0], [4.0, 2.0, 4.0], [-4.0, 2.0, 4.0]];
    let lamp = Mesh::new("lamp", corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]]).material(lamp);
    scene.add_mesh(lamp).unwrap();
    // Four squares that each have the point below a corner.
    let side = 2.0 / 5.0_f64.sqrt();
    let lit = 7.0 * 0.6 * 4.0 * 2.0 * side * side.atan() / (2.0 * PI);
    assert_close(mean(&scene, &Settings::default()), 0.5 * lit, 1e-2);
    let id = scene.parameter("material.lamp.opacity").unwrap();
    let renderer = Renderer::new(&scene, &Settings::default()).unwrap();
    let by_opacity = renderer.loss_and_gradient(&scene, &Sum, &[id]).gradient.get(id)[0];
    assert_close(by_opacity, 192.0 * lit, 1e-2);
}

/// A rectangle above a corner of which the point lies, near and far, large and small.
#[test]
fn a_rectangle_lights_a_plane_as_the_closed_form_says() {
    for (width, length, height) in [(1.0, 2.0, 1.5), (6.0, 6.0, 2.0), (0.2, 0.1, 1.2)] {
        let mut scene = floor_scene();
        let lamp = scene.add_material("lamp", emitting(7.0, 0.0)).unwrap();
        let corners = [[0.0, 0.0], [width, 0.0], [width, length], [0.0, length]];
        let corners = corners.map(|[x, z]| [x, height, z]).to_vec();
        let lamp = Mesh::new("lamp", corners, vec![[0, 1, 2], [0, 2, 3]]).material(lamp);
        scene.add_mesh(lamp).unwrap();
        // The camera looks down past the lamp.
        scene.camera.look_from = dvec3(-0.3, 1.0, -0.2);
        let (x, y) = (width / height, length / height);
        let side = |x: f64, y: f64| x / x.hypot(1.0) * (y / x.hypot(1.0)).atan();
        let form_factor = (side(x, y) + side(y, x)) / (2.0 * PI);
        assert!(form_factor < FRAC_PI_2);
        assert_close(mean(&scene, &Settings::default()), 7.0 * form_factor * 0.6, 3e-3);
    }
}

/// Without emitters and with depth 2, paths bring what the direct integrator brings.
#[test]
fn direct_light_of_point_lights_is_the_same() {
    let mut scene = floor_scene();
    let light = PointLight {
        position: dvec3(1.0, 2.0, 0.5),
        color: dvec3(1.0, 0.5, 0.2),
        radiant_intensity: 4.0,
    };
    scene.add_light("key", light).unwrap();
    let direct = Scene { integrator: Integrator::Direct, ..scene.clone() };
    let settings = Settings::default();
    assert_close(mean(&scene, &settings), mean(&direct, &settings), 1e-5);
    scene.integrator = paths(1, 4);
    assert_eq!(mean(&scene, &settings), 0.0);
}

/// Light that is looked for behind a pane, by a mirror and beside emitters.
#[test]
fn looking_for_emitters_changes_nothing_but_noise() {
    looking_changes_nothing(lit_box(24), 5, [256, 1024], 5e-3);
}

/// Light that is found by choosing emitters and by scattering is that which scattering alone finds, of shapes of one's
/// own. All that shines is balls here, which are both.
pub fn looking_changes_nothing(
    mut scene: Scene,
    max_depth: u32,
    [few, many]: [u32; 2],
    tolerance: f64,
) {
    let material = |name| scene.materials.iter().position(|of| of.name == name).unwrap() as u32;
    let balls = [("lamp", dvec3(-0.1, 0.7, -0.2), 0.2), ("bulb", dvec3(0.6, -0.1, -0.6), 0.25)];
    let balls = balls.map(|(name, center, radius)| (name, center, radius, material(name)));
    let white = material("white");
    scene.meshes.iter_mut().find(|mesh| mesh.name == "panel").unwrap().materials.fill(white);
    scene.spheres.iter_mut().find(|sphere| sphere.name == "bulb").unwrap().material = white;
    let [mut looked_for, mut come_to] = [scene.clone(), scene];
    for (name, center, radius, material) in balls {
        let name = format!("{name} that shines");
        let ball = SphereObject::new(&name, center, radius).material(material);
        looked_for.add_sphere(ball).unwrap();
        let ball = Ellipsoid { center, radii: DVec3::splat(radius) };
        come_to.add_shape(&name, ball, material).unwrap();
    }
    looked_for.integrator = paths(max_depth, few);
    come_to.integrator = paths(max_depth, many);
    let [found, expected] =
        [looked_for, come_to].map(|scene| render(&scene, &Settings::default()).unwrap());
    for channel in 0..3 {
        let sum = |image: &renderer::Image| {
            image.pixels.iter().map(|pixel| f64::from(pixel[channel])).sum::<f64>()
        };
        assert_close(sum(&found), sum(&expected), tolerance);
    }
}

/// A box with coloured walls, a panel and a ball that shine, a mirror ball, a pane, a textured wall, and a
/// point light: each path of light goes somewhere.
pub fn lit_box(size: u32) -> Scene {
    let camera =
        Camera { vfov: 70.0, ..Camera::looking(dvec3(0.1, 0.1, 0.9), dvec3(0.0, -0.1, 0.0)) };
    let mut scene = Scene::new(size, size, camera);
    let texels: Vec<[f64; 3]> =
        vec![[0.9, 0.5, 0.3], [0.3, 0.8, 0.4], [0.2, 0.4, 0.7], [0.8, 0.6, 0.9]];
    let texels = texels.into();
    let tiles = Texture { name: "tiles".into(), width: 2, height: 2, wrap: Wrap::Repeat, texels };
    let tiles = scene.add_texture(tiles).unwrap();
    let colors = [dvec3(0.7, 0.2, 0.15), dvec3(0.2, 0.6, 0.25), DVec3::splat(0.75)];
    for (name, color) in ["red", "green", "white"].into_iter().zip(colors) {
        scene.add_material(name, Material::lambertian(color)).unwrap();
    }
    let paper = MaterialObject::from(Material::lambertian(DVec3::splat(0.9)));
    scene.add_material("paper", paper.with_texture(Slot::Diffuse, tiles)).unwrap();
    let lamp =
        Material { emission: dvec3(9.0, 8.0, 7.0), ..Material::lambertian(DVec3::splat(0.1)) };
    let lamp = scene.add_material("lamp", lamp).unwrap();
    let bulb =
        Material { emission: dvec3(2.0, 3.0, 5.0), ..Material::lambertian(DVec3::splat(0.3)) };
    let bulb = scene.add_material("bulb", bulb).unwrap();
    let chrome = Material {
        mirror: dvec3(0.7, 0.6, 0.5),
        specular: DVec3::splat(0.2),
        exponent: 6.0,
        ..Material::lambertian(DVec3::splat(0.2))
    };
    let chrome = scene.add_material("chrome", chrome).unwrap();
    let pane = MaterialObject::from(Material {
        roughness: 0.4,
        ..Material::lambertian(DVec3::splat(0.4))
    });
    let pane = scene.add_material("pane", pane.with_opacity(0.3)).unwrap();
    let uvs = vec![[0.1, 0.2], [1.3, 0.1], [1.2, 1.4], [-0.1, 0.9]];
    for (wall, material) in walls().into_iter().zip([0, 1, 2, 2, 3, 2]) {
        let wall = match material {
            3 => wall.clone().texture_coordinates(uvs.clone(), wall.triangles.clone()),
            _ => wall,
        };
        scene.add_mesh(wall.material(material)).unwrap();
    }
    let corners = [[-0.4, 0.98, -0.5], [0.2, 0.95, -0.5], [0.3, 0.97, 0.1], [-0.3, 0.96, 0.2]];
    let panel = Mesh::new("panel", corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]]);
    scene.add_mesh(panel.material(lamp)).unwrap();
    let corners = [[0.1, -0.9, 0.1], [0.8, -0.9, 0.3], [0.7, 0.3, 0.2], [0.0, 0.2, 0.0]];
    let glass = Mesh::new("glass", corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]]).smooth();
    scene.add_mesh(glass.material(pane)).unwrap();
    let ball = |name, center, radius| SphereObject::new(name, center, radius);
    scene.add_sphere(ball("bulb", dvec3(0.6, -0.4, -0.6), 0.15).material(bulb)).unwrap();
    scene.add_sphere(ball("chrome", dvec3(-0.5, -0.7, -0.3), 0.3).material(chrome)).unwrap();
    let light = PointLight {
        position: dvec3(-0.3, 0.5, 0.6),
        color: dvec3(1.0, 0.9, 0.8),
        radiant_intensity: 0.4,
    };
    scene.add_light("key", light).unwrap();
    scene.integrator = paths(6, 16);
    scene
}

/// The parameters that move no path.
pub fn still(scene: &Scene) -> Vec<ParameterId> {
    scene.parameters().into_iter().filter(|&id| !scene.moves_edges(id)).collect()
}

/// The gradient by every number of every parameter that moves no path, beside central differences in double precision with
/// the same random numbers.
pub fn agrees_with_differences(scene: &Scene) {
    let settings = in_arithmetic(Arithmetic::F64x8);
    let mut target = render(scene, &settings).unwrap();
    for (index, value) in target.pixels.as_flattened_mut().iter_mut().enumerate() {
        *value *= 0.6 + 0.1 * (index % 7) as f32;
    }
    let loss = ImageLoss::new(LossKind::MeanSquared, &target, false);
    // What weighs nothing has paths of its own.
    let mut ids = still(scene);
    ids.retain(|&id| scene.get(id).iter().any(|&number| number != 0.0));
    let renderer = Renderer::new(scene, &settings).unwrap();
    let gradient = renderer.loss_and_gradient(scene, &loss, &ids).gradient;
    let at = |id: ParameterId, element: usize, value: f64| {
        let mut moved = scene.clone();
        let mut numbers = moved.get(id).into_owned();
        numbers[element] = value;
        moved.assign(id, &numbers);
        Renderer::new(&moved, &settings).unwrap().loss(&loss)
    };
    let mut off = Vec::new();
    for &id in &ids {
        let numbers = scene.get(id).into_owned();
        let norm = gradient.get(id).iter().map(|slope| slope * slope).sum::<f64>().sqrt();
        for (element, (&value, &slope)) in numbers.iter().zip(gradient.get(id)).enumerate() {
            // Ends of ranges.
            if value == 0.0 || value == 1.0 {
                continue;
            }
            // Small, so that no path comes to end elsewhere: that is decided in steps.
            let step = 1e-7 * value.abs().max(1e-2);
            let found =
                (at(id, element, value + step) - at(id, element, value - step)) / (2.0 * step);
            let error = (found - slope).abs();
            let path = scene.path(id);
            if error.is_nan() || error > 1e-6 * norm + 1e-9 {
                off.push(format!("{path} {element}: {slope}, by differences {found}"));
            }
        }
    }
    assert!(off.is_empty(), "{off:#?}");
}

#[test]
fn gradients_in_a_lit_box_agree_with_differences() {
    agrees_with_differences(&lit_box(8));
}

/// The same under an environment, with textures of all kinds, panes, mirrors and lights of one's own.
#[test]
fn gradients_of_everything_agree_with_differences() {
    agrees_with_differences(&open_scene(12));
}

fn open_scene(size: u32) -> Scene {
    let mut scene = varied_scene(size);
    scene.environment = Some(Environment::constant(dvec3(0.3, 0.5, 0.7)).into());
    scene.integrator = paths(5, 8);
    set(&mut scene, "sphere.ball.rotation", &[20.0, -35.0, 50.0]);
    scene
}

/// Gradients by what is zero: albedos that reflect nothing, emitters that are dark.
#[test]
fn gradients_by_zeros_agree_with_differences_in_the_mean() {
    let mut scene = lit_box(8);
    scene.integrator = paths(4, 2048);
    set(&mut scene, "material.red.diffuse", &[0.0; 3]);
    set(&mut scene, "material.bulb.emission", &[0.0; 3]);
    let settings = in_arithmetic(Arithmetic::F64x8);
    let ids = ["material.red.diffuse", "material.bulb.emission"];
    let ids = ids.map(|path| scene.parameter(path).unwrap());
    let gradient =
        Renderer::new(&scene, &settings).unwrap().loss_and_gradient(&scene, &Sum, &ids).gradient;
    for (id, step, bound) in [(ids[0], 1e-3, 1e-3), (ids[1], 1.0, 0.05)] {
        let mut moved = scene.clone();
        let at = |moved: &Scene| Renderer::new(moved, &settings).unwrap().loss(&Sum);
        let dark = at(&moved);
        moved.assign(id, &[step; 3]);
        let slope = gradient.get(id).iter().sum::<f64>();
        assert_close((at(&moved) - dark) / step, slope, bound);
    }
}

/// The sum of all channels.
pub struct Sum;

impl PixelLoss for Sum {
    fn evaluate(&self, _: u32, _: u32, radiance: DVec3) -> (f64, DVec3) {
        (radiance.element_sum(), DVec3::ONE)
    }
}

/// The mean squared loss has the same derivative forwards.
#[test]
fn derivatives_forwards_and_backwards_are_transposed() {
    for scene in [lit_box(16), open_scene(17), sky_scene(12)] {
        let settings = in_arithmetic(Arithmetic::F64x8);
        let ids = scene.parameters();
        let direction: Vec<(ParameterId, Vec<f64>)> = ids
            .iter()
            .enumerate()
            .map(|(seed, &id)| {
                let count = scene.get(id).len();
                (id, (0..count).map(|i| ((seed * 31 + i * 7) % 11) as f64 - 5.0).collect())
            })
            .collect();
        let (_, derivative) = render_jvp(&scene, &settings, &direction).unwrap();
        let forwards: f64 =
            derivative.pixels.as_flattened().iter().map(|&value| f64::from(value)).sum();
        let renderer = Renderer::new(&scene, &settings).unwrap();
        let gradient = renderer.loss_and_gradient(&scene, &Sum, &ids).gradient;
        let along = direction.iter().flat_map(|(_, along)| along);
        let products = gradient.concat().into_iter().zip(along).map(|(slope, along)| slope * along);
        let (backwards, size) =
            products.fold((0.0, 0.0), |(sum, size), x: f64| (sum + x, size + x.abs()));
        assert!((forwards - backwards).abs() <= 1e-6 * size, "{forwards} and {backwards}");
    }
}

#[test]
fn lanes_and_precisions_agree() {
    let mut boxed = lit_box(24);
    boxed.integrator = paths(4, 16);
    for scene in [boxed, sky_scene(20)] {
        agree_in_all_arithmetics(&scene);
    }
}

fn agree_in_all_arithmetics(scene: &Scene) {
    let of = |arithmetic: Arithmetic| {
        let renderer = Renderer::new(scene, &in_arithmetic(arithmetic)).unwrap();
        let result = renderer.loss_and_gradient(scene, &Sum, &still(scene));
        (result.loss, result.gradient)
    };
    let (loss, gradient) = of(Arithmetic::F64);
    for (arithmetic, bound) in
        [(Arithmetic::F64x8, 1e-9), (Arithmetic::F32x16, 2e-3), (Arithmetic::F32, 2e-3)]
    {
        let (other_loss, other) = of(arithmetic);
        assert_close(other_loss, loss, bound);
        for (id, block) in gradient.iter() {
            let norm =
                |block: &mut dyn Iterator<Item = f64>| block.map(|x| x * x).sum::<f64>().sqrt();
            let size = norm(&mut block.iter().copied());
            let error = norm(&mut block.iter().zip(other.get(id)).map(|(a, b)| a - b));
            let path = scene.path(id);
            assert!(error <= 10.0 * bound * size, "{arithmetic:?} {path}: {error:e} of {size:e}");
        }
    }
}

#[test]
fn images_and_gradients_are_bit_identical_on_any_number_of_threads() {
    for scene in [lit_box(70), sky_scene(70)] {
        let run = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| {
                let renderer = Renderer::new(&scene, &Settings::default()).unwrap();
                let ids = still(&scene);
                (renderer.render(), renderer.loss_and_gradient(&scene, &Sum, &ids))
            })
        };
        let one = run(1);
        assert_eq!(one, run(2));
        assert_eq!(one, run(5));
    }
}

/// Emitters of any strength, in light that grazes the wall they stand on.
#[test]
fn extreme_emitters_are_exact_multiples_of_ordinary_ones() {
    let mut scene = lit_box(16);
    scene.lights.clear();
    let (lamp, bulb) = ("material.lamp.emission", "material.bulb.emission");
    let settings = Settings { edges: Edges::Off, ..Settings::default() };
    let of = |scene: &mut Scene, factor: f64| {
        set(scene, lamp, &[2.0 * factor; 3]);
        set(scene, bulb, &[5.0 * factor; 3]);
        let ids =
            [scene.parameter("material.red.diffuse").unwrap(), scene.parameter(lamp).unwrap()];
        let renderer = Renderer::new(scene, &settings).unwrap();
        let result = renderer.loss_and_gradient(scene, &Sum, &ids);
        let [albedo, emission] = ids.map(|id| result.gradient.get(id).iter().sum::<f64>());
        [result.loss / factor, albedo / factor, emission]
    };
    let ordinary = of(&mut scene, 1.0);
    assert!(ordinary.iter().all(|value| *value > 0.0), "{ordinary:?}");
    for factor in [f64::powi(2.0, -66), f64::powi(2.0, 66)] {
        for (found, expected) in of(&mut scene, factor).into_iter().zip(ordinary) {
            assert_close(found, expected, 1e-5);
        }
    }
}

#[test]
fn backgrounds_are_refused_in_direct_light() {
    let mut sky = Scene { integrator: Integrator::Direct, ..lit_box(8) };
    let sun = EnvironmentObject::from(Environment::constant(DVec3::ONE));
    sky.environment = Some(EnvironmentObject { background: Some(DVec3::ONE), ..sun });
    let error = render(&sky, &Settings::default()).unwrap_err().to_string();
    assert!(error.starts_with("environment.background: "), "{error}");
}
