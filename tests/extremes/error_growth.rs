//! How the error of a gradient in single precision grows with the image, the paths, the geometry.
//!
//! The error is that against the gradient in double precision, relative to the largest element of the
//! parameter. Sums over pixels are in double precision, so that more pixels make it smaller, not
//! larger.

use renderer::arithmetic::Arithmetic;
use renderer::scene::{MaterialObject, ParameterId, Scene};

use crate::images::evaluate;
use crate::meshes::Mesh;
use crate::scenes::{mirror_scene, small_scene};

/// What errors stay below.
const BOUND: f64 = 5e-5;
/// What they stay below where a pixel shows some ten triangles.
const BOUND_OF_FINE_MESHES: f64 = 2e-3;

/// The largest error of the gradient by any of the given parameters.
fn error(scene: &Scene, counts: impl Fn(ParameterId) -> bool) -> f64 {
    let (_, single) = evaluate(scene, Arithmetic::F32x16);
    let (_, double) = evaluate(scene, Arithmetic::F64x8);
    let mut worst = 0.0_f64;
    for ((id, single), (_, double)) in single.iter().zip(&double) {
        let largest = double.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        for (s, d) in single.iter().zip(double).filter(|_| counts(*id) && largest > 0.0) {
            worst = worst.max((s - d).abs() / largest);
        }
    }
    worst
}

/// Parameters that move no edge: a pixel that falls on the other side of one is no rounding error.
fn is_smooth(id: ParameterId) -> bool {
    use ParameterId::*;
    matches!(
        id,
        LightColor(_)
            | LightIntensity(_)
            | Ambient(_)
            | Diffuse(_)
            | Specular(_)
            | Exponent(_)
            | Reflection(_)
            | LightPosition(_)
            | LightDirection(_)
    )
}

#[track_caller]
fn check(name: &str, scene: &Scene, bound: f64) {
    let error = error(scene, is_smooth);
    println!("| {name} | {error:.1e} |");
    assert!(error <= bound, "{name}: {error:e}");
}

fn pixels(sizes: &[u32]) {
    for &size in sizes {
        let mut scene = small_scene(size);
        scene.height = size;
        check(&format!("{} pixels", size * size), &scene, BOUND);
    }
}

fn depths(depths: &[u32]) {
    for &depth in depths {
        let mut scene = mirror_scene(48);
        scene.bounces = depth;
        for material in &mut scene.parameters.materials {
            material.reflection *= 2.0;
        }
        check(&format!("{depth} mirrors"), &scene, BOUND);
    }
}

fn triangles(subdivisions: &[u32]) {
    for &subdivisions in subdivisions {
        let mesh = Mesh::bumpy(subdivisions);
        let mut scene = small_scene(128);
        scene.materials.push(MaterialObject::new("bumps"));
        scene.parameters.materials.push(scene.parameters.materials[1]);
        let object = scene.meshes[1].clone();
        scene.meshes.push(renderer::scene::MeshObject {
            name: "bumps".into(),
            triangles: mesh.triangles.clone(),
            materials: vec![2; mesh.triangles.len()],
            ..object
        });
        let vertices =
            mesh.vertices.iter().map(|&v| (v * 0.8 + glam::dvec3(-0.5, 1.2, -0.8)).into());
        scene.parameters.vertices.push(vertices.collect());
        scene.parameters.texture_coordinates.push(Vec::new());
        let bound = if subdivisions < 7 { BOUND } else { BOUND_OF_FINE_MESHES };
        check(&format!("{} triangles", mesh.triangles.len()), &scene, bound);
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
