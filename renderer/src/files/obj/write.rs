//! Writes a mesh as OBJ.

use std::fmt::Write;
use std::path::Path;

use crate::Error;
use crate::disk::write_atomically;
use crate::scene::{MaterialObject, Mesh, Normals};

/// Writes one mesh as an OBJ file, its materials by name without a library. Coordinates are written
/// with as many digits as it takes to read the same numbers back.
///
/// Vertices are those before the transform of the mesh; `materials` are what its indices refer to.
///
/// # Errors
///
/// If an index is out of range, or the file cannot be written.
pub fn save_obj(mesh: &Mesh, materials: &[MaterialObject], path: &Path) -> Result<(), Error> {
    let out_of_range = || Error::new(path.display(), format!("mesh {} is inconsistent", mesh.name));
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
        return Err(out_of_range());
    }
    let mut text = format!("o {}\n", mesh.name);
    for [x, y, z] in &mesh.vertices {
        push(&mut text, format_args!("v {x:?} {y:?} {z:?}\n"));
    }
    for [u, v] in &mesh.texture_coordinates {
        push(&mut text, format_args!("vt {u:?} {v:?}\n"));
    }
    for [x, y, z] in directions {
        push(&mut text, format_args!("vn {x:?} {y:?} {z:?}\n"));
    }
    let mut assigned = None;
    let triangles = mesh.materials.iter().zip(&mesh.triangles).enumerate();
    for (triangle, (&material, corners)) in triangles {
        if assigned != Some(material) {
            let name = &materials.get(material as usize).ok_or_else(out_of_range)?.name;
            push(&mut text, format_args!("usemtl {name}\n"));
            assigned = Some(material);
        }
        text.push('f');
        for corner in 0..3 {
            let index = |corners: [u32; 3]| u64::from(corners[corner]) + 1;
            let of = |triangles: &[Option<[u32; 3]>]| {
                triangles.get(triangle).copied().flatten().map(index)
            };
            let vertex = index(*corners);
            match (of(&mesh.texture_triangles), of(normal_triangles)) {
                (None, None) => push(&mut text, format_args!(" {vertex}")),
                (Some(place), None) => push(&mut text, format_args!(" {vertex}/{place}")),
                (None, Some(normal)) => push(&mut text, format_args!(" {vertex}//{normal}")),
                (Some(place), Some(normal)) => {
                    push(&mut text, format_args!(" {vertex}/{place}/{normal}"));
                }
            }
        }
        text.push('\n');
    }
    write_atomically(path, text.as_bytes())
}

fn push(text: &mut String, line: std::fmt::Arguments<'_>) {
    // Writing to a string cannot fail.
    let _ = text.write_fmt(line);
}
