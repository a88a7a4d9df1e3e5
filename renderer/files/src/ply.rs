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
use renderer_core::Error;

use super::meshes::Model;
use super::meshes::{
    FileNormals, MeshBuilder, Triangles, check_normal, default_model, triangulate,
};
use super::names::file_stem;
use crate::disk::read;
use crate::warning::Warnings;
use header::{Element, Header};
use source::{Kind, Source};

/// Reads a PLY file: one mesh, named after the file.
///
/// - Vertices are the properties `x`, `y` and `z` of the element `vertex`; faces the list
///   `vertex_indices` (or `vertex_index`) of the element `face`, or strips of triangles that list of
///   the element `tristrips`.
/// - The properties `u` and `v` of a vertex (or `s` and `t`, `texture_u` and `texture_v`) are its
///   texture coordinates; a scene file may give the mesh a material with a texture.
/// - Polygons are cut into triangles, concave ones too. A vertex that no face uses is left out.
/// - All triangles have [`DEFAULT_MATERIAL`](super::DEFAULT_MATERIAL).
/// - Colours, texture coordinates of faces, the comment `TextureFile` and other elements are left out
///   with a warning; whatever else there is without one. Normals of vertices (`nx`, `ny`, `nz`) are read
///   by [`load_mesh_with`](super::load_mesh_with) alone.
///
/// # Errors
///
/// If the file cannot be read, its header is broken, its data is cut short, a coordinate is not
/// finite, an index is out of range, or there is no triangle. The message names the file and the
/// line, or in binary data the element.
pub fn load_ply(path: &Path) -> Result<Model, Error> {
    read_ply(path, FileNormals::Ignore)
}

/// [`load_ply`], with the normals of vertices if they are wanted.
pub(crate) fn read_ply(path: &Path, normals: FileNormals) -> Result<Model, Error> {
    let bytes = read(path)?;
    let place = path.display().to_string();
    let mut warnings = Warnings::default();
    let Contents { vertices, texture_coordinates, normals, faces } =
        contents(&bytes, &place, normals, &mut warnings)?;
    let mut triangles: Vec<[u32; 3]> = Vec::new();
    for (index, face) in faces {
        let corners: Vec<DVec3> =
            face.iter().map(|&i| DVec3::from_array(vertices[i as usize])).collect();
        let cut = triangulate(&corners)
            .map_err(|problem| Error::new(&place, format!("face {index}: {problem}")))?;
        triangles.extend(cut.iter().map(|t| t.map(|corner| face[corner])));
    }
    if triangles.is_empty() {
        return Err(Error::new(place, "holds no triangles; its faces have fewer than 3 corners"));
    }
    // What vertices have goes by their indices.
    let of_vertices = |is_empty: bool| match is_empty {
        true => Vec::new(),
        false => triangles.iter().copied().map(Some).collect(),
    };
    let triangles = Triangles {
        texture_coordinates: of_vertices(texture_coordinates.is_empty()),
        normals: of_vertices(normals.is_empty()),
        materials: vec![0; triangles.len()],
        vertices: triangles,
    };
    let mut builder = MeshBuilder::new(&vertices, &texture_coordinates, &normals);
    let mesh = builder.build(file_stem(path), triangles);
    Ok(default_model(vec![mesh], warnings))
}

#[derive(Default)]
struct Contents {
    vertices: Vec<[f64; 3]>,
    /// One for each vertex, or none at all.
    texture_coordinates: Vec<[f64; 2]>,
    /// One for each vertex, or none at all.
    normals: Vec<[f64; 3]>,
    /// Which face it is, counted from 1, and its corners, all of them in range.
    faces: Vec<(u64, Vec<u32>)>,
}

fn contents(
    bytes: &[u8],
    place: &str,
    normals: FileNormals,
    warnings: &mut Warnings,
) -> Result<Contents, Error> {
    let (header, mut source) = header::read(bytes, place, warnings)?;
    let Header { elements, vertices: announced } = header;
    let mut contents = Contents::default();
    // A row of nothing takes no data, and its count may be anything.
    for element in elements.iter().filter(|element| !element.properties.is_empty()) {
        let texture_names = element.texture_names();
        let normal_names = match normals {
            FileNormals::Ignore => None,
            FileNormals::Read => element.normal_names(),
        };
        for row in 1..=element.count {
            let read = match element.name.as_str() {
                "vertex" => {
                    vertex(element, texture_names, normal_names, &mut source, &mut contents)
                }
                "face" => face(element, &mut source, announced)
                    .map(|face| contents.faces.extend(face.map(|face| (row, face)))),
                "tristrips" => strips(element, &mut source, announced)
                    .map(|triangles| contents.faces.extend(triangles.map(|face| (row, face)))),
                _ => skip(element, &mut source),
            };
            read.map_err(|problem| {
                Error::new(source.place(place), format!("{} {row}: {problem}", element.name))
            })?;
        }
    }
    Ok(contents)
}

/// Reads a vertex, and its texture coordinates and its normal if the names of these are given.
fn vertex(
    element: &Element,
    texture_names: Option<[&str; 2]>,
    normal_names: Option<[&str; 3]>,
    source: &mut Source<'_>,
    contents: &mut Contents,
) -> Result<(), String> {
    let (mut position, mut coordinates, mut normal) = ([0.0; 3], [0.0; 2], [0.0; 3]);
    for property in &element.properties {
        let Kind::Scalar(scalar) = property.kind else {
            source.list(property.kind)?;
            continue;
        };
        let value = source.number(scalar)?;
        let index = |names: &[&str]| names.iter().position(|name| *name == property.name);
        let texture_axis = texture_names.and_then(|names| index(&names));
        let normal_axis = normal_names.and_then(|names| index(&names));
        let target = match (index(&["x", "y", "z"]), texture_axis, normal_axis) {
            (Some(axis), ..) => &mut position[axis],
            (None, Some(axis), _) => &mut coordinates[axis],
            (None, None, Some(axis)) => &mut normal[axis],
            (None, None, None) => continue,
        };
        if !value.is_finite() {
            return Err(format!("{} is {value}, not a finite number", property.name));
        }
        *target = value;
    }
    contents.vertices.push(position);
    if texture_names.is_some() {
        contents.texture_coordinates.push(coordinates);
    }
    if normal_names.is_some() {
        check_normal(normal)?;
        contents.normals.push(normal);
    }
    Ok(())
}

/// The corners of a face; nothing if there are fewer than three, which is a point or a line.
fn face(
    element: &Element,
    source: &mut Source<'_>,
    vertices: u64,
) -> Result<Option<Vec<u32>>, String> {
    let corners = indices(&corner_list(element, source)?, vertices)?;
    Ok((corners.len() >= 3).then_some(corners))
}

/// The triangles of strips, one after the other in a list, each ended by -1. Every second triangle of a
/// strip turns the other way; those of less than three corners lead from one part of it to the next.
fn strips(
    element: &Element,
    source: &mut Source<'_>,
    vertices: u64,
) -> Result<impl Iterator<Item = Vec<u32>>, String> {
    let list = corner_list(element, source)?;
    let strips = list.split(|&index| index == -1.0).map(|strip| indices(strip, vertices));
    let strips: Vec<Vec<u32>> = strips.collect::<Result<_, _>>()?;
    Ok(strips.into_iter().flat_map(|strip| {
        let turned = |(i, t): (usize, &[u32])| match i % 2 {
            0 => vec![t[0], t[1], t[2]],
            _ => vec![t[1], t[0], t[2]],
        };
        let has_three = |t: &Vec<u32>| t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
        strip.windows(3).enumerate().map(turned).filter(has_three).collect::<Vec<_>>()
    }))
}

/// The list of corners among the properties of an element.
fn corner_list(element: &Element, source: &mut Source<'_>) -> Result<Vec<f64>, String> {
    let mut corners = Vec::new();
    for property in &element.properties {
        let values = source.list(property.kind)?;
        if header::is_corner_list(property) {
            corners = values;
        }
    }
    Ok(corners)
}

/// Indices of vertices, all of them in range.
fn indices(values: &[f64], vertices: u64) -> Result<Vec<u32>, String> {
    let index = |&value: &f64| {
        let in_range = value >= 0.0 && value < vertices as f64 && value <= f64::from(u32::MAX);
        let problem = || format!("names vertex {value} of {vertices}, counted from 0");
        in_range.then_some(value as u32).ok_or_else(problem)
    };
    values.iter().map(index).collect()
}

fn skip(element: &Element, source: &mut Source<'_>) -> Result<(), String> {
    element.properties.iter().try_for_each(|property| source.list(property.kind).map(|_| ()))
}
