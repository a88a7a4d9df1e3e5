//! Checks an OBJ file statement by statement and leaves to tobj what it reads safely.

use std::collections::HashMap;

use renderer_core::Error;

use super::chunks::Chunks;
use super::face::{Corner, Counts, prepare_face};
use super::statements::{Statement, number, statements, words};
use crate::meshes::DEFAULT_MATERIAL;
use crate::meshes::{FileNormals, FileObjects, check_normal};
use crate::warning::Warnings;

/// An OBJ file, checked.
#[derive(Default)]
pub(super) struct Prepared {
    /// For tobj: objects, vertices, texture coordinates, normals if they are wanted, and faces; no more.
    pub text: Chunks,
    /// The faces of the file in order.
    pub faces: Vec<Face>,
    /// For each corner of each face what it has: what it does not have, tobj makes up.
    pub corners: Vec<Corner>,
    /// The names of the materials in order of their first use, and the line of that.
    pub materials: Vec<(String, usize)>,
    /// What stands after each `mtllib`, and its line.
    pub libraries: Vec<(String, usize)>,
}

/// What tobj does not tell of a face.
pub(super) struct Face {
    /// Counted from 1.
    pub line: usize,
    /// An index into the materials of the file.
    pub material: u32,
}

/// Checks the text of the file `file`; unnamed objects are called `stem`.
pub(super) fn prepare(
    text: &str,
    file: &str,
    stem: &str,
    (normals, objects): (FileNormals, FileObjects),
    warnings: &mut Warnings,
) -> Result<Prepared, Error> {
    let has_objects = statements(text).any(|statement| statement.keyword == "o");
    let mut prepared = Prepared::default();
    prepared.text.line().extend(["o ", stem, "\n"]);
    let mut counts = Counts::default();
    let mut assigned = CurrentMaterial::default();
    for Statement { line, keyword, rest } in statements(text) {
        let refuse = |problem: String| Error::new(format!("{file}:{line}"), problem);
        let mut warn =
            |problem: &str| warnings.add(keyword, format_args!("{file}:{line}"), problem);
        match keyword {
            "v" => {
                let has_color = prepare_vertex(&rest, prepared.text.line()).map_err(refuse)?;
                counts.vertices = one_more(counts.vertices).map_err(refuse)?;
                if has_color {
                    warn("the colours of vertices are left out");
                }
            }
            "vt" => {
                prepare_texture_coordinates(&rest, prepared.text.line()).map_err(refuse)?;
                counts.texture_coordinates =
                    one_more(counts.texture_coordinates).map_err(refuse)?;
            }
            "vn" => {
                if normals == FileNormals::Read {
                    prepare_normal(&rest, prepared.text.line()).map_err(refuse)?;
                }
                counts.normals = one_more(counts.normals).map_err(refuse)?;
            }
            "f" => {
                let Prepared { text, faces, corners, materials, .. } = &mut prepared;
                prepare_face(&rest, &counts, normals, text.line(), corners).map_err(refuse)?;
                faces.push(Face { line, material: assigned.index(materials, line) });
            }
            "usemtl" if rest.is_empty() => {
                warn("`usemtl` names no material; the faces after it are grey");
                assigned = CurrentMaterial {
                    name: DEFAULT_MATERIAL.to_owned(),
                    indices: assigned.indices,
                };
            }
            "usemtl" => {
                assigned = CurrentMaterial { name: rest.into_owned(), indices: assigned.indices }
            }
            "mtllib" => prepared.libraries.push((rest.into_owned(), line)),
            "o" | "g" if (keyword == "o") == has_objects && objects == FileObjects::Apart => {
                let name = if rest.is_empty() { stem } else { &rest };
                prepared.text.line().extend(["o ", name, "\n"]);
            }
            // Which edges are smooth does not depend on smoothing groups.
            "o" | "g" | "s" => {}
            "l" | "p" => warn(&format!("`{keyword}` is left out: only faces (`f`) are shown")),
            _ => warn(&format!("`{keyword}` is left out: it is no statement that is read here")),
        }
    }
    Ok(prepared)
}

/// The material of the faces from here on.
struct CurrentMaterial {
    name: String,
    /// Of all names so far of a face.
    indices: HashMap<String, u32>,
}

impl Default for CurrentMaterial {
    fn default() -> Self {
        Self { name: DEFAULT_MATERIAL.to_owned(), indices: HashMap::new() }
    }
}

impl CurrentMaterial {
    /// The index of the material, which a face has in this line.
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

/// Appends the three coordinates, and the weight if there is one; tells whether a colour follows,
/// which is left out.
fn prepare_vertex(rest: &str, text: &mut String) -> Result<bool, String> {
    let mut words = words(rest);
    text.push('v');
    let position = prepare_vector(&mut words, "vertex", text)?;
    let fourth = words.next();
    let has_color = words.next().is_some();
    if let Some(word) = fourth.filter(|_| !has_color) {
        let weight = number(word)?;
        if !position.iter().all(|coordinate| (coordinate / weight).is_finite()) {
            return Err(format!("the weight {weight:?} takes the vertex to infinity"));
        }
        text.extend([" ", word]);
    }
    text.push('\n');
    Ok(has_color)
}

/// Appends a normal.
fn prepare_normal(rest: &str, text: &mut String) -> Result<(), String> {
    text.push_str("vn");
    let normal = prepare_vector(&mut words(rest), "normal", text)?;
    text.push('\n');
    check_normal(normal)
}

/// Appends the next three words, the coordinates of a `kind` of thing.
fn prepare_vector<'a>(
    words: &mut impl Iterator<Item = &'a str>,
    kind: &str,
    text: &mut String,
) -> Result<[f64; 3], String> {
    let mut vector = [0.0; 3];
    for (i, value) in vector.iter_mut().enumerate() {
        let word =
            words.next().ok_or_else(|| format!("a {kind} has 3 coordinates, this one {i}"))?;
        *value = number(word)?;
        text.extend([" ", word]);
    }
    Ok(vector)
}

/// Appends the first two texture coordinates; a third one is for textures that fill space.
fn prepare_texture_coordinates(rest: &str, text: &mut String) -> Result<(), String> {
    let mut words = words(rest);
    let u = words.next().ok_or("vt holds no texture coordinates")?;
    // By the standard v may be left out.
    let v = words.next().unwrap_or("0");
    number(u)?;
    number(v)?;
    text.extend(["vt ", u, " ", v, "\n"]);
    Ok(())
}
