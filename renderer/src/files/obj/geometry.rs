//! The shapes of an OBJ file, and what it names.

use std::collections::HashMap;

use glam::DVec3;

use super::face::{Counts, Face};
use super::statements::{Statement, number, statements, words};
use crate::Error;
use crate::files::meshes::triangulate;
use crate::files::model::DEFAULT_MATERIAL;
use crate::files::warnings::Warnings;

/// What an OBJ file says, indices resolved.
#[derive(Default)]
pub(super) struct Geometry {
    pub vertices: Vec<[f64; 3]>,
    pub texture_coordinates: Vec<[f64; 2]>,
    /// Its objects in order, at least one; some may have no triangles.
    pub objects: Vec<Object>,
    /// The names of the materials in order of their first use, and the line of that.
    pub materials: Vec<(String, usize)>,
    /// What stands after each `mtllib`, and its line.
    pub libraries: Vec<(String, usize)>,
}

/// The triangles of an object.
#[derive(Default)]
pub(super) struct Object {
    pub name: String,
    /// Indices of vertices.
    pub triangles: Vec<[u32; 3]>,
    /// Indices of texture coordinates, if all three corners have some.
    pub texture_triangles: Vec<Option<[u32; 3]>>,
    /// For each triangle an index into the materials of the file.
    pub materials: Vec<u32>,
}

/// Reads the text of the file `file`; unnamed objects are called `stem`.
pub(super) fn read(
    text: &str,
    file: &str,
    stem: &str,
    warnings: &mut Warnings,
) -> Result<Geometry, Error> {
    let has_objects = statements(text).any(|statement| statement.keyword == "o");
    let object = |name: &str| {
        let name = if name.is_empty() { stem } else { name };
        Object { name: name.to_owned(), ..Object::default() }
    };
    let mut geometry = Geometry { objects: vec![object("")], ..Geometry::default() };
    let mut counts = Counts::default();
    let mut worn = Worn::default();
    let mut face = Face::default();
    for Statement { line, keyword, rest } in statements(text) {
        let refuse = |problem: String| Error::new(format!("{file}:{line}"), problem);
        let mut warn =
            |problem: &str| warnings.add(keyword, format_args!("{file}:{line}"), problem);
        match keyword {
            "v" => {
                let (vertex, has_color) = vertex(&rest).map_err(refuse)?;
                counts.vertices = one_more(counts.vertices).map_err(refuse)?;
                geometry.vertices.push(vertex);
                if has_color {
                    warn("the colours of vertices are left out");
                }
            }
            "vt" => {
                let coordinates = texture_coordinates(&rest).map_err(refuse)?;
                counts.texture_coordinates =
                    one_more(counts.texture_coordinates).map_err(refuse)?;
                geometry.texture_coordinates.push(coordinates);
            }
            "vn" => counts.normals = one_more(counts.normals).map_err(refuse)?,
            "f" => {
                face.read(&rest, &counts).map_err(refuse)?;
                let material = worn.index(&mut geometry.materials, line);
                geometry.add(&face, material).map_err(refuse)?;
            }
            "usemtl" if rest.is_empty() => {
                return Err(refuse("usemtl names no material".to_owned()));
            }
            "usemtl" => worn = Worn { name: rest.into_owned(), indices: worn.indices },
            "mtllib" => geometry.libraries.push((rest.into_owned(), line)),
            "o" | "g" if (keyword == "o") == has_objects => geometry.objects.push(object(&rest)),
            // Triangles are flat shaded whatever their smoothing group.
            "o" | "g" | "s" => {}
            "l" | "p" => warn(&format!("`{keyword}` is left out: only faces (`f`) are shown")),
            _ => warn(&format!("`{keyword}` is left out: it is no statement that is read here")),
        }
    }
    Ok(geometry)
}

impl Geometry {
    /// Adds a face, cut into triangles, to the latest object.
    fn add(&mut self, face: &Face, material: u32) -> Result<(), String> {
        let Face { vertices, texture } = face;
        let cut = match vertices.len() {
            3 => vec![[0, 1, 2]],
            _ => {
                let corner = |&i: &u32| DVec3::from_array(self.vertices[i as usize]);
                triangulate(&vertices.iter().map(corner).collect::<Vec<_>>())?
            }
        };
        let Some(object) = self.objects.last_mut() else { return Ok(()) };
        for [a, b, c] in cut {
            object.triangles.push([vertices[a], vertices[b], vertices[c]]);
            let corners = texture[a].zip(texture[b]).zip(texture[c]);
            object.texture_triangles.push(corners.map(|((a, b), c)| [a, b, c]));
            object.materials.push(material);
        }
        Ok(())
    }
}

/// The material that faces wear from here on.
struct Worn {
    name: String,
    /// Of all names so far that a face has worn.
    indices: HashMap<String, u32>,
}

impl Default for Worn {
    fn default() -> Self {
        Self { name: DEFAULT_MATERIAL.to_owned(), indices: HashMap::new() }
    }
}

impl Worn {
    /// The index of the material, which a face wears in this line.
    fn index(&mut self, materials: &mut Vec<(String, usize)>, line: usize) -> u32 {
        if let Some(&index) = self.indices.get(&self.name) {
            return index;
        }
        let index = materials.len() as u32;
        materials.push((self.name.clone(), line));
        self.indices.insert(self.name.clone(), index);
        index
    }
}

fn one_more(count: u32) -> Result<u32, String> {
    count.checked_add(1).ok_or_else(|| format!("more than {} of a kind are not read", u32::MAX))
}

/// The three coordinates, divided by the weight if there is one; and whether a colour follows.
fn vertex(rest: &str) -> Result<([f64; 3], bool), String> {
    let mut position = [0.0; 3];
    let mut words = words(rest);
    for (i, value) in position.iter_mut().enumerate() {
        let word =
            words.next().ok_or_else(|| format!("a vertex has 3 coordinates, this one {i}"))?;
        *value = number(word)?;
    }
    let Some(fourth) = words.next() else { return Ok((position, false)) };
    if words.next().is_some() {
        return Ok((position, true));
    }
    let weight = number(fourth)?;
    let weighted = position.map(|coordinate| coordinate / weight);
    match weighted.iter().all(|coordinate| coordinate.is_finite()) {
        true => Ok((weighted, false)),
        false => Err(format!("the weight {weight:?} takes the vertex to infinity")),
    }
}

/// The first two texture coordinates; a third one is for textures that fill space.
fn texture_coordinates(rest: &str) -> Result<[f64; 2], String> {
    let mut words = words(rest);
    let u = number(words.next().ok_or("vt holds no texture coordinates")?)?;
    // By the standard v may be left out.
    let v = words.next().map_or(Ok(0.0), number)?;
    Ok([u, v])
}
