//! Checks an OBJ file line by line and leaves to tobj what it reads safely.
//!
//! tobj 4.0 would overflow on a texture index before the first, draw polylines as triangles, drop
//! materials it does not know, split objects by material, and tell no line numbers.

use std::collections::HashMap;

use super::DEFAULT_MATERIAL;
use crate::Error;

/// An OBJ file, checked.
pub(super) struct Prepared {
    /// For tobj: objects, vertices and faces; no more.
    pub text: String,
    /// For each triangle, in the order of the file, an index into `materials`.
    pub triangle_materials: Vec<u32>,
    /// The texture coordinates of the file.
    pub texture_coordinates: Vec<[f64; 2]>,
    /// For each triangle, in the order of the file, indices into `texture_coordinates`, if all three
    /// corners have some.
    pub texture_triangles: Vec<Option<[u32; 3]>>,
    /// The names of the materials in order of their first use, and the line of that.
    pub materials: Vec<(String, usize)>,
    /// What stands after each `mtllib`, and its line.
    pub libraries: Vec<(String, usize)>,
}

/// Checks the text of the file `file`; unnamed objects are called `stem`.
pub(super) fn prepare(text: &str, file: &str, stem: &str) -> Result<Prepared, Error> {
    let has_objects = statements(text).any(|statement| statement.keyword == "o");
    let mut prepared = Prepared {
        text: format!("o {stem}\n"),
        triangle_materials: Vec::new(),
        texture_coordinates: Vec::new(),
        texture_triangles: Vec::new(),
        materials: Vec::new(),
        libraries: Vec::new(),
    };
    let mut counts = Counts::default();
    let mut material_indices: HashMap<String, u32> = HashMap::new();
    let mut material = DEFAULT_MATERIAL.to_owned();
    for Statement { line, keyword, rest } in statements(text) {
        let refuse = |problem: String| Error::new(format!("{file}:{line}"), problem);
        match keyword {
            "v" => {
                counts.vertices += 1;
                let numbers = vertex(&rest).map_err(refuse)?;
                prepared.text.push_str(&format!("v {numbers}\n"));
            }
            "vt" => {
                counts.texture_coordinates += 1;
                prepared.texture_coordinates.push(texture_coordinates(&rest).map_err(refuse)?);
            }
            "vn" => counts.normals += 1,
            "f" => {
                let Face { vertices: corners, texture } = face(&rest, &counts).map_err(refuse)?;
                let next = material_indices.len() as u32;
                let index = *material_indices.entry(material.clone()).or_insert_with(|| {
                    prepared.materials.push((material.clone(), line));
                    next
                });
                let triangles = corners.len() - 2;
                prepared.triangle_materials.extend(std::iter::repeat_n(index, triangles));
                // A fan, as tobj makes one of the vertices.
                prepared.texture_triangles.extend((0..triangles).map(|i| {
                    let corner = |corner: usize| texture.get(corner).copied().flatten();
                    Some([corner(0)?, corner(i + 1)?, corner(i + 2)?])
                }));
                prepared.text.push_str(&format!("f {}\n", corners.join(" ")));
            }
            "usemtl" if rest.is_empty() => {
                return Err(refuse("usemtl names no material".to_owned()));
            }
            "usemtl" => material = rest,
            "mtllib" => prepared.libraries.push((rest, line)),
            "o" | "g" if (keyword == "o") == has_objects => {
                let name = if rest.is_empty() { stem } else { &rest };
                prepared.text.push_str(&format!("o {name}\n"));
            }
            _ => {}
        }
    }
    Ok(prepared)
}

/// How many elements the file has defined so far.
#[derive(Default)]
struct Counts {
    vertices: i64,
    texture_coordinates: i64,
    normals: i64,
}

/// A line: a keyword and what follows it.
pub(super) struct Statement<'a> {
    /// Counted from 1.
    pub line: usize,
    pub keyword: &'a str,
    /// Trimmed.
    pub rest: String,
}

/// The statements of an OBJ or MTL file. Vertices and faces may go on over several lines, each but
/// the last of which ends in a backslash.
pub(super) fn statements(text: &str) -> impl Iterator<Item = Statement<'_>> {
    let mut lines = text.lines().map(str::trim).enumerate();
    std::iter::from_fn(move || {
        let (index, first) = lines.next()?;
        let (keyword, rest) = first.split_once(char::is_whitespace).unwrap_or((first, ""));
        let mut rest = rest.trim().to_owned();
        while matches!(keyword, "v" | "f") && rest.ends_with('\\') {
            rest.pop();
            rest.push(' ');
            rest.push_str(lines.next().map_or("", |(_, line)| line));
        }
        Some(Statement { line: index + 1, keyword, rest })
    })
}

/// The words up to a comment.
pub(super) fn words(rest: &str) -> impl Iterator<Item = &str> {
    rest.split_whitespace().take_while(|word| !word.starts_with('#'))
}

/// A finite number.
pub(super) fn number(word: &str) -> Result<f64, String> {
    match word.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(_) => Err(format!("`{word}` is not a finite number")),
        Err(_) => Err(format!("`{word}` is not a number")),
    }
}

/// The three coordinates, and the weight if there is one; colours are left out.
fn vertex(rest: &str) -> Result<String, String> {
    let words: Vec<&str> = words(rest).collect();
    if words.len() < 3 {
        return Err(format!("a vertex has 3 coordinates, this one {}", words.len()));
    }
    let used = if words.len() == 4 { &words[..] } else { &words[..3] };
    let values = used.iter().map(|word| number(word)).collect::<Result<Vec<_>, _>>()?;
    if let Some(&weight) = values.get(3)
        && !values[..3].iter().all(|coordinate| (coordinate / weight).is_finite())
    {
        return Err(format!("the weight {weight:?} takes the vertex to infinity"));
    }
    Ok(used.join(" "))
}

/// The first two texture coordinates; a third one is for textures that fill space.
fn texture_coordinates(rest: &str) -> Result<[f64; 2], String> {
    let values = words(rest).take(2).map(number).collect::<Result<Vec<_>, _>>()?;
    match values[..] {
        [u, v] => Ok([u, v]),
        // By the standard v may be left out.
        [u] => Ok([u, 0.0]),
        _ => Err("vt holds no texture coordinates".to_owned()),
    }
}

/// The corners of a face.
struct Face {
    /// Indices of vertices, counted from 1.
    vertices: Vec<String>,
    /// Indices of texture coordinates, counted from 0, where a corner has any.
    texture: Vec<Option<u32>>,
}

fn face(rest: &str, counts: &Counts) -> Result<Face, String> {
    let corners: Vec<&str> = words(rest).collect();
    if corners.len() < 3 {
        return Err(format!("a face has at least 3 vertices, this one {}", corners.len()));
    }
    let kinds = [
        ("vertex", counts.vertices),
        ("texture coordinate", counts.texture_coordinates),
        ("normal", counts.normals),
    ];
    let mut vertices = Vec::with_capacity(corners.len());
    let mut texture = Vec::with_capacity(corners.len());
    for corner in corners {
        let parts: Vec<&str> = corner.split('/').collect();
        if parts.len() > 3 {
            return Err(format!("`{corner}` is not vertex/texture/normal"));
        }
        vertices.push(index(parts[0], kinds[0])?.to_string());
        let given = |part: usize| match parts.get(part) {
            None | Some(&"") => Ok(None),
            Some(word) => index(word, kinds[part]).map(Some),
        };
        texture.push(given(1)?.map(|index| (index - 1) as u32));
        given(2)?;
    }
    Ok(Face { vertices, texture })
}

/// An index, counted from 1; in the file it may count from the end as -1, -2, ...
fn index(word: &str, (kind, count): (&str, i64)) -> Result<i64, String> {
    let Ok(value) = word.parse::<i64>() else {
        return Err(format!("`{word}` is not the index of a {kind}"));
    };
    let resolved = if value < 0 { count.saturating_add(value).saturating_add(1) } else { value };
    if resolved < 1 || resolved > count {
        let problem =
            format!("{kind} {value} is out of range: {count} are defined before this line");
        return Err(problem);
    }
    Ok(resolved)
}
