//! Writes meshes as OBJ.

use std::fmt::Write;
use std::path::Path;

use renderer_core::Error;
use renderer_core::scene::{MaterialObject, Mesh, Normals};

use crate::disk::write_atomically;

/// Writes one mesh as an OBJ file, its materials by name without a library. Coordinates are written
/// with as many digits as it takes to read the same numbers back.
///
/// Vertices are those before the transform of the mesh; `materials` are what its indices refer to.
///
/// # Errors
///
/// If an index is out of range, or the file cannot be written.
pub fn save_obj(mesh: &Mesh, materials: &[MaterialObject], path: &Path) -> Result<(), Error> {
    let mut text = String::new();
    push_object(&mut text, mesh, materials, &mut Counts::default())
        .ok_or_else(|| Error::new(path.display(), format!("mesh {} is inconsistent", mesh.name)))?;
    write_atomically(path, text.as_bytes())
}

/// How many vertices, texture coordinates and normals a file has so far.
#[derive(Default)]
pub(super) struct Counts {
    vertices: usize,
    texture_coordinates: usize,
    normals: usize,
}

/// Appends a mesh, as it is before its transform; nothing if an index is out of range.
pub(super) fn push_object(
    text: &mut String,
    mesh: &Mesh,
    materials: &[MaterialObject],
    before: &mut Counts,
) -> Option<()> {
    let some = |triangles: &[Option<[u32; 3]>], count: usize| {
        triangles.iter().flatten().flatten().all(|&i| (i as usize) < count)
    };
    let (directions, normal_triangles) = match &mesh.normals {
        Normals::Given { directions, triangles } => (&directions[..], &triangles[..]),
        Normals::Flat | Normals::Smooth => (&[][..], &[][..]),
    };
    if !some(&mesh.texture_triangles, mesh.texture_coordinates.len())
        || !some(normal_triangles, directions.len())
        || mesh.triangles.as_flattened().iter().any(|&i| i as usize >= mesh.vertices.len())
        || mesh.materials.len() != mesh.triangles.len()
    {
        return None;
    }
    push(text, format_args!("o {}\n", mesh.name));
    for [x, y, z] in &mesh.vertices {
        push(text, format_args!("v {x:?} {y:?} {z:?}\n"));
    }
    for [u, v] in &mesh.texture_coordinates {
        push(text, format_args!("vt {u:?} {v:?}\n"));
    }
    for [x, y, z] in directions {
        push(text, format_args!("vn {x:?} {y:?} {z:?}\n"));
    }
    let mut assigned = None;
    let triangles = mesh.materials.iter().zip(&mesh.triangles).enumerate();
    for (triangle, (&material, corners)) in triangles {
        if assigned != Some(material) {
            let name = &materials.get(material as usize)?.name;
            push(text, format_args!("usemtl {name}\n"));
            assigned = Some(material);
        }
        text.push('f');
        for corner in 0..3 {
            let index = |corners: [u32; 3], before| before + corners[corner] as usize + 1;
            let of = |triangles: &[Option<[u32; 3]>], before| {
                triangles.get(triangle).copied().flatten().map(|corners| index(corners, before))
            };
            let vertex = index(*corners, before.vertices);
            let place = of(&mesh.texture_triangles, before.texture_coordinates);
            match (place, of(normal_triangles, before.normals)) {
                (None, None) => push(text, format_args!(" {vertex}")),
                (Some(place), None) => push(text, format_args!(" {vertex}/{place}")),
                (None, Some(normal)) => push(text, format_args!(" {vertex}//{normal}")),
                (Some(place), Some(normal)) => {
                    push(text, format_args!(" {vertex}/{place}/{normal}"));
                }
            }
        }
        text.push('\n');
    }
    before.vertices += mesh.vertices.len();
    before.texture_coordinates += mesh.texture_coordinates.len();
    before.normals += directions.len();
    Some(())
}

pub(super) fn push(text: &mut String, line: std::fmt::Arguments<'_>) {
    // Writing to a string cannot fail.
    let _ = text.write_fmt(line);
}
