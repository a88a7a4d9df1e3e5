//! The embedded demo: recover a light from an image, without any file.

mod tree;

use std::path::Path;

use crate::Error;
use crate::experiment::Experiment;
use crate::scene::MeshObject;

pub use tree::{LowPolyTree, low_poly_tree};

/// Camera, lights, materials and the optimisation, without the tree.
const EXPERIMENT: &str = include_str!("demo.toml");

/// The inverse lighting experiment of RayTracer.jl on a low-poly tree of our own: a light behind
/// the camera is to be found from one image of the tree.
///
/// # Errors
///
/// None: the embedded file is part of the tests.
pub fn demo_experiment() -> Result<Experiment, Error> {
    let mut experiment = Experiment::parse(EXPERIMENT, Path::new(""), "demo.toml")?;
    let scene = &mut experiment.scene;
    let material = |name: &str| {
        let position = scene.materials.iter().position(|other| other.name == name);
        position.map(|index| index as u32).ok_or_else(|| {
            Error::new("demo.toml", format!("defines no material `{name}` for the tree"))
        })
    };
    let (bark, leaves) = (material("bark")?, material("leaves")?);
    let LowPolyTree { vertices, triangles, trunk } = low_poly_tree();
    let materials = (0..triangles.len()).map(|i| if i < trunk { bark } else { leaves });
    let materials = materials.collect();
    let texture_triangles = Vec::new();
    let name = "tree".to_owned();
    scene.meshes.push(MeshObject { name, triangles, materials, texture_triangles });
    scene.parameters.vertices.push(vertices);
    scene.parameters.texture_coordinates.push(Vec::new());
    scene.validate("demo.toml")?;
    Ok(experiment)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiment::Target;
    use crate::scene::ParameterId;

    #[test]
    fn the_demo_is_whole() {
        let Experiment { scene, optimize, .. } = demo_experiment().unwrap();
        assert_eq!(scene.check(), Ok(()));
        let (position, intensity) = (ParameterId::LightPosition(0), ParameterId::LightIntensity(0));
        assert_eq!(scene.parameters.get(position), [-1.0, -10.0, -50.0]);
        assert_eq!(scene.parameters.get(intensity), [1.0]);
        let optimize = optimize.unwrap();
        let expected =
            Target::Values(vec![(position, vec![1.0, 10.0, -50.0]), (intensity, vec![20000.0])]);
        assert_eq!(optimize.target, Some(expected));
        let tuned: Vec<ParameterId> = optimize.parameters.iter().map(|p| p.id).collect();
        assert_eq!(tuned, [position, intensity]);
    }
}
