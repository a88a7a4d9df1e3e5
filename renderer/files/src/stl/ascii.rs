//! ASCII STL, line by line.

use renderer_core::Error;

use super::{Builder, Mesh};
use crate::names::{Names, clean_name};

/// The solids of a file that have triangles.
pub(super) fn meshes(bytes: &[u8], file: &str, stem: &str) -> Result<Vec<Mesh>, Error> {
    let text = String::from_utf8_lossy(bytes);
    let text = text.strip_prefix('\u{feff}').unwrap_or(&text);
    let (mut meshes, mut names) = (Vec::new(), Names::default());
    let mut builder = Builder::default();
    let mut name = String::new();
    let mut facet: Option<Vec<[f64; 3]>> = None;
    let mut last_line = 0;
    for (index, line) in text.lines().enumerate() {
        last_line = index + 1;
        let refuse = |problem: String| Error::new(format!("{file}:{last_line}"), problem);
        let mut words = line.split_whitespace();
        let Some(keyword) = words.next() else { continue };
        match (keyword.to_ascii_lowercase().as_str(), &mut facet) {
            ("solid", None) => {
                meshes.extend(finish(std::mem::take(&mut builder), &name, stem, &mut names));
                name = clean_name(line.trim_start()[keyword.len()..].trim());
            }
            ("endsolid", None) => {}
            ("facet", None) => facet = Some(Vec::with_capacity(3)),
            ("outer" | "endloop", Some(_)) => {}
            ("vertex", Some(corners)) => corners.push(vertex(words).map_err(refuse)?),
            ("endfacet", Some(corners)) => {
                let corners: [[f64; 3]; 3] = corners.as_slice().try_into().map_err(|_| {
                    refuse(format!("this facet has {} vertices; it needs 3", corners.len()))
                })?;
                builder.push(corners);
                facet = None;
            }
            (word @ ("solid" | "endsolid" | "facet"), Some(_)) => {
                return Err(refuse(format!("`{word}` stands within a facet; endfacet is missing")));
            }
            (word @ ("outer" | "endloop" | "vertex" | "endfacet"), None) => {
                return Err(refuse(format!("`{word}` stands outside of a facet")));
            }
            (word, _) => return Err(refuse(format!("`{word}` is no statement of STL"))),
        }
    }
    if facet.is_some() {
        return Err(Error::new(format!("{file}:{last_line}"), "ends within a facet"));
    }
    meshes.extend(finish(builder, &name, stem, &mut names));
    Ok(meshes)
}

/// The solid `name`, if it has triangles.
fn finish(builder: Builder, name: &str, stem: &str, names: &mut Names) -> Option<Mesh> {
    let name = if name.is_empty() { stem } else { name };
    (!builder.is_empty()).then(|| builder.finish(names.take(name.to_owned())))
}

fn vertex<'a>(words: impl Iterator<Item = &'a str>) -> Result<[f64; 3], String> {
    let words: Vec<&str> = words.collect();
    let words: [&str; 3] = words
        .as_slice()
        .try_into()
        .map_err(|_| format!("a vertex is 3 numbers, here are {}", words.len()))?;
    let mut corner = [0.0; 3];
    for (value, word) in corner.iter_mut().zip(words) {
        *value = word.parse::<f64>().map_err(|_| format!("`{word}` is not a number"))?;
        if !value.is_finite() {
            return Err(format!("{word} is not a finite number"));
        }
    }
    Ok(corner)
}
