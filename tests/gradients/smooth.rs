//! Smooth meshes beside the surfaces that they stand for.

use std::f64::consts::{PI, TAU};

use glam::{DVec3, dvec3};
use renderer::{
    Arithmetic, Camera, Error, Image, Material, Mesh, PointLight, Scene, SphereObject, Transform,
    render,
};

use crate::everything::smooth_meshes;
use crate::image::{agrees_with_finite_differences, in_arithmetic, lanes_agree_on};
use crate::scenes::{mirror_parts, small_parts};

/// A unit sphere of `2 n` by `n` quadrilaterals, cut into triangles.
fn globe(n: usize) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let mut vertices = vec![[0.0, 1.0, 0.0]];
    for ring in 1..n {
        let (sine, cosine) = (PI * ring as f64 / n as f64).sin_cos();
        vertices.extend((0..2 * n).map(|i| {
            let (x, z) = (TAU * i as f64 / (2 * n) as f64).sin_cos();
            [sine * x, cosine, sine * z]
        }));
    }
    vertices.push([0.0, -1.0, 0.0]);
    let last = vertices.len() as u32 - 1;
    let at = |ring: usize, i: usize| match ring {
        0 => 0,
        _ if ring == n => last,
        _ => (1 + (ring - 1) * 2 * n + i % (2 * n)) as u32,
    };
    let mut triangles = Vec::new();
    for ring in 0..n {
        for i in 0..2 * n {
            let [a, b, c, d] = [at(ring, i), at(ring + 1, i), at(ring + 1, i + 1), at(ring, i + 1)];
            triangles.extend(
                [[a, b, c], [a, c, d]].into_iter().filter(|[a, b, c]| a != b && b != c && c != a),
            );
        }
    }
    (vertices, triangles)
}

/// A glossy ball lit from the side.
fn scene(add: impl FnOnce(&mut Scene) -> Result<u32, Error>) -> Scene {
    let mut scene = Scene::new(96, 96, Camera::looking(dvec3(0.0, 0.0, 4.0), DVec3::ZERO));
    let paint = Material {
        specular: DVec3::splat(0.4),
        exponent: 20.0,
        ..Material::lambertian(dvec3(0.7, 0.5, 0.3))
    };
    scene.add_material("paint", paint).unwrap();
    let position = dvec3(6.0, 2.0, 1.0);
    scene
        .add_light("key", PointLight { position, color: DVec3::ONE, radiant_intensity: 90.0 })
        .unwrap();
    add(&mut scene).unwrap();
    scene
}

fn image_of(mesh: Mesh) -> Image {
    let scene = scene(|scene| scene.add_mesh(mesh));
    render(&scene, &in_arithmetic(Arithmetic::F64)).unwrap()
}

fn image_of_sphere() -> Image {
    let ball = SphereObject::new("ball", DVec3::ZERO, 1.0);
    let scene = scene(|scene| scene.add_sphere(ball));
    render(&scene, &in_arithmetic(Arithmetic::F64)).unwrap()
}

/// The mean and the largest difference over the pixels within a circle, for the silhouettes of meshes are
/// polygons.
fn difference(a: &Image, b: &Image, radius: f64) -> (f64, f64) {
    let middle = 0.5 * f64::from(a.width);
    let mut inside: Vec<f64> = Vec::new();
    for (index, (a, b)) in a.pixels.iter().zip(&b.pixels).enumerate() {
        let (x, y) =
            (index as f64 % (2.0 * middle) + 0.5, (index / (2 * middle as usize)) as f64 + 0.5);
        if (x - middle).hypot(y - middle) < radius * middle {
            inside.push(f64::from((a[0] - b[0]).abs()));
        }
    }
    let mean = inside.iter().sum::<f64>() / inside.len() as f64;
    // In this order no number is larger than any.
    (mean, inside.into_iter().max_by(f64::total_cmp).unwrap_or(f64::NAN))
}

/// The silhouette of the sphere has the radius 0.62 in halves of the image.
const WITHIN: f64 = 0.58;

#[test]
fn a_smooth_mesh_of_a_sphere_looks_like_the_sphere() {
    let sphere = image_of_sphere();
    let mut last = f64::INFINITY;
    for n in [12, 24, 48] {
        let (vertices, triangles) = globe(n);
        let mesh = Mesh::new("ball", vertices.clone(), triangles.clone());
        let flat = difference(&image_of(mesh.clone()), &sphere, WITHIN);
        let computed = difference(&image_of(mesh.clone().smooth()), &sphere, WITHIN);
        let given = difference(&image_of(mesh.normals(vertices, triangles)), &sphere, WITHIN);
        println!("{n}: flat {flat:?}, computed {computed:?}, given {given:?}");
        assert!(computed.0 < 0.2 * flat.0 && given.0 < 0.2 * flat.0);
        // No triangle at the terminator is black.
        assert!(computed.1 < 0.5 * flat.1 && given.1 < 0.5 * flat.1);
        assert!(computed.0 < 0.5 * last, "{} after {last}", computed.0);
        last = computed.0;
    }
    assert!(last < 1e-3, "{last}");
}

/// A sphere that is scaled to an ellipsoid, turned, mirrored and seen from inside: computed normals, and
/// given ones that are placed, are close to each other.
#[test]
fn given_normals_are_placed_with_their_mesh() {
    let (vertices, triangles) = globe(48);
    let mesh = Mesh::new("ball", vertices.clone(), triangles.clone());
    for (scale, inwards) in [(dvec3(0.9, 0.5, 0.7), 1.0), (dvec3(-0.6, 0.9, 0.8), -1.0)] {
        let transform =
            Transform { rotation: dvec3(30.0, 20.0, -40.0), scale, ..Transform::IDENTITY };
        let normals = vertices.iter().map(|v| v.map(|x| inwards * x)).collect();
        let given = mesh.clone().normals(normals, triangles.clone()).transform(transform);
        let computed = mesh.clone().smooth().transform(transform);
        let (mean, largest) = difference(&image_of(given), &image_of(computed), 1.0);
        println!("{scale}: {mean} {largest}");
        assert!(mean < 1e-3 && largest < 0.05, "{scale}: {mean} {largest}");
    }
}

/// The normals of triangles that are there twice, once for either side, cancel but for rounding.
#[test]
fn a_smooth_mesh_of_two_sides_is_flat() {
    let (vertices, mut triangles) = globe(7);
    let flat = image_of(Mesh::new("ball", vertices.clone(), triangles.clone()));
    triangles.extend_from_within(..);
    let half = triangles.len() / 2;
    triangles[half..].iter_mut().for_each(|triangle| triangle.reverse());
    triangles[half..].reverse();
    let both = image_of(Mesh::new("ball", vertices, triangles).smooth());
    assert_eq!(difference(&both, &flat, WITHIN).1, 0.0);
}

/// Before mirrors of which many pixels look past the triangle that they hit.
#[test]
fn gradients_agree_with_finite_differences() {
    for scene in [smooth_meshes(small_parts(24)).scene(), smooth_meshes(mirror_parts(20)).scene()] {
        for id in scene.parameters() {
            agrees_with_finite_differences(&scene, id);
        }
        lanes_agree_on(&scene);
    }
}

/// A ball of few triangles, in whose mirror at grazing angles rays would enter it.
#[test]
fn coarse_mirrors_agree_with_finite_differences() {
    let (vertices, triangles) = globe(4);
    let mut parts = mirror_parts(20);
    parts.spheres.clear();
    let place = |[x, y, z]: [f64; 3]| [0.6 * x - 0.8, 0.6 * y + 0.6, 0.6 * z + 0.4];
    let vertices = vertices.into_iter().map(place).collect();
    parts.meshes[1] = Mesh::new("ball", vertices, triangles).material(1).smooth();
    let scene = parts.scene();
    for path in
        ["mesh.ball.translation", "mesh.ball.rotation", "mesh.ball.scale", "camera.look_from"]
    {
        agrees_with_finite_differences(&scene, scene.parameter(path).unwrap());
    }
    let image = render(&scene, &in_arithmetic(Arithmetic::F32x16)).unwrap();
    assert!(image.pixels.as_flattened().iter().all(|channel| channel.is_finite()));
}
