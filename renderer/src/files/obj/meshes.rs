//! From what tobj reads to meshes.

use std::path::Path;

use glam::DVec3;

use super::prepare::Prepared;
use crate::Error;
use crate::files::meshes::{MeshBuilder, triangulate};
use crate::files::names::Names;
use crate::scene::Mesh;

/// The objects of the file `file` that have faces.
pub(super) fn meshes(prepared: Prepared, file: &str) -> Result<Vec<Mesh>, Error> {
    let Prepared { text, faces, textured, .. } = prepared;
    // By default polygons stay whole, and texture coordinates have indices of their own.
    let options = tobj::LoadOptions::default();
    let no_library = |_: &Path| Err(tobj::LoadError::OpenFileFailed);
    let (models, _) = tobj::load_obj_buf(&mut text.drain(), &options, no_library)
        .map_err(|error| Error::new(file, error))?;

    let mut meshes = Vec::new();
    let mut names = Names::default();
    // tobj keeps the order of the faces, so each object takes the next ones.
    let (mut faces, mut textured) = (faces.into_iter(), &textured[..]);
    for tobj::Model { mesh, name } in models {
        if mesh.indices.is_empty() {
            continue;
        }
        let positions = mesh.positions.as_chunks().0;
        // Triangles alone have no arities.
        let arities = match mesh.face_arities.is_empty() {
            true => vec![3; mesh.indices.len() / 3],
            false => mesh.face_arities,
        };
        let (mut triangles, mut texture_triangles) = (Vec::new(), Vec::new());
        let mut materials = Vec::new();
        let mut first = 0;
        for (arity, face) in arities.into_iter().zip(faces.by_ref()) {
            let corners = &mesh.indices[first..][..arity as usize];
            let cut = match corners.len() {
                3 => vec![[0, 1, 2]],
                _ => {
                    let corner = |&i: &u32| DVec3::from_array(positions[i as usize]);
                    triangulate(&corners.iter().map(corner).collect::<Vec<_>>())
                        .map_err(|problem| Error::new(format!("{file}:{}", face.line), problem))?
                }
            };
            for triangle in cut {
                triangles.push(triangle.map(|i| corners[i]));
                let is_textured = triangle.iter().all(|i| textured[first + i]);
                let texture = || triangle.map(|i| mesh.texcoord_indices[first + i]);
                texture_triangles.push(is_textured.then(texture));
                materials.push(face.material);
            }
            first += corners.len();
        }
        textured = &textured[first..];
        // Of the texture coordinates that tobj makes up none are left.
        let mesh = MeshBuilder::new(positions, mesh.texcoords.as_chunks().0).build(
            names.take(name),
            triangles,
            texture_triangles,
            materials,
        );
        meshes.push(mesh);
    }
    Ok(meshes)
}
