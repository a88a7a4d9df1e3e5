//! The embedded demo: recover a light from an image, without any file.

mod tree;

use std::path::Path;

use crate::Error;
use crate::experiment::Experiment;
use crate::scene::Mesh;

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
    scene.meshes.push(Mesh { materials, ..Mesh::new("tree", vertices, triangles) });
    scene.validate("demo.toml")?;
    Ok(experiment)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiment::Target;

    #[test]
    fn the_demo_is_whole() {
        let Experiment { scene, optimize, .. } = demo_experiment().unwrap();
        assert_eq!(scene.check(), Ok(()));
        let parameter = |path: &str| scene.parameter(path).unwrap();
        let (position, intensity) =
            (parameter("light.key.position"), parameter("light.key.radiant_intensity"));
        assert_eq!(scene.get(position)[..], [-1.0, -10.0, -50.0]);
        assert_eq!(scene.get(intensity)[..], [0.25]);
        let optimize = optimize.unwrap();
        let expected =
            Target::Values(vec![(position, vec![1.0, 10.0, -50.0]), (intensity, vec![5000.0])]);
        assert_eq!(optimize.target, Some(expected));
        let tuned: Vec<_> = optimize.parameters.iter().map(|p| p.id).collect();
        assert_eq!(tuned, [position, intensity]);
    }
}
