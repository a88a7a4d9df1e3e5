//! Material libraries (MTL).

use std::path::{Path, PathBuf};

use glam::DVec3;

use super::prepare::{number, statements, words};
use super::{ModelMaps, TextureSource, default_material};
use crate::Error;
use crate::files::io::read_text;
use crate::kernels::material::Material;
use crate::scene::Wrap;

/// A material of a library.
pub(super) struct LibraryMaterial {
    pub name: String,
    pub material: Material<f64>,
    pub maps: ModelMaps,
}

/// The materials of the libraries that one `mtllib` at `place` names, relative to `folder`.
pub(super) fn load_libraries(
    names: &str,
    folder: &Path,
    place: &str,
) -> Result<Vec<LibraryMaterial>, Error> {
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

fn load_library(path: &Path) -> Result<Vec<LibraryMaterial>, Error> {
    let text = read_text(path)?;
    let Prepared { text, extras } = prepare(&text, path)?;
    let materials = tobj::load_mtl_buf(&mut text.as_bytes());
    let (materials, _) = materials.map_err(|error| Error::new(path.display(), error))?;
    let default = default_material();
    // tobj keeps the order of the materials.
    let convert = |(material, Extra { mirror, maps }): (tobj::Material, Extra)| {
        let specular = material.specular.map_or(default.specular, DVec3::from_array);
        let value = Material {
            ambient: default.ambient,
            diffuse: material.diffuse.map_or(default.diffuse, DVec3::from_array),
            specular,
            exponent: material.shininess.unwrap_or(default.exponent),
            reflection: if mirror { specular } else { default.reflection },
        };
        LibraryMaterial { name: material.name, material: value, maps }
    };
    Ok(materials.into_iter().zip(extras).map(convert).collect())
}

/// Checks a library and keeps what a material is made of; tobj would panic on a colour of one
/// number, which the standard allows for grey.
fn prepare(text: &str, path: &Path) -> Result<Prepared, Error> {
    let mut prepared = String::new();
    let mut extras: Vec<Extra> = Vec::new();
    let folder = path.parent().unwrap_or(Path::new(""));
    for statement in statements(text) {
        let refuse =
            |problem: String| Error::new(format!("{}:{}", path.display(), statement.line), problem);
        let keyword = statement.keyword;
        match keyword {
            "newmtl" if statement.rest.is_empty() => {
                return Err(refuse("newmtl names no material".to_owned()));
            }
            "newmtl" => {
                extras.push(Extra::default());
                prepared.push_str(&format!("newmtl {}\n", statement.rest));
            }
            "Kd" | "Ks" | "Ns" | "illum" | "map_Kd" | "map_Ks" if extras.is_empty() => {
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
            "illum" | "map_Kd" | "map_Ks" => {
                let Some(extra) = extras.last_mut() else { continue };
                let place = format!("{}:{}", path.display(), statement.line);
                let map = || texture(keyword, &statement.rest, folder, place);
                match keyword {
                    "illum" => {
                        let model = words(&statement.rest).next().unwrap_or("");
                        extra.mirror = matches!(model, "3" | "5");
                    }
                    "map_Kd" => extra.maps.diffuse = Some(map().map_err(refuse)?),
                    _ => extra.maps.specular = Some(map().map_err(refuse)?),
                }
            }
            _ => {}
        }
    }
    Ok(Prepared { text: prepared, extras })
}

/// A library, checked.
struct Prepared {
    /// For tobj.
    text: String,
    /// What tobj does not read, by material.
    extras: Vec<Extra>,
}

/// What a material is made of beside its colours.
#[derive(Default)]
struct Extra {
    /// Whether `Ks` is the reflection of a mirror.
    mirror: bool,
    maps: ModelMaps,
}

/// The options of a texture statement, and how many words follow each at most; numbers may be fewer.
const OPTIONS: [(&str, usize); 13] = [
    ("-blendu", 1),
    ("-blendv", 1),
    ("-boost", 1),
    ("-bm", 1),
    ("-cc", 1),
    ("-clamp", 1),
    ("-imfchan", 1),
    ("-mm", 2),
    ("-o", 3),
    ("-s", 3),
    ("-t", 3),
    ("-texres", 1),
    ("-type", 1),
];

/// The texture that a statement names: options, then the path, which may hold spaces.
fn texture(
    keyword: &str,
    rest: &str,
    folder: &Path,
    place: String,
) -> Result<TextureSource, String> {
    let mut rest = rest.trim();
    let mut wrap = Wrap::Repeat;
    while let Some(&(option, most)) =
        OPTIONS.iter().find(|(option, _)| rest.split_whitespace().next() == Some(option))
    {
        rest = rest[option.len()..].trim_start();
        let three = most == 3;
        for _ in 0..most {
            let (word, others) = rest.split_once(char::is_whitespace).unwrap_or((rest, ""));
            // Of three numbers the last two may be left out.
            if three && word.parse::<f64>().is_err() {
                break;
            }
            if option == "-clamp" && word == "on" {
                wrap = Wrap::Clamp;
            }
            rest = others.trim_start();
        }
    }
    if rest.is_empty() {
        return Err(format!("{keyword} names no image"));
    }
    // Exporters for Windows write its separators.
    let path = folder.join(rest.replace('\\', "/"));
    Ok(TextureSource { path, wrap, place })
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
