//! Meshes as glTF sees them: a vertex has one position, one normal and one place on textures.

use std::collections::HashMap;

use renderer_core::scene::{Mesh, Normals};

/// The indices of what a corner has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Corner {
    pub vertex: u32,
    pub texture: Option<u32>,
    pub normal: Option<u32>,
}

/// Triangles of one material, all of whose corners have the same attributes.
#[derive(Default)]
pub(super) struct Part {
    pub material: u32,
    /// What is different, in the order of its first use.
    pub corners: Vec<Corner>,
    /// Three indices into `corners` for each triangle.
    pub indices: Vec<u32>,
    numbers: HashMap<Corner, u32>,
}

/// The parts of a mesh, in the order of their first triangles. Of its normals only directions count.
pub(super) fn parts(mesh: &Mesh) -> Vec<Part> {
    let normals: &[_] = match &mesh.normals {
        Normals::Given { triangles, .. } => triangles,
        Normals::Flat | Normals::Smooth => &[],
    };
    let mut parts: Vec<Part> = Vec::new();
    let mut places = HashMap::new();
    for (triangle, (vertices, &material)) in mesh.triangles.iter().zip(&mesh.materials).enumerate()
    {
        let texture = mesh.texture_triangles.get(triangle).copied().flatten();
        let normal = normals.get(triangle).copied().flatten();
        let place = places.entry((material, texture.is_some(), normal.is_some()));
        let place = *place.or_insert_with(|| {
            parts.push(Part { material, ..Part::default() });
            parts.len() - 1
        });
        let Part { corners, indices, numbers, .. } = &mut parts[place];
        for i in 0..3 {
            let corner = Corner {
                vertex: vertices[i],
                texture: texture.map(|indices| indices[i]),
                normal: normal.map(|indices| indices[i]),
            };
            indices.push(*numbers.entry(corner).or_insert_with(|| {
                corners.push(corner);
                corners.len() as u32 - 1
            }));
        }
    }
    parts
}
