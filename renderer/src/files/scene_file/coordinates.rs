//! Textures and the texture coordinates that they need.

use std::collections::{HashMap, HashSet};

use renderer_files::names::Names;

use crate::Warning;
use crate::scene::{MaterialObject, MaterialTextures, Mesh, Scene};

/// Gives triangles that have no texture coordinates their material without its textures, and warns of it: they are in
/// the file `place`.
pub(super) fn drop_bare_textures(scene: &mut Scene, place: &str) -> Vec<Warning> {
    let is_textured =
        |material: u32| scene.materials.get(material as usize).is_some_and(|m| m.textures.any());
    let is_bare = |mesh: &Mesh, triangle: usize| {
        mesh.texture_triangles.get(triangle).copied().flatten().is_none()
    };
    let mut warnings = Vec::new();
    let mut bare: Vec<(usize, usize)> = Vec::new();
    let mut shown: HashSet<u32> = scene.spheres.iter().map(|sphere| sphere.material).collect();
    for (index, mesh) in scene.meshes.iter().enumerate() {
        let mut told = HashSet::new();
        for (triangle, &material) in mesh.materials.iter().enumerate() {
            if !is_textured(material) {
                continue;
            }
            if !is_bare(mesh, triangle) {
                shown.insert(material);
                continue;
            }
            bare.push((index, triangle));
            if told.insert(material) {
                let name = &scene.materials[material as usize].name;
                let problem = format!(
                    "triangle {triangle} has the material `{name}`, which has a texture, but has \
                     no texture coordinates; it is shown without it"
                );
                warnings.push(Warning::new(format_args!("{place}: mesh.{}", mesh.name), problem));
            }
        }
    }
    let names = scene.materials.iter().map(|material| material.name.as_str());
    let mut names: Names = names.collect();
    let mut plain = HashMap::new();
    for (index, triangle) in bare {
        let material = scene.meshes[index].materials[triangle];
        let plain = *plain.entry(material).or_insert_with(|| {
            let assigned = &mut scene.materials[material as usize];
            if !shown.contains(&material) {
                assigned.textures = MaterialTextures::default();
                return material;
            }
            let (name, textures) = (names.take(assigned.name.clone()), MaterialTextures::default());
            let copy = MaterialObject { name, textures, ..assigned.clone() };
            scene.materials.push(copy);
            scene.materials.len() as u32 - 1
        });
        scene.meshes[index].materials[triangle] = plain;
    }
    warnings
}
