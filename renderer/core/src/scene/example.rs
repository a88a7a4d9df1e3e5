//! A scene to test on: a tree of two materials under one light.

use glam::DVec3;

use super::{Camera, Material, Mesh, PointLight, Scene};

/// A trunk of four sides below a crown of four.
pub fn tree() -> Scene {
    let camera = Camera::looking(DVec3::new(0.0, 6.0, -10.0), DVec3::new(0.0, 2.0, 0.0));
    let mut scene = Scene::new(128, 128, camera);
    let position = DVec3::new(-1.0, -10.0, -50.0);
    let light = PointLight { position, color: DVec3::ONE, radiant_intensity: 0.25 };
    scene.add_light("key", light).unwrap();
    let bark = scene.add_material("bark", Material::lambertian(DVec3::splat(0.2))).unwrap();
    let leaves = scene.add_material("leaves", Material::lambertian(DVec3::splat(0.3))).unwrap();
    let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let at = |scale: f64, y: f64| square.map(|[x, z]| [scale * x, y, scale * z]);
    let vertices = [at(0.3, 0.0), at(0.2, 2.0), at(1.5, 2.0)].concat();
    let vertices = [vertices, vec![[0.0, 5.0, 0.0]]].concat();
    let side = |i: u32| {
        let next = (i + 1) % 4;
        [[i, next, 4 + i], [next, 4 + next, 4 + i], [8 + i, 8 + next, 12]]
    };
    let triangles: Vec<[u32; 3]> = (0..4).flat_map(side).collect();
    let material = |triangle: usize| if triangle % 3 == 2 { leaves } else { bark };
    let materials = (0..triangles.len()).map(material).collect();
    scene.add_mesh(Mesh { materials, ..Mesh::new("tree", vertices, triangles) }).unwrap();
    scene
}
