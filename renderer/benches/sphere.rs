//! A sphere with bumps: a mesh of any size.

use std::f64::consts::{PI, TAU};

use glam::{DVec3, dvec3};
use renderer::{Camera, Error, Material, Mesh, PointLight, Scene};

/// `rings` by `2 rings` quadrilaterals.
pub fn bumpy_sphere(rings: u32) -> Mesh {
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
    Mesh::new("sphere", vertices.collect(), triangles.collect())
}

/// A mesh before a camera, under point lights of equal strength.
pub fn scene(mesh: Mesh, size: u32, lights: u32) -> Result<Scene, Error> {
    let mut scene = Scene::new(size, size, Camera::looking(dvec3(1.0, 1.0, 3.0), DVec3::ZERO));
    scene.bounces = 0;
    for index in 0..lights {
        let angle = f64::from(index) * 0.7;
        let light = PointLight {
            position: dvec3(3.0 + angle.sin(), 4.0, 3.0 * angle.cos()),
            color: DVec3::ONE,
            radiant_intensity: 100.0 / f64::from(lights),
        };
        scene.add_light(format!("light_{index}"), light)?;
    }
    let clay = Material {
        specular: DVec3::splat(0.1),
        exponent: 20.0,
        ..Material::lambertian(dvec3(0.7, 0.6, 0.5))
    };
    scene.add_material("clay", clay)?;
    scene.add_mesh(mesh)?;
    Ok(scene)
}
