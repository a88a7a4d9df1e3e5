//! Material libraries (MTL).

use std::path::{Path, PathBuf};

use glam::DVec3;

use super::default_material;
use super::prepare::{number, statements, words};
use crate::Error;
use crate::files::io::read_text;
use crate::kernels::material::Material;

/// The materials of the libraries that one `mtllib` at `place` names, relative to `folder`.
pub(super) fn load_libraries(
    names: &str,
    folder: &Path,
    place: &str,
) -> Result<Vec<(String, Material<f64>)>, Error> {
    // By the standard several names may follow; in practice one with spaces in it does.
    let whole = folder.join(names);
    let paths: Vec<PathBuf> = if whole.is_file() || names.is_empty() {
        vec![whole]
    } else {
        names.split_whitespace().map(|name| folder.join(name)).collect()
    };
    let mut materials = Vec::new();
    for path in paths {
        if !path.is_file() {
            let problem = format!("the material library {} is missing", path.display());
            return Err(Error::new(place, problem));
        }
        materials.extend(load_library(&path)?);
    }
    Ok(materials)
}

fn load_library(path: &Path) -> Result<Vec<(String, Material<f64>)>, Error> {
    let text = read_text(path)?;
    let materials = tobj::load_mtl_buf(&mut prepare(&text, path)?.as_bytes());
    let (materials, _) = materials.map_err(|error| Error::new(path.display(), error))?;
    let default = default_material();
    let convert = |material: tobj::Material| {
        let value = Material {
            ambient: default.ambient,
            diffuse: material.diffuse.map_or(default.diffuse, DVec3::from_array),
            specular: material.specular.map_or(default.specular, DVec3::from_array),
            exponent: material.shininess.unwrap_or(default.exponent),
            reflection: default.reflection,
        };
        (material.name, value)
    };
    Ok(materials.into_iter().map(convert).collect())
}

/// Checks a library and keeps what a material is made of; tobj would panic on a colour of one
/// number, which the standard allows for grey.
fn prepare(text: &str, path: &Path) -> Result<String, Error> {
    let mut prepared = String::new();
    let mut named = false;
    for statement in statements(text) {
        let refuse =
            |problem: String| Error::new(format!("{}:{}", path.display(), statement.line), problem);
        let keyword = statement.keyword;
        match keyword {
            "newmtl" if statement.rest.is_empty() => {
                return Err(refuse("newmtl names no material".to_owned()));
            }
            "newmtl" => {
                named = true;
                prepared.push_str(&format!("newmtl {}\n", statement.rest));
            }
            "Kd" | "Ks" | "Ns" if !named => {
                return Err(refuse(format!("{keyword} stands before the first newmtl")));
            }
            "Kd" | "Ks" => {
                let [r, g, b] = color(keyword, &statement.rest).map_err(refuse)?;
                prepared.push_str(&format!("{keyword} {r:?} {g:?} {b:?}\n"));
            }
            "Ns" => {
                let word = words(&statement.rest).next().unwrap_or("");
                let exponent = not_negative(keyword, word).map_err(refuse)?;
                prepared.push_str(&format!("Ns {exponent:?}\n"));
            }
            _ => {}
        }
    }
    Ok(prepared)
}

fn color(keyword: &str, rest: &str) -> Result<[f64; 3], String> {
    let values: Result<Vec<f64>, String> =
        words(rest).map(|word| not_negative(keyword, word)).collect();
    match values?[..] {
        [grey] => Ok([grey; 3]),
        [r, g, b] => Ok([r, g, b]),
        _ => Err(format!("{keyword} is a colour of 3 numbers")),
    }
}

fn not_negative(keyword: &str, word: &str) -> Result<f64, String> {
    match number(word).map_err(|problem| format!("{keyword}: {problem}"))? {
        value if value < 0.0 => Err(format!("{keyword} must not be negative, is {value}")),
        value => Ok(value),
    }
}
