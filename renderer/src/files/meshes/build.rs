//! From what files hold to meshes.

use super::{Mesh, Model};
use crate::files::obj::{DEFAULT_MATERIAL, ModelMaps, ModelMaterial, default_material};

/// A mesh of `triangles` over `vertices`, all of them in range: it keeps the vertices that are
/// used, in the order of their first use. `materials` has one index for each triangle.
pub(in crate::files) fn build_mesh(
    name: String,
    vertices: &[[f64; 3]],
    mut triangles: Vec<[u32; 3]>,
    materials: Vec<u32>,
) -> Mesh {
    let mut places: Vec<Option<u32>> = vec![None; vertices.len()];
    let mut used = Vec::new();
    for index in triangles.as_flattened_mut() {
        let place = places[*index as usize].get_or_insert_with(|| {
            used.push(vertices[*index as usize]);
            used.len() as u32 - 1
        });
        *index = *place;
    }
    plain_mesh(name, used, triangles, materials)
}

/// A mesh without texture coordinates.
pub(in crate::files) fn plain_mesh(
    name: String,
    vertices: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
    materials: Vec<u32>,
) -> Mesh {
    let (texture_coordinates, texture_triangles) = (Vec::new(), Vec::new());
    Mesh { name, vertices, triangles, materials, texture_coordinates, texture_triangles }
}

/// The default material; `place` is where it is first worn.
pub(in crate::files) fn plain_material(place: String) -> ModelMaterial {
    ModelMaterial {
        name: DEFAULT_MATERIAL.to_owned(),
        material: Some(default_material()),
        maps: ModelMaps::default(),
        place,
    }
}

/// A model of meshes that all wear the default material; `place` is where that is said.
pub(in crate::files) fn default_model(meshes: Vec<Mesh>, place: String) -> Model {
    Model { meshes, materials: vec![plain_material(place)] }
}
