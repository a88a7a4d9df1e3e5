//! Writes a mesh as OBJ.

use std::fmt::Write;
use std::path::Path;

use crate::Error;
use crate::disk::write_atomically;
use crate::scene::{MaterialObject, Mesh};

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
    let textured = mesh.texture_triangles.iter().flatten().flatten();
    if textured.copied().any(|i| i as usize >= mesh.texture_coordinates.len())
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
    let mut worn = None;
    let triangles = mesh.materials.iter().zip(&mesh.triangles).enumerate();
    for (triangle, (&material, corners)) in triangles {
        if worn != Some(material) {
            let name = &materials.get(material as usize).ok_or_else(out_of_range)?.name;
            push(&mut text, format_args!("usemtl {name}\n"));
            worn = Some(material);
        }
        let [a, b, c] = corners.map(|i| u64::from(i) + 1);
        match mesh.texture_triangles.get(triangle).copied().flatten() {
            None => push(&mut text, format_args!("f {a} {b} {c}\n")),
            Some(corners) => {
                let [u, v, w] = corners.map(|i| u64::from(i) + 1);
                push(&mut text, format_args!("f {a}/{u} {b}/{v} {c}/{w}\n"));
            }
        }
    }
    write_atomically(path, text.as_bytes())
}

fn push(text: &mut String, line: std::fmt::Arguments<'_>) {
    // Writing to a string cannot fail.
    let _ = text.write_fmt(line);
}
