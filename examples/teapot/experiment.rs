//! The teapot before the camera and under the light of the paper's listing.

use std::path::Path;

use glam::{DVec3, dvec3};
use renderer::experiment::Experiment;
use renderer::{Error, Mesh, Scene};

use super::patches::{patches, tessellate};

/// Camera and light of the listing. What is in the shadow shows a little, too.
const SCENE: &str = r#"
bounces = 2

[camera]
look_from = [1.0, 10.0, -1.0]
look_at = [0.0, 0.0, 0.0]
vfov = 45.0
width = 512
height = 512

[[light]]
name = "light"
type = "distant"
direction = [0.0, 1.0, 0.0]
irradiance = 314.159

[material.porcelain]
emission = [10.0, 10.0, 10.0]
diffuse = [0.7, 0.7, 0.7]
specular = [0.3, 0.3, 0.3]
exponent = 50.0
"#;

/// Where the camera stands and what it looks at: in the listing, from the front, and from the side
/// of the spout.
pub const VIEWS: [(DVec3, DVec3); 3] = [
    (dvec3(1.0, 10.0, -1.0), DVec3::ZERO),
    (dvec3(0.5, 3.5, 10.0), dvec3(0.2, 1.4, 0.0)),
    (dvec3(8.0, 5.0, 5.0), dvec3(0.2, 1.4, 0.0)),
];

/// The scene, with every patch in `n` by `n` quadrilaterals, in an image of `size` by `size` pixels.
pub fn scene(n: u32, size: u32) -> Result<Scene, Error> {
    let mut scene = Experiment::parse(SCENE, Path::new(""), "the scene")?.scene;
    (scene.width, scene.height) = (size, size);
    let (vertices, triangles) = tessellate(&patches(), n);
    scene.add_mesh(Mesh::new("teapot", vertices, triangles))?;
    Ok(scene)
}
