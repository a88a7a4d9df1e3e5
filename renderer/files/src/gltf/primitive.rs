//! The triangles of a primitive.

use std::collections::HashMap;

use glam::{DMat3, DMat4, DVec3};
use renderer_core::scene::{Mesh, Transform};
use renderer_core::transport::transform::place;

use super::document::{Document, Primitive, get};
use super::materials::Materials;
use super::{Buffers, accessor};
use crate::meshes::{FileNormals, MeshBuilder, Triangles, check_normal};

/// What a primitive draws, in the coordinates of its mesh.
pub(super) struct Part {
    /// The accessor of the vertices.
    position: usize,
    vertices: Vec<[f64; 3]>,
    /// One for each vertex, or none at all.
    texture_coordinates: Vec<[f64; 2]>,
    /// One for each vertex, or none at all.
    normals: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
    material: Option<usize>,
}

/// Reads a primitive, with the set of texture coordinates that its material uses, and its normals if they
/// are wanted. One of points or lines has no triangles.
pub(super) fn load(
    document: &Document,
    buffers: &Buffers,
    materials: &Materials,
    primitive: &Primitive,
    normals: FileNormals,
) -> Result<Part, String> {
    if let Some(material) = primitive.material {
        get(&document.materials, material, "materials")?;
    }
    let position = *primitive.attributes.get("POSITION").ok_or("has no attribute POSITION")?;
    let vertices: Vec<[f64; 3]> = accessor::vectors(document, buffers, position)?;
    let count = vertices.len();
    let set = format!("TEXCOORD_{}", materials.texture_set(primitive.material));
    let of_vertices = Attributes { document, buffers, primitive, count };
    // In glTF the upper edge of a texture is at v = 0.
    let texture_coordinates =
        of_vertices.read(&set)?.into_iter().map(|[u, v]| [u, 1.0 - v]).collect();
    let normals: Vec<[f64; 3]> = match normals {
        FileNormals::Ignore => Vec::new(),
        FileNormals::Read => of_vertices.read("NORMAL")?,
    };
    for (vertex, &normal) in normals.iter().enumerate() {
        check_normal(normal).map_err(|problem| format!("NORMAL {vertex}: {problem}"))?;
    }
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
    let material = primitive.material;
    Ok(Part { position, vertices, texture_coordinates, normals, triangles, material })
}

/// What vertices have beside their positions.
struct Attributes<'a> {
    document: &'a Document,
    buffers: &'a Buffers,
    primitive: &'a Primitive,
    /// The number of vertices.
    count: usize,
}

impl Attributes<'_> {
    /// The vectors of an attribute, one for each vertex; none if there is no such attribute.
    fn read<const N: usize>(&self, name: &str) -> Result<Vec<[f64; N]>, String> {
        let Some(&index) = self.primitive.attributes.get(name) else { return Ok(Vec::new()) };
        let vectors = accessor::vectors(self.document, self.buffers, index)?;
        match vectors.len() == self.count {
            true => Ok(vectors),
            false => Err(format!("has {} {name} for {} vertices", vectors.len(), self.count)),
        }
    }
}

/// All parts as one mesh, placed in the world; nothing if they have no triangles. Parts with the same accessor of vertices
/// share these. The placement is kept as it is, unless it shears: then the vertices are moved.
pub(super) fn join(
    parts: Vec<Part>,
    name: String,
    to_world: DMat4,
    materials: &mut Materials,
) -> Option<Mesh> {
    let transform = transform(to_world);
    let to_mesh = if transform.is_some() { DMat4::IDENTITY } else { to_world };
    let cofactors = cofactors(DMat3::from_mat4(to_mesh));
    // A mirror image has its outside where its corners go round the other way.
    let is_mirrored = to_mesh.determinant() < 0.0;
    let outwards = if is_mirrored { -1.0 } else { 1.0 };
    let (mut vertices, mut coordinates, mut normals) = (Vec::new(), Vec::new(), Vec::new());
    let mut triangles = Triangles::default();
    // Where the vertices of each accessor begin.
    let mut begun = HashMap::new();
    for part in parts.into_iter().filter(|part| !part.triangles.is_empty()) {
        let moved = |first: usize| {
            move |&[a, b, c]: &[u32; 3]| {
                let corners = if is_mirrored { [a, c, b] } else { [a, b, c] };
                corners.map(|index| index + first as u32)
            }
        };
        let some = |is_there: bool, first: usize| {
            let moved = moved(first);
            part.triangles.iter().map(move |t| is_there.then(|| moved(t)))
        };
        let is_textured = !part.texture_coordinates.is_empty();
        triangles.texture_coordinates.extend(some(is_textured, coordinates.len()));
        triangles.normals.extend(some(!part.normals.is_empty(), normals.len()));
        let first = *begun.entry(part.position).or_insert_with(|| {
            let place = |&v: &[f64; 3]| to_mesh.transform_point3(DVec3::from_array(v)).to_array();
            let first = vertices.len();
            vertices.extend(part.vertices.iter().map(place));
            first
        });
        triangles.vertices.extend(part.triangles.iter().map(moved(first)));
        triangles.materials.resize(triangles.vertices.len(), materials.place(part.material));
        let turn =
            |&normal: &[f64; 3]| (cofactors * DVec3::from_array(normal) * outwards).to_array();
        normals.extend(part.normals.iter().map(turn));
        coordinates.extend(part.texture_coordinates);
    }
    let mut builder = MeshBuilder::new(&vertices, &coordinates, &normals);
    let transform = transform.unwrap_or_default();
    (!triangles.vertices.is_empty()).then(|| builder.build(name, triangles).transform(transform))
}

/// What turns normals where the matrix moves points.
fn cofactors(DMat3 { x_axis, y_axis, z_axis }: DMat3) -> DMat3 {
    DMat3::from_cols(y_axis.cross(z_axis), z_axis.cross(x_axis), x_axis.cross(y_axis))
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
