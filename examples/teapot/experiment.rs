//! The teapot before the camera and under the light of the paper's listing.

use glam::{DVec3, dvec3};
use renderer::kernels::camera::Camera;
use renderer::kernels::light::DistantLight;
use renderer::kernels::material::Material;
use renderer::scene::{Light, MaterialObject, MeshObject, Parameters, Scene};

use super::patches::{patches, tessellate};

/// Where the camera stands and what it looks at: in the listing, from the front, and from the side
/// of the spout.
pub const VIEWS: [(DVec3, DVec3); 3] = [
    (dvec3(1.0, 10.0, -1.0), DVec3::ZERO),
    (dvec3(0.5, 3.5, 10.0), dvec3(0.2, 1.4, 0.0)),
    (dvec3(8.0, 5.0, 5.0), dvec3(0.2, 1.4, 0.0)),
];

/// The scene, with every patch in `n` by `n` quadrilaterals, in an image of `size` by `size` pixels.
pub fn scene(n: u32, size: u32) -> Scene {
    let (vertices, triangles) = tessellate(&patches(), n);
    let mesh = MeshObject {
        name: "teapot".to_owned(),
        materials: vec![0; triangles.len()],
        triangles,
        texture_triangles: Vec::new(),
    };
    let empty = Scene::empty();
    Scene {
        width: size,
        height: size,
        bounces: 2,
        parameters: Parameters {
            camera: Camera {
                look_from: VIEWS[0].0,
                look_at: VIEWS[0].1,
                up: DVec3::Y,
                vfov: 45.0,
                focus: 1.0,
            },
            lights: vec![Light::Distant(DistantLight {
                direction: DVec3::Y,
                color: DVec3::ONE,
                intensity: 100.0,
            })],
            materials: vec![Material {
                // What is in the shadow shows, too.
                ambient: DVec3::splat(10.0),
                diffuse: DVec3::splat(0.7),
                specular: DVec3::splat(0.3),
                exponent: 50.0,
                reflection: DVec3::ZERO,
            }],
            vertices: vec![vertices],
            texture_coordinates: vec![Vec::new()],
            ..empty.parameters
        },
        light_names: vec!["light".to_owned()],
        materials: vec![MaterialObject::new("porcelain")],
        meshes: vec![mesh],
        ..empty
    }
}
