//! A sphere with bumps: a mesh of any size.

use std::f64::consts::{PI, TAU};

use glam::{DVec3, dvec3};
use renderer::kernels::camera::Camera;
use renderer::kernels::light::PointLight;
use renderer::kernels::material::Material;
use renderer::scene::{Light, MaterialObject, MeshObject, Parameters, Scene};

/// `rings` by `2 rings` quadrilaterals: vertices and triangles.
pub fn bumpy_sphere(rings: u32) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let columns = 2 * rings;
    let vertices = (0..=rings).flat_map(|ring| (0..columns).map(move |column| (ring, column)));
    let vertices = vertices.map(|(ring, column)| {
        let latitude = PI * f64::from(ring) / f64::from(rings);
        let longitude = TAU * f64::from(column) / f64::from(columns);
        let radius = 1.0 + 0.05 * (9.0 * latitude).sin() * (11.0 * longitude).cos();
        let around = radius * latitude.sin();
        [around * longitude.cos(), radius * latitude.cos(), around * longitude.sin()]
    });
    let vertex = |ring: u32, column: u32| ring * columns + column % columns;
    let triangles = (0..rings)
        .flat_map(|ring| (0..columns).map(move |column| (ring, column)))
        .flat_map(|(r, c)| {
            let (a, b) = (vertex(r, c), vertex(r, c + 1));
            let (d, e) = (vertex(r + 1, c), vertex(r + 1, c + 1));
            [[a, b, d], [b, e, d]]
        });
    (vertices.collect(), triangles.collect())
}

/// The sphere before a camera, under point lights of equal strength.
pub fn scene(rings: u32, size: u32, lights: u32) -> Scene {
    let (vertices, triangles) = bumpy_sphere(rings);
    let light = |index: u32| {
        let angle = f64::from(index) * 0.7;
        Light::Point(PointLight {
            position: dvec3(3.0 + angle.sin(), 4.0, 3.0 * angle.cos()),
            color: DVec3::ONE,
            intensity: 400.0 / f64::from(lights),
        })
    };
    let empty = Scene::empty();
    Scene {
        width: size,
        height: size,
        bounces: 0,
        parameters: Parameters {
            camera: Camera {
                look_from: dvec3(1.0, 1.0, 3.0),
                look_at: DVec3::ZERO,
                up: DVec3::Y,
                vfov: 45.0,
                focus: 1.0,
            },
            lights: (0..lights).map(light).collect(),
            materials: vec![Material {
                ambient: DVec3::ZERO,
                diffuse: dvec3(0.7, 0.6, 0.5),
                specular: DVec3::splat(0.1),
                exponent: 20.0,
                reflection: DVec3::ZERO,
            }],
            vertices: vec![vertices],
            texture_coordinates: vec![Vec::new()],
            ..empty.parameters
        },
        light_names: (0..lights).map(|index| format!("light_{index}")).collect(),
        materials: vec![MaterialObject::new("clay")],
        meshes: vec![MeshObject {
            name: "sphere".into(),
            materials: vec![0; triangles.len()],
            triangles,
            texture_triangles: Vec::new(),
        }],
        ..empty
    }
}
