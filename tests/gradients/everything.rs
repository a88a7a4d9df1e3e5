//! A scene that has everything: mirrors, textures of every kind, transparent surfaces, meshes that are
//! placed in the world, flat and smooth ones, spheres, shapes and lights of known kinds and custom ones.

use glam::{DVec3, Vec3, dvec3};
use renderer::transport::transform::unplace;
use renderer::{
    Arithmetic, Image, Material, ParameterId, PixelLoss, Renderer, Scene, SpotLight, Transform,
    render_jvp, render_vjp,
};

use crate::custom::{add_egg, add_spotlight};
use crate::image::{agrees_with_finite_differences, in_arithmetic, lanes_agree_on};
use crate::scenes::{Parts, set};
use crate::transparency::varied_parts;

/// The same scene, but for rounding, of meshes that their transforms bring to where they were.
pub fn place_meshes(mut parts: Parts) -> Parts {
    for (mesh, side) in parts.meshes.iter_mut().zip([1.0, -1.0, 0.5]) {
        mesh.transform = Transform {
            translation: dvec3(0.3, -0.2, 0.1) * side,
            rotation: dvec3(10.0, -25.0, 15.0) * side,
            scale: dvec3(1.2, 0.8, 1.5),
        };
        for vertex in &mut mesh.vertices {
            *vertex = unplace::<f64>(mesh.transform, (*vertex).into()).into();
        }
    }
    parts
}

/// The same scene with normals on the floor, and smooth normals on the tent.
pub fn smooth_meshes(mut parts: Parts) -> Parts {
    let normals = vec![[-0.2, 1.0, 0.1], [0.3, 2.0, 0.2], [0.1, 0.7, -0.2], [-0.1, -0.9, 0.1]];
    parts.meshes[0] = parts.meshes[0].clone().normals(normals, vec![[0, 1, 2], [3, 2, 0]]);
    parts.meshes[1] = parts.meshes[1].clone().smooth();
    parts
}

fn scene(size: u32) -> Scene {
    let mut scene = place_meshes(smooth_meshes(varied_parts(size))).scene();
    set(&mut scene, "sphere.ball.rotation", &[20.0, -35.0, 50.0]);
    for (path, roughness) in [("material.ground.roughness", 0.4), ("material.pane.roughness", 0.8)]
    {
        set(&mut scene, path, &[roughness]);
    }
    let cone = SpotLight {
        position: dvec3(1.5, 5.0, 4.0),
        direction: dvec3(-0.2, -1.1, -0.8),
        color: dvec3(0.9, 0.7, 0.5),
        radiant_intensity: 40.0,
        inner_angle: 5.0,
        outer_angle: 35.0,
    };
    scene.add_light("cone", cone).unwrap();
    let shell = Material { mirror: dvec3(0.3, 0.5, 0.4), ..scene.materials()[1].values };
    let shell = scene.add_material("shell", Material { opacity: 1.0, ..shell }).unwrap();
    add_egg(&mut scene, shell);
    add_spotlight(&mut scene);
    scene
}

#[test]
fn every_parameter_agrees_with_finite_differences() {
    let scene = scene(16);
    for id in scene.parameters() {
        agrees_with_finite_differences(&scene, id);
    }
}

#[test]
fn lanes_agree_with_single_numbers() {
    lanes_agree_on(&scene(37));
}

/// Numbers between -1 and 1 that look random.
fn noise(seed: usize, index: usize) -> f64 {
    (((seed * 7919 + index + 1) as f64 * 12.9898).sin() * 43_758.545_3).fract()
}

/// Every parameter moves, each by a part of its natural scale.
fn direction(scene: &Scene) -> Vec<(ParameterId, Vec<f64>)> {
    let block = |(seed, id): (usize, ParameterId)| {
        let scale = scene.natural_scale(id);
        let count = scene.get(id).len();
        (id, (0..count).map(|index| scale * noise(seed, index)).collect())
    };
    scene.parameters().into_iter().enumerate().map(block).collect()
}

fn cotangent(scene: &Scene) -> Image {
    let mut image = Image::black(scene.width, scene.height);
    for (index, channel) in image.pixels.as_flattened_mut().iter_mut().enumerate() {
        *channel = noise(997, index) as f32;
    }
    image
}

/// The linear loss whose cotangents are those of an image.
struct Linear<'a>(&'a Image);

impl PixelLoss for Linear<'_> {
    fn evaluate(&self, x: u32, y: u32, radiance: DVec3) -> (f64, DVec3) {
        let cotangent = self.0.pixels[(y * self.0.width + x) as usize];
        let cotangent = Vec3::from(cotangent).as_dvec3();
        (radiance.dot(cotangent), cotangent)
    }
}

/// The sum of the products, and that of their sizes.
fn dot(products: impl Iterator<Item = f64>) -> (f64, f64) {
    products.fold((0.0, 0.0), |(sum, size), product| (sum + product, size + product.abs()))
}

/// `<c, J v>` forwards is `<Jᵀ c, v>` backwards, edges and all, whatever scalar both compute in and
/// however many rays there are.
#[test]
fn forwards_and_backwards_are_transposed() {
    let scene = scene(37);
    let (direction, cotangent) = (direction(&scene), cotangent(&scene));
    let ids = scene.parameters();
    for (arithmetic, bound) in [
        (Arithmetic::F64, 1e-10),
        (Arithmetic::F64x8, 1e-10),
        (Arithmetic::F32, 1e-4),
        (Arithmetic::F32x16, 1e-4),
    ] {
        let renderer = Renderer::new(&scene, &in_arithmetic(arithmetic)).unwrap();
        let (_, forwards) = renderer.loss_jvp(&scene, &Linear(&cotangent), &direction).unwrap();
        let gradient = renderer.pullback(&scene, &cotangent, &ids);
        let products = direction.iter().flat_map(|(id, along)| {
            gradient.get(*id).iter().zip(along).map(|(slope, along)| slope * along)
        });
        let (backwards, size) = dot(products);
        let error = (forwards - backwards).abs() / size;
        assert!(error <= bound, "{arithmetic:?}: {forwards} and {backwards}, off by {error:e}");
    }
}

/// The same of the functions, whose images are in single precision.
#[test]
fn images_and_pullbacks_are_those_of_the_functions() {
    let scene = scene(37);
    let settings = in_arithmetic(Arithmetic::F64x8);
    let (direction, cotangent) = (direction(&scene), cotangent(&scene));
    let (image, derivative) = render_jvp(&scene, &settings, &direction).unwrap();
    let (same, pullback) = render_vjp(&scene, &settings, &scene.parameters()).unwrap();
    assert_eq!(image, same);
    let products = derivative.pixels.as_flattened().iter().zip(cotangent.pixels.as_flattened());
    let (forwards, size) = dot(products.map(|(a, b)| f64::from(*a) * f64::from(*b)));
    let gradient = pullback(&cotangent);
    assert_eq!(gradient.iter().map(|(id, _)| id).collect::<Vec<_>>(), scene.parameters());
    let along = direction.iter().flat_map(|(_, along)| along);
    let backwards: f64 = gradient.concat().iter().zip(along).map(|(a, b)| a * b).sum();
    assert!((forwards - backwards).abs() <= 1e-7 * size, "{forwards} and {backwards}");
}

#[test]
fn directions_are_checked() {
    let scene = scene(4);
    let vertices = scene.parameter("mesh.tent.vertices").unwrap();
    let vertex = scene.parameter("mesh.tent.vertices[1]").unwrap();
    let refused = |direction: &[(ParameterId, Vec<f64>)]| {
        render_jvp(&scene, &crate::without_edges(), direction).unwrap_err().to_string()
    };
    let short = refused(&[(vertices, vec![0.0; 3])]);
    assert_eq!(short, "mesh.tent.vertices: moves by 3 numbers, has 12");
    let twice = refused(&[(vertices, vec![0.0; 12]), (vertex, vec![0.0; 3])]);
    assert_eq!(twice, "mesh.tent.vertices[1]: overlaps mesh.tent.vertices, which moves too");
}
