//! How the error of a gradient in single precision grows with the image, the paths, the geometry.
//!
//! The error is that against the gradient in double precision, relative to the largest element of the
//! parameter. Sums over pixels are in double precision, so that more pixels make it smaller, not
//! larger. Pixels whose ray, or what becomes of it in mirrors, passes on the other side of an edge in single
//! precision are counted, and left out of both gradients: they show another triangle, which is no rounding
//! error of the gradient.

use glam::dvec3;
use renderer::scene::Object;
use renderer::{Arithmetic, Image, ImageLoss, LossKind, ParameterId, Renderer, Scene, render};

use crate::away_from_edges::AwayFromEdges;
use crate::images::settings;
use crate::meshes::Mesh;
use crate::scenes::{mirror_scene, multiply, small_parts, small_scene};

/// What errors stay below.
const BOUND: f64 = 5e-5;
/// Beyond this difference, relative to the brighter one, two pixels do not show the same.
const OTHER: f32 = 1e-3;
/// The part of the pixels of an image that stays below.
const FEW: f64 = 5e-3;

fn shows_same(a: &[f32; 3], b: &[f32; 3]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= OTHER * a.max(*b))
}

/// The largest error of the gradient by any of the given parameters, and the part of the pixels that
/// show something else.
fn error(scene: &Scene, counts: impl Fn(ParameterId) -> bool) -> (f64, f64) {
    let [single, double] = [Arithmetic::F32x16, Arithmetic::F64x8]
        .map(|arithmetic| Renderer::new(scene, &settings(arithmetic)).unwrap());
    let mut target = double.render();
    let same = shown_by_all(scene);
    let others = same.iter().filter(|same| !**same).count() as f64 / same.len() as f64;
    dim(&mut target);
    let loss = ImageLoss::new(LossKind::MeanSquared, &target, false);
    let loss = AwayFromEdges { loss, keep: same, width: scene.width };
    let ids: Vec<ParameterId> = scene.parameters().into_iter().filter(|&id| counts(id)).collect();
    let [single, double] =
        [single, double].map(|renderer| renderer.loss_and_gradient(scene, &loss, &ids).gradient);
    let mut worst = 0.0_f64;
    for id in ids {
        let (single, double) = (single.get(id), double.get(id));
        let largest = double.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        for (s, d) in single.iter().zip(double).filter(|_| largest > 0.0) {
            worst = crate::larger(worst, (s - d).abs() / largest);
        }
    }
    (worst, others)
}

/// The pixels that show the same in both precisions, also in mirrors that reflect nothing: the derivative
/// by what these reflect is what they would show.
fn shown_by_all(scene: &Scene) -> Vec<bool> {
    let mut mirrors = scene.clone();
    for id in scene.parameters().into_iter().filter(|id| id.field == "mirror") {
        let at_least: Vec<f64> = scene.get(id).iter().map(|part| part.max(0.5)).collect();
        mirrors.set(id, &at_least).unwrap();
    }
    let [single, double] = [Arithmetic::F32x16, Arithmetic::F64x8]
        .map(|arithmetic| render(&mirrors, &settings(arithmetic)).unwrap());
    single.pixels.iter().zip(&double.pixels).map(|(a, b)| shows_same(a, b)).collect()
}

fn dim(image: &mut Image) {
    image.pixels.as_flattened_mut().iter_mut().for_each(|x| *x *= 0.7);
}

/// Parameters that move no edge but those of shadows: a pixel that falls on the other side of one is no
/// rounding error.
fn is_smooth(id: ParameterId) -> bool {
    matches!(id.object, Object::Light(_) | Object::Material(_))
}

#[track_caller]
fn check(name: &str, scene: &Scene) {
    let (error, others) = error(scene, is_smooth);
    println!("| {name} | {error:.1e} | {others:.1e} |");
    assert!(error <= BOUND, "{name}: {error:e}");
    assert!(others <= FEW, "{name}: {others:e}");
}

fn pixels(sizes: &[u32]) {
    for &size in sizes {
        let mut scene = small_scene(size);
        scene.height = size;
        check(&format!("{} pixels", size * size), &scene);
    }
}

fn depths(depths: &[u32]) {
    for &depth in depths {
        let mut scene = mirror_scene(48);
        scene.bounces = depth;
        for path in ["material.ground.mirror", "material.object.mirror"] {
            multiply(&mut scene, path, 2.0);
        }
        check(&format!("{depth} mirrors"), &scene);
    }
}

fn triangles(subdivisions: &[u32]) {
    for &subdivisions in subdivisions {
        let mesh = Mesh::bumpy(subdivisions);
        let mut scene = small_scene(128);
        let material = small_parts(128).materials[1].values;
        let material = scene.add_material("bumps", material).unwrap();
        let vertices = mesh.vertices.iter().map(|&v| (v * 0.8 + dvec3(-0.5, 1.2, -0.8)).into());
        let bumps = renderer::Mesh::new("bumps", vertices.collect(), mesh.triangles.clone());
        scene.add_mesh(bumps.material(material)).unwrap();
        check(&format!("{} triangles", mesh.triangles.len()), &scene);
    }
}

#[test]
fn errors_do_not_grow() {
    pixels(&[10, 32, 100]);
    depths(&[0, 2, 8]);
    triangles(&[1, 4]);
}

#[test]
#[ignore = "a minute"]
fn errors_do_not_grow_far() {
    pixels(&[10, 32, 100, 316, 1000, 3162]);
    depths(&[0, 1, 2, 4, 8, 16, 32]);
    triangles(&[1, 3, 5, 7]);
}
