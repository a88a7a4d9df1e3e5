//! What the images show, and the lights that they are rendered with.

use std::path::Path;

use glam::{DVec3, dvec3};
use renderer::demo::{LowPolyTree, low_poly_tree};
use renderer::experiment::Experiment;
use renderer::{Error, Mesh, Scene};

use crate::random::Random;

/// Camera, materials and two balls. Light and size of the image are put in the place of these.
const SCENE: &str = r#"
[camera]
look_from = [0.0, 6.0, 9.0]
look_at = [0.0, 1.2, 0.0]
vfov = 40.0
width = 1
height = 1

[[light]]
name = "lamp"
type = "point"
position = [0.0, 5.0, 2.0]
radiant_intensity = 150.0

[[sphere]]
name = "red"
center = [-2.0, 0.8, 0.8]
radius = 0.8
material = "red"

[[sphere]]
name = "blue"
center = [1.9, 0.6, 1.6]
radius = 0.6
material = "blue"

[material.floor]
diffuse = [0.6, 0.58, 0.55]

[material.bark]
diffuse = [0.24, 0.14, 0.07]

[material.leaves]
diffuse = [0.10, 0.34, 0.09]

[material.red]
diffuse = [0.7, 0.15, 0.1]
specular = [0.3, 0.3, 0.3]
exponent = 20.0

[material.blue]
diffuse = [0.12, 0.25, 0.7]
specular = [0.3, 0.3, 0.3]
exponent = 20.0
"#;

/// What is to be found of the light, in the order of [`Lamp::numbers`].
pub const PATHS: [&str; 2] = ["light.lamp.position", "light.lamp.radiant_intensity"];

/// Half of the width of the floor.
const FLOOR: f64 = 6.0;

/// A tree and two balls on a floor, in images of `size` by `size` pixels.
///
/// # Errors
///
/// None: every test renders it.
pub fn scene(size: u32) -> Result<Scene, Error> {
    let mut scene = Experiment::parse(SCENE, Path::new(""), "the scene")?.scene;
    (scene.width, scene.height) = (size, size);
    let material = |name: &str| {
        let place = scene.materials().iter().position(|material| material.name == name);
        place.map(|place| place as u32).ok_or_else(|| Error::new("the scene", name))
    };
    let [bark, leaves, floor] = ["bark", "leaves", "floor"].map(material);
    let (bark, leaves, floor) = (bark?, leaves?, floor?);
    let LowPolyTree { vertices, triangles, trunk } = low_poly_tree();
    let mut tree = Mesh::new("tree", vertices, triangles).material(leaves);
    tree.materials[..trunk].fill(bark);
    scene.add_mesh(tree)?;
    let corners = [[-1.0, 1.0], [1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]];
    let corners = corners.map(|[x, z]| [FLOOR * x, 0.0, FLOOR * z]).to_vec();
    let triangles = vec![[0, 1, 2], [0, 2, 3]];
    scene.add_mesh(Mesh::new("floor", corners, triangles).material(floor))?;
    Ok(scene)
}

/// The light of an image: a lamp in a room.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lamp {
    pub position: DVec3,
    /// Its radiant intensity.
    pub intensity: f64,
}

impl Lamp {
    /// How many numbers a lamp is: position and intensity.
    pub const NUMBERS: usize = 4;
    /// The least of each number: lamps are in the box between this and [`HIGHEST`](Self::HIGHEST).
    pub const LOWEST: Self = Self { position: dvec3(-4.0, 4.5, -2.0), intensity: 75.0 };
    /// The largest of each number.
    pub const HIGHEST: Self = Self { position: dvec3(4.0, 7.5, 5.0), intensity: 300.0 };

    /// Any lamp of the box. Positions are spread evenly, intensities evenly over their logarithm.
    pub fn random(random: &mut Random) -> Self {
        let (low, high) = (Self::LOWEST, Self::HIGHEST);
        let position = [0, 1, 2].map(|i| random.between(low.position[i], high.position[i]));
        let logarithm = random.between(low.intensity.ln(), high.intensity.ln());
        Self { position: position.into(), intensity: logarithm.exp() }
    }

    /// As the parameters of the layer that renders.
    pub fn numbers(&self) -> [f32; Self::NUMBERS] {
        let [x, y, z] = self.position.as_vec3().to_array();
        [x, y, z, self.intensity as f32]
    }

    /// From the parameters of the layer that renders.
    pub fn from_numbers(numbers: [f32; Self::NUMBERS]) -> Self {
        let [x, y, z, intensity] = numbers.map(f64::from);
        Self { position: dvec3(x, y, z), intensity }
    }
}
