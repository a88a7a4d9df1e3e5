//! Meshes: STL, ASCII and binary.
//!
//! The parser is our own: the format is a list of triangles, and it takes less to read it than to
//! check what another parser made of a broken file.

mod ascii;

#[cfg(test)]
mod tests;

use std::collections::HashMap;
use std::path::Path;

use renderer_core::Error;
use renderer_core::scene::Mesh;

use super::meshes::Model;
use super::meshes::default_model;
use super::names::file_stem;
use crate::disk::read;
use crate::warning::Warnings;

/// The bytes of the header of a binary file, with the number of triangles.
const HEADER: usize = 84;
/// The bytes of a triangle: a normal, three vertices, two bytes of anything.
const TRIANGLE: usize = 50;

/// Reads an STL file. What it is, its content decides: a file that is as long as its number of
/// triangles says is binary, another one that begins with `solid` and holds no byte 0 is ASCII.
///
/// - Every solid of an ASCII file is a mesh; a binary file is one, named after the file.
/// - Vertices with the same coordinates are one vertex. Normals are not read: the order of the
///   vertices says the same. Of the two bytes after each triangle of a binary file, in which some
///   programs keep colours, is warned unless they are 0.
/// - All triangles have [`DEFAULT_MATERIAL`](super::DEFAULT_MATERIAL).
///
/// # Errors
///
/// If the file cannot be read, is cut short, a line is broken, a coordinate is not finite, or there
/// is no triangle. The message names the file and the line or the triangle.
pub fn load_stl(path: &Path) -> Result<Model, Error> {
    let bytes = read(path)?;
    let place = path.display().to_string();
    let mut warnings = Warnings::default();
    let meshes = if is_ascii(&bytes) {
        ascii::meshes(&bytes, &place, &file_stem(path))?
    } else {
        vec![binary(&bytes, &place, file_stem(path), &mut warnings)?]
    };
    if meshes.is_empty() {
        return Err(Error::new(place, "holds no triangles"));
    }
    Ok(default_model(meshes, warnings))
}

fn is_ascii(bytes: &[u8]) -> bool {
    let as_long_as_said = announced(bytes)
        .is_some_and(|count| (count as usize).checked_mul(TRIANGLE) == Some(bytes.len() - HEADER));
    // Headers of binary files that begin so are filled up with zeros, which no text holds.
    let is_text = !bytes.contains(&0);
    !as_long_as_said && is_text && keyword(bytes).eq_ignore_ascii_case(b"solid")
}

/// The first five letters, after spaces and a byte order mark.
fn keyword(bytes: &[u8]) -> &[u8] {
    let bytes = bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(bytes).trim_ascii_start();
    &bytes[..bytes.len().min(5)]
}

/// The number of triangles that a binary file says it has.
fn announced(bytes: &[u8]) -> Option<u32> {
    let count = bytes.get(HEADER - 4..HEADER)?;
    Some(u32::from_le_bytes(count.try_into().ok()?))
}

fn binary(bytes: &[u8], place: &str, name: String, warnings: &mut Warnings) -> Result<Mesh, Error> {
    let refuse = |problem: String| Error::new(place, problem);
    let Some(count) = announced(bytes) else {
        return Err(refuse(
            "is no STL file: it is neither text that begins with `solid` nor has a header of 84 bytes"
                .to_owned(),
        ));
    };
    let body = &bytes[HEADER..];
    if (count as usize).checked_mul(TRIANGLE) != Some(body.len()) {
        return Err(refuse(format!(
            "says that it has {count} triangles, of {TRIANGLE} bytes each; after the header there are {} bytes",
            body.len()
        )));
    }
    if count == 0 {
        return Err(refuse("holds no triangles".to_owned()));
    }
    let mut builder = Builder::default();
    for (index, record) in body.chunks_exact(TRIANGLE).enumerate() {
        let (floats, _) = record[12..48].as_chunks::<4>();
        let mut corners = [[0.0; 3]; 3];
        for (value, float) in corners.as_flattened_mut().iter_mut().zip(floats) {
            let float = f32::from_le_bytes(*float);
            if !float.is_finite() {
                let problem = format!("triangle {}: {float} is not a finite number", index + 1);
                return Err(refuse(problem));
            }
            *value = f64::from(float);
        }
        if record[48..] != [0, 0] {
            let place = format_args!("{place}: triangle {}", index + 1);
            warnings.add("attribute", place, "the attribute bytes, often a colour, are left out");
        }
        builder.push(corners);
    }
    Ok(builder.finish(name))
}

/// Triangles of which equal vertices become one.
#[derive(Default)]
struct Builder {
    vertices: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
    places: HashMap<[u64; 3], u32>,
}

impl Builder {
    fn push(&mut self, corners: [[f64; 3]; 3]) {
        let triangle = corners.map(|corner| {
            // Adding 0 makes -0 and 0 one number.
            let key = corner.map(|x| (x + 0.0).to_bits());
            *self.places.entry(key).or_insert_with(|| {
                self.vertices.push(corner);
                self.vertices.len() as u32 - 1
            })
        });
        self.triangles.push(triangle);
    }

    fn is_empty(&self) -> bool {
        self.triangles.is_empty()
    }

    fn finish(self, name: String) -> Mesh {
        Mesh::new(name, self.vertices, self.triangles)
    }
}
