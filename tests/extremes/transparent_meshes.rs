//! Images with edges of transparent meshes, and their gradients, in places where little is known of rays.

use glam::{DVec3, dvec3};
use renderer::scene::Slot;
use renderer::{
    Camera, DistantLight, Edges, Material, MaterialObject, Mesh, PointLight, Scene, Settings,
    SpotLight, Texture, Wrap,
};

use crate::images::{ARITHMETICS, evaluate_with};

/// Checks that an image and its gradient by every parameter are finite.
#[track_caller]
fn check(scene: &Scene) {
    for arithmetic in ARITHMETICS {
        let settings = Settings { arithmetic, edges: Edges::On, ..Settings::default() };
        let image = renderer::render(scene, &settings).unwrap();
        assert!(image.is_finite(), "{arithmetic:?}");
        let (loss, gradient) = evaluate_with(scene, &settings);
        assert!(loss.is_finite(), "{arithmetic:?}");
        for (id, block) in gradient {
            assert!(block.iter().all(|x| x.is_finite()), "{arithmetic:?}: {}", scene.path(id));
        }
    }
}

fn scene(look_from: DVec3, look_at: DVec3, vfov: f64) -> Scene {
    Scene::new(24, 20, Camera { vfov, ..Camera::looking(look_from, look_at) })
}

/// The light shines along the planes of the triangles at its vertex, and meets no point of their textures.
#[test]
fn a_light_at_a_vertex_of_a_textured_mesh() {
    let mut scene = scene(dvec3(-3.0, 3.1, 1.5), dvec3(1.0, -2.0, 1.0), 60.0);
    let spot = SpotLight {
        position: dvec3(-2.0, 0.0, 0.0),
        direction: dvec3(1.0, 0.5, 0.0),
        color: DVec3::ONE,
        radiant_intensity: 5.0,
        inner_angle: 0.0,
        outer_angle: 90.0,
    };
    scene.add_light("spot", spot).unwrap();
    let texels = vec![[0.2_f64; 3], [0.9; 3], [0.4; 3], [0.6; 3]].into();
    let holes = Texture { name: "holes".into(), width: 2, height: 2, wrap: Wrap::Repeat, texels };
    let holes = scene.add_texture(holes).unwrap();
    let veil = MaterialObject::from(Material::lambertian(DVec3::splat(0.5)));
    let veil = veil.with_opacity(0.5).with_texture(Slot::Opacity, holes);
    let veil = scene.add_material("veil", veil).unwrap();
    let vertices = vec![[1.0, -2.0, 1.0], [-2.0, 0.0, 0.0], [0.0, 2.0, 1.0], [2.0, 0.0, 1.0]];
    let uvs = vec![[0.0, 0.0], [1.0, 1.0], [0.5, 0.5], [1.0, 0.0]];
    let triangles = vec![[1, 0, 3], [1, 3, 0], [1, 0, 2]];
    let mesh = Mesh::new("veil", vertices, triangles.clone()).material(veil);
    scene.add_mesh(mesh.texture_coordinates(uvs, triangles)).unwrap();
    check(&scene);
}

/// At a silhouette behind another one the ray on the far side of it meets nothing at all.
#[test]
fn a_silhouette_behind_one_that_ends_there() {
    let mut scene = scene(dvec3(3.013, 1.9, -0.166114), dvec3(0.0, 1.0, 0.5), 90.0);
    scene.bounces = 3;
    let point = PointLight {
        position: dvec3(3.0, 1.5, -2.66611),
        color: DVec3::ONE,
        radiant_intensity: 5.0,
    };
    scene.add_light("point", point).unwrap();
    let sun = DistantLight { direction: dvec3(0.0, 0.5, -1.0), color: DVec3::ONE, irradiance: 2.0 };
    scene.add_light("sun", sun).unwrap();
    let veil = MaterialObject::from(Material::lambertian(dvec3(0.5, 0.4, 0.3)));
    let veil = scene.add_material("veil", veil.with_opacity(0.5)).unwrap();
    let vertices = vec![
        [0.0, 1.0, 0.5],
        [0.5, 1.0, -1.0],
        [0.0, 2.0, 1.0],
        [-1.0, 1.0, 0.5],
        [0.5, -1.0, -1.0],
        [2.0, 1.0, 1.0],
        [0.0, 2.0, 0.0],
        [0.585955, 1.0, -1.0],
    ];
    let triangles = vec![[5, 1, 2], [4, 1, 0], [2, 1, 7], [7, 6, 1], [2, 0, 3], [7, 3, 5]];
    scene.add_mesh(Mesh::new("shards", vertices, triangles).material(veil).smooth()).unwrap();
    check(&scene);
}
