//! The triangles of a primitive.

use glam::{DMat4, DVec3};

use super::document::{Document, Primitive, get};
use super::materials::Materials;
use super::{Buffers, accessor};
use crate::files::meshes::MeshBuilder;
use crate::scene::{Mesh, Transform};
use crate::transport::transform::place;

/// What a primitive draws, in the coordinates of its mesh.
pub(super) struct Part {
    vertices: Vec<[f64; 3]>,
    /// One for each vertex, or none at all.
    texture_coordinates: Vec<[f64; 2]>,
    triangles: Vec<[u32; 3]>,
    material: Option<usize>,
}

/// Reads a primitive, with the set of texture coordinates that its material uses. One of points or
/// lines has no triangles.
pub(super) fn load(
    document: &Document,
    buffers: &Buffers,
    materials: &Materials,
    primitive: &Primitive,
) -> Result<Part, String> {
    if let Some(material) = primitive.material {
        get(&document.materials, material, "materials")?;
    }
    let position = *primitive.attributes.get("POSITION").ok_or("has no attribute POSITION")?;
    let vertices: Vec<[f64; 3]> = accessor::vectors(document, buffers, position)?;
    let count = vertices.len();
    let set = format!("TEXCOORD_{}", materials.texture_set(primitive.material));
    let texture_coordinates = match primitive.attributes.get(&set) {
        None => Vec::new(),
        Some(&index) => {
            let coordinates: Vec<[f64; 2]> = accessor::vectors(document, buffers, index)?;
            if coordinates.len() != count {
                return Err(format!("has {} {set} for {count} vertices", coordinates.len()));
            }
            // In glTF the upper edge of a texture is at v = 0.
            coordinates.into_iter().map(|[u, v]| [u, 1.0 - v]).collect()
        }
    };
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
    Ok(Part { vertices, texture_coordinates, triangles, material: primitive.material })
}

/// All parts as one mesh, placed in the world; nothing if they have no triangles. The placement is kept
/// as it is, unless it shears: then the vertices are moved.
pub(super) fn join(
    parts: Vec<Part>,
    name: String,
    to_world: DMat4,
    materials: &mut Materials,
) -> Option<Mesh> {
    let transform = transform(to_world);
    let to_mesh = if transform.is_some() { DMat4::IDENTITY } else { to_world };
    let (mut vertices, mut coordinates) = (Vec::new(), Vec::new());
    let (mut triangles, mut texture_triangles, mut worn) = (Vec::new(), Vec::new(), Vec::new());
    for part in parts.into_iter().filter(|part| !part.triangles.is_empty()) {
        let (first, first_coordinates) = (vertices.len() as u32, coordinates.len() as u32);
        let place = |&v: &[f64; 3]| to_mesh.transform_point3(DVec3::from_array(v)).to_array();
        vertices.extend(part.vertices.iter().map(place));
        worn.resize(worn.len() + part.triangles.len(), materials.place(part.material));
        let is_textured = !part.texture_coordinates.is_empty();
        coordinates.extend(part.texture_coordinates);
        texture_triangles.extend(
            part.triangles.iter().map(|triangle| {
                is_textured.then(|| triangle.map(|index| index + first_coordinates))
            }),
        );
        triangles.extend(part.triangles.into_iter().map(|t| t.map(|index| index + first)));
    }
    let mut builder = MeshBuilder::new(&vertices, &coordinates);
    let transform = transform.unwrap_or_default();
    (!triangles.is_empty())
        .then(|| builder.build(name, triangles, texture_triangles, worn).transform(transform))
}

/// The scale, rotation and translation that a matrix is; nothing if it shears.
fn transform(matrix: DMat4) -> Option<Transform<f64>> {
    let (scale, rotation, translation) = matrix.to_scale_rotation_translation();
    let rotation = rotation.to_scaled_axis().map(f64::to_degrees);
    let transform = Transform { translation, rotation, scale };
    let same = |point: DVec3| {
        let (exact, placed) = (matrix.transform_point3(point), place::<f64>(transform, point));
        let size = exact.abs().max_element() + scale.abs().max_element();
        exact.is_finite() && exact.distance(placed) <= 1e-12 * size
    };
    DVec3::AXES.into_iter().all(same).then_some(transform)
}
