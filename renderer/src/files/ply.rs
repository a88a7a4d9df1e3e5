//! Meshes: PLY, ASCII and binary of either byte order.
//!
//! The parser is our own: general ones build a map of properties for every vertex, and trust the
//! counts of the header when they allocate. This one reads what a mesh needs, and never believes a
//! count before the data is there.

mod header;
mod source;

#[cfg(test)]
mod tests;

use std::path::Path;

use glam::DVec3;

use super::io::read;
use super::meshes::{build_mesh, default_model, file_stem, triangulate};
use super::obj::Model;
use crate::Error;
use header::{Element, Header, Kind};
use source::Source;

/// A face may have so many corners: cutting up one that is not convex takes long.
const MOST_CORNERS: usize = 1000;

/// Reads a PLY file: one mesh, named after the file.
///
/// - Vertices are the properties `x`, `y` and `z` of the element `vertex`; faces the list
///   `vertex_indices` (or `vertex_index`) of the element `face`. Everything else, colours, normals
///   and texture coordinates among it, is skipped.
/// - Polygons are cut into triangles, concave ones too. A vertex that no face uses is left out.
/// - All triangles wear [`DEFAULT_MATERIAL`](super::obj::DEFAULT_MATERIAL).
///
/// # Errors
///
/// If the file cannot be read, its header is broken, its data is cut short, a coordinate is not
/// finite, an index is out of range, or there is no triangle. The message names the file and the
/// line, or in binary data the element.
pub fn load_ply(path: &Path) -> Result<Model, Error> {
    let bytes = read(path)?;
    let place = path.display().to_string();
    let (vertices, faces) = contents(&bytes, &place)?;
    let mut triangles: Vec<[u32; 3]> = Vec::new();
    for face in &faces {
        let corners: Vec<DVec3> =
            face.iter().map(|&i| DVec3::from_array(vertices[i as usize])).collect();
        triangles.extend(triangulate(&corners).iter().map(|t| t.map(|corner| face[corner])));
    }
    if triangles.is_empty() {
        return Err(Error::new(place, "holds no triangles; its faces have fewer than 3 corners"));
    }
    let materials = vec![0; triangles.len()];
    let mesh = build_mesh(file_stem(path), &vertices, triangles, materials);
    Ok(default_model(vec![mesh], place))
}

type Contents = (Vec<[f64; 3]>, Vec<Vec<u32>>);

/// The vertices, and the indices of each face, all of them in range.
fn contents(bytes: &[u8], place: &str) -> Result<Contents, Error> {
    let (header, mut source) = header::read(bytes, place)?;
    let Header { elements, vertices: announced } = header;
    let mut vertices = Vec::new();
    let mut faces = Vec::new();
    // A row of nothing takes no data, and its count may be anything.
    for element in elements.iter().filter(|element| !element.properties.is_empty()) {
        for row in 1..=element.count {
            let read = match element.name.as_str() {
                "vertex" => vertex(element, &mut source).map(|vertex| vertices.push(vertex)),
                "face" => face(element, &mut source, announced).map(|face| faces.extend(face)),
                _ => skip(element, &mut source),
            };
            read.map_err(|problem| {
                Error::new(source.place(place), format!("{} {row}: {problem}", element.name))
            })?;
        }
    }
    Ok((vertices, faces))
}

fn vertex(element: &Element, source: &mut Source<'_>) -> Result<[f64; 3], String> {
    let mut vertex = [0.0; 3];
    for property in &element.properties {
        let Kind::Scalar(scalar) = property.kind else {
            source.list(property.kind)?;
            continue;
        };
        let value = source.number(scalar)?;
        if let Some(axis) = ["x", "y", "z"].iter().position(|axis| *axis == property.name) {
            if !value.is_finite() {
                return Err(format!("{} is {value}, not a finite number", property.name));
            }
            vertex[axis] = value;
        }
    }
    Ok(vertex)
}

/// The corners of a face; nothing if there are fewer than three, which is a point or a line.
fn face(
    element: &Element,
    source: &mut Source<'_>,
    vertices: u64,
) -> Result<Option<Vec<u32>>, String> {
    let mut face = None;
    for property in &element.properties {
        let values = source.list(property.kind)?;
        if !header::is_corner_list(property) {
            continue;
        }
        if values.len() > MOST_CORNERS {
            return Err(format!("has {} corners; at most {MOST_CORNERS} are read", values.len()));
        }
        let index = |value: f64| {
            let in_range = value >= 0.0 && value < vertices as f64 && value <= f64::from(u32::MAX);
            let problem = || format!("names vertex {value} of {vertices}, counted from 0");
            in_range.then_some(value as u32).ok_or_else(problem)
        };
        let corners: Vec<u32> = values.into_iter().map(index).collect::<Result<_, _>>()?;
        face = (corners.len() >= 3).then_some(corners);
    }
    Ok(face)
}

fn skip(element: &Element, source: &mut Source<'_>) -> Result<(), String> {
    element.properties.iter().try_for_each(|property| source.list(property.kind).map(|_| ()))
}
