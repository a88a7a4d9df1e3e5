//! A small scene with every kind of parameter.

use glam::{DVec3, dvec3};
use renderer::kernels::camera::Camera;
use renderer::kernels::light::{DistantLight, PointLight};
use renderer::kernels::material::Material;
use renderer::kernels::sphere::Sphere;
use renderer::scene::{
    Light, MaterialObject, MeshObject, Parameters, Scene, SphereObject, TextureObject, Wrap,
};

/// A floor of two triangles that fills the image, a tetrahedron-like pair of triangles and a sphere
/// inside the view; two lights that cast shadows.
pub fn small_scene(size: u32) -> Scene {
    let material = |diffuse: DVec3, specular: f64, exponent: f64| Material {
        ambient: dvec3(0.01, 0.02, 0.03),
        diffuse,
        specular: DVec3::splat(specular),
        exponent,
        reflection: DVec3::ZERO,
    };
    let empty = Scene::empty();
    Scene {
        width: size,
        height: size / 2 + 3,
        bounces: 3,
        parameters: Parameters {
            camera: Camera {
                look_from: dvec3(0.3, 2.5, 6.0),
                look_at: dvec3(0.1, 0.4, 0.0),
                up: dvec3(0.05, 1.0, 0.1),
                vfov: 35.0,
                focus: 0.9,
            },
            lights: vec![
                Light::Point(PointLight {
                    position: dvec3(2.0, 4.0, 3.0),
                    color: dvec3(1.0, 0.9, 0.8),
                    intensity: 400.0,
                }),
                Light::Distant(DistantLight {
                    direction: dvec3(-1.0, 2.0, 1.5),
                    color: dvec3(0.5, 0.6, 0.9),
                    intensity: 0.4,
                }),
            ],
            materials: vec![
                material(dvec3(0.6, 0.5, 0.4), 0.1, 8.0),
                material(dvec3(0.2, 0.7, 0.3), 0.3, 25.0),
            ],
            spheres: vec![Sphere { center: dvec3(-0.8, 0.5, 0.4), radius: 0.5 }],
            vertices: vec![
                vec![[-9.0, 0.0, 9.0], [9.0, 0.1, 9.0], [9.0, -0.1, -30.0], [-9.0, 0.05, -30.0]],
                vec![[0.4, 0.0, 0.6], [1.6, 0.1, 0.5], [1.0, 1.3, 0.2], [1.8, 0.9, -0.6]],
            ],
            texture_coordinates: vec![Vec::new(); 2],
            ..empty.parameters
        },
        light_names: vec!["key".into(), "sky".into()],
        materials: vec![MaterialObject::new("ground"), MaterialObject::new("object")],
        spheres: vec![SphereObject { name: "ball".into(), material: 1 }],
        meshes: vec![
            MeshObject {
                name: "floor".into(),
                triangles: vec![[0, 1, 2], [0, 2, 3]],
                materials: vec![0, 0],
                texture_triangles: Vec::new(),
            },
            MeshObject {
                name: "tent".into(),
                triangles: vec![[0, 1, 2], [1, 3, 2]],
                materials: vec![1, 1],
                texture_triangles: Vec::new(),
            },
        ],
        ..empty
    }
}

/// The small scene with floor and sphere as mirrors: the sphere shows the floor, which shows the
/// sphere again.
pub fn mirror_scene(size: u32) -> Scene {
    let mut scene = small_scene(size);
    scene.parameters.materials[0].reflection = dvec3(0.3, 0.2, 0.1);
    scene.parameters.materials[1].reflection = dvec3(0.4, 0.5, 0.3);
    scene
}

/// The small scene with textures of every kind of wrapping on floor, mesh and sphere, and mirrors.
pub fn textured_scene(size: u32) -> Scene {
    let mut scene = mirror_scene(size);
    for (name, width, height, wrap) in [
        ("tiles", 3, 2, Wrap::Repeat),
        ("stripes", 4, 3, Wrap::Mirror),
        ("spot", 2, 2, Wrap::Clamp),
    ] {
        let texel = |i: u32| {
            let value =
                |channel: u32| 0.3 + 0.6 * f64::from((i * 5 + channel * 3 + i * i) % 7) / 6.0;
            [value(0), value(1), value(2)]
        };
        scene.textures.push(TextureObject { name: name.into(), width, height, wrap });
        scene.parameters.textures.push((0..width * height).map(texel).collect());
    }
    scene.materials[0].textures.diffuse = Some(0);
    scene.materials[0].textures.specular = Some(1);
    scene.materials[1].textures.diffuse = Some(2);
    scene.materials[1].textures.ambient = Some(1);
    scene.parameters.texture_coordinates = vec![
        vec![[-2.1, -1.3], [2.2, -1.1], [2.4, 5.3], [-1.9, 5.1], [0.3, 0.2]],
        vec![[0.13, 0.11], [1.2, -0.1], [0.61, 1.3], [1.4, 0.7]],
    ];
    scene.meshes[0].texture_triangles = vec![Some([0, 1, 2]), Some([0, 2, 3])];
    scene.meshes[1].texture_triangles = vec![Some([0, 1, 2]), Some([1, 3, 2])];
    scene
}
