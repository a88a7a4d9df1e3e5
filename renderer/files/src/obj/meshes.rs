//! From what tobj reads to meshes.

use std::path::Path;

use glam::DVec3;
use renderer_core::Error;
use renderer_core::scene::Mesh;

use super::face::Corner;
use super::prepare::Prepared;
use crate::meshes::{MeshBuilder, Triangles, triangulate};
use crate::names::Names;

/// The objects of the file `file` that have faces.
pub(super) fn meshes(prepared: Prepared, file: &str) -> Result<Vec<Mesh>, Error> {
    let Prepared { text, faces, corners, .. } = prepared;
    // By default polygons stay whole, and texture coordinates have indices of their own.
    let options = tobj::LoadOptions::default();
    let no_library = |_: &Path| Err(tobj::LoadError::OpenFileFailed);
    let (models, _) = tobj::load_obj_buf(&mut text.drain(), &options, no_library)
        .map_err(|error| Error::new(file, error))?;

    let mut meshes = Vec::new();
    let mut names = Names::default();
    // tobj keeps the order of the faces, so each object takes the next ones.
    let (mut faces, mut has) = (faces.into_iter(), &corners[..]);
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
        let mut triangles = Triangles::default();
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
                triangles.vertices.push(triangle.map(|i| corners[i]));
                let all_have =
                    |is: fn(&Corner) -> bool| triangle.iter().all(|i| is(&has[first + i]));
                let places = || triangle.map(|i| mesh.texcoord_indices[first + i]);
                let places = all_have(|corner| corner.is_textured).then(places);
                triangles.texture_coordinates.push(places);
                let normals = || triangle.map(|i| mesh.normal_indices[first + i]);
                triangles.normals.push(all_have(|corner| corner.has_normal).then(normals));
                triangles.materials.push(face.material);
            }
            first += corners.len();
        }
        has = &has[first..];
        // Of what tobj makes up nothing is left.
        let (places, normals) = (mesh.texcoords.as_chunks().0, mesh.normals.as_chunks().0);
        let mut builder = MeshBuilder::new(positions, places, normals);
        meshes.push(builder.build(names.take(name), triangles));
    }
    Ok(meshes)
}
