//! A light at a vertex of a transparent mesh: it shines along the planes of triangles.

use glam::{DVec3, dvec3};
use renderer::scene::Slot;
use renderer::{
    Camera, Edges, Material, MaterialObject, Mesh, Scene, Settings, SpotLight, Texture, Wrap,
};

use crate::images::{ARITHMETICS, evaluate_with};

fn scene() -> Scene {
    let camera = Camera::looking(dvec3(-3.0, 3.1, 1.5), dvec3(1.0, -2.0, 1.0));
    let camera = Camera { vfov: 60.0, ..camera };
    let mut scene = Scene::new(24, 20, camera);
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
    scene
}

#[test]
fn light_along_a_textured_triangle_is_finite() {
    for arithmetic in ARITHMETICS {
        let settings = Settings { arithmetic, edges: Edges::On, ..Settings::default() };
        let image = renderer::render(&scene(), &settings).unwrap();
        assert!(image.is_finite(), "{arithmetic:?}");
        let (loss, gradient) = evaluate_with(&scene(), &settings);
        assert!(loss.is_finite(), "{arithmetic:?}");
        for (id, block) in gradient {
            assert!(block.iter().all(|x| x.is_finite()), "{arithmetic:?}: {}", scene().path(id));
        }
    }
}
