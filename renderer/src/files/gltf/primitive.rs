//! The triangles of a primitive.

use glam::{DMat4, DVec3};

use super::document::{Document, Primitive, get};
use super::{Buffers, Materials, Mesh, accessor};
use crate::files::meshes::build_mesh;

/// What a primitive draws, in the coordinates of its mesh.
pub(super) struct Part {
    vertices: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
    material: Option<usize>,
}

/// Reads a primitive. One of points or lines has no triangles.
pub(super) fn load(
    document: &Document,
    buffers: &Buffers,
    primitive: &Primitive,
) -> Result<Part, String> {
    if let Some(material) = primitive.material {
        get(&document.materials, material, "materials")?;
    }
    let position = primitive.attributes.position.ok_or("has no attribute POSITION")?;
    let vertices = accessor::positions(document, buffers, position)?;
    let count = vertices.len();
    let indices = match primitive.indices {
        Some(index) => accessor::indices(document, buffers, index)?,
        None => (0..count).map(|i| i as u32).collect(),
    };
    if let Some(index) = indices.iter().find(|&&index| index as usize >= count) {
        return Err(format!("names vertex {index} of {count}, counted from 0"));
    }
    let triangles = match primitive.mode {
        0..=3 => Vec::new(),
        4 => indices.as_chunks().0.to_vec(),
        // Every second triangle of a strip turns the other way.
        5 => {
            let turned = |(i, t): (usize, &[u32])| {
                if i % 2 == 0 { [t[0], t[1], t[2]] } else { [t[1], t[0], t[2]] }
            };
            indices.windows(3).enumerate().map(turned).collect()
        }
        6 => indices.windows(2).skip(1).map(|edge| [indices[0], edge[0], edge[1]]).collect(),
        mode => return Err(format!("mode {mode} is none; there are 0 to 6")),
    };
    Ok(Part { vertices, triangles, material: primitive.material })
}

/// All parts as one mesh, in the world; nothing if they have no triangles.
pub(super) fn join(
    parts: Vec<Part>,
    name: String,
    to_world: DMat4,
    materials: &mut Materials,
) -> Option<Mesh> {
    let (mut vertices, mut triangles, mut worn) = (Vec::new(), Vec::new(), Vec::new());
    for part in parts.into_iter().filter(|part| !part.triangles.is_empty()) {
        let first = vertices.len() as u32;
        let place = |&v: &[f64; 3]| to_world.transform_point3(DVec3::from_array(v)).to_array();
        vertices.extend(part.vertices.iter().map(place));
        worn.resize(worn.len() + part.triangles.len(), materials.place(part.material));
        triangles.extend(part.triangles.into_iter().map(|t| t.map(|index| index + first)));
    }
    (!triangles.is_empty()).then(|| build_mesh(name, &vertices, triangles, worn))
}
