//! Faces of an OBJ file.

use super::statements::words;

/// How many elements the file has defined so far.
#[derive(Default)]
pub(super) struct Counts {
    pub vertices: u32,
    pub texture_coordinates: u32,
    pub normals: u32,
}

/// The corners of a face.
#[derive(Default)]
pub(super) struct Face {
    /// Indices of vertices, counted from 0.
    pub vertices: Vec<u32>,
    /// For each corner the index of its texture coordinates, counted from 0, if it has any.
    pub texture: Vec<Option<u32>>,
}

impl Face {
    /// Reads what follows `f`: for each corner vertex, texture coordinates and normal. What stood
    /// here before is forgotten.
    pub fn read(&mut self, rest: &str, counts: &Counts) -> Result<(), String> {
        self.vertices.clear();
        self.texture.clear();
        let kinds = [
            ("vertex", counts.vertices),
            ("texture coordinate", counts.texture_coordinates),
            ("normal", counts.normals),
        ];
        for corner in words(rest) {
            if corner.split('/').count() > 3 {
                return Err(format!("`{corner}` is not vertex/texture/normal"));
            }
            let mut parts = corner.split('/');
            let mut indices = [None; 3];
            for (i, index) in indices.iter_mut().enumerate() {
                *index = match parts.next() {
                    // Only the vertex has to be there.
                    None | Some("") if i > 0 => None,
                    word => Some(resolved(word.unwrap_or(""), kinds[i])?),
                };
            }
            let [vertex, texture, _] = indices;
            self.vertices.extend(vertex);
            self.texture.push(texture);
        }
        match self.vertices.len() {
            0..3 => {
                let count = self.vertices.len();
                Err(format!("a face has at least 3 vertices, this one {count}"))
            }
            _ => Ok(()),
        }
    }
}

/// An index, counted from 0; in the file it counts from 1, or from the end as -1, -2, ...
fn resolved(word: &str, (kind, count): (&str, u32)) -> Result<u32, String> {
    let Ok(value) = word.parse::<i64>() else {
        return Err(format!("`{word}` is not the index of a {kind}"));
    };
    let index = if value < 0 { i64::from(count).checked_add(value) } else { value.checked_sub(1) };
    match index.and_then(|index| u32::try_from(index).ok()).filter(|&index| index < count) {
        Some(index) => Ok(index),
        None => {
            Err(format!("{kind} {value} is out of range: {count} are defined before this line"))
        }
    }
}
