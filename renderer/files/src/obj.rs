//! Meshes: Wavefront OBJ and its material libraries (MTL).
//!
//! `tobj` reads the numbers, resolves the indices and gives each object its own vertices. What it
//! would read wrongly or in silence never reaches it: `prepare` checks a file statement by statement,
//! so that errors name lines, and hands on plain vertices, texture coordinates, normals, faces and
//! object names. Alone tobj 4.0 would overflow on an index before the first, draw lines as triangles, split
//! objects by material, make up the texture coordinates and normals of corners that have none, and refuse colours
//! of one or two numbers. It hands faces over whole: cut by tobj every one would be a fan, which is
//! wrong where a polygon is not convex. A parser of our own was turned down: it saves reading numbers
//! twice, at the price of a second implementation of a format that a library reads.
//!
//! Material libraries are read without tobj: it panics on a `Kd` of one number, which is grey, tells no
//! lines, and keeps what it does not know without order. To warn of what is left out and to refuse
//! negative colours, every statement would have to be read beside it.

mod chunks;
mod face;
mod map;
mod meshes;
mod mtl;
mod prepare;
mod statements;
mod write;
mod write_objects;

#[cfg(test)]
mod mtl_tests;
#[cfg(test)]
mod tests;

use std::path::Path;

use renderer_core::Error;
use renderer_core::scene::Material;

use super::meshes::{DEFAULT_MATERIAL, Model, ModelMaps, ModelMaterial};
use super::meshes::{FileNormals, FileObjects};
use super::names::file_stem;
use crate::Warning;
use crate::disk::read_text;
use crate::warning::Warnings;
use meshes::meshes;
use mtl::Library;
use prepare::prepare;

pub use write::save_obj;
pub(crate) use write_objects::save_objects;

/// Reads an OBJ file and the material libraries that it names, by paths relative to itself.
///
/// - Every object (`o`) is a mesh; in a file without objects every group (`g`) is. Unnamed ones take
///   the file's name; of equal names the second gets the suffix `_2`, the third `_3`.
/// - Meshes share no vertices; a vertex that no face uses is left out. Several materials within an
///   object leave it one mesh.
/// - Polygons are cut into triangles, concave ones too. Normals (`vn`) are read by
///   [`load_mesh_with`](super::load_mesh_with) alone; smoothing groups are not used.
/// - Faces before any `usemtl` have [`DEFAULT_MATERIAL`].
///
/// Of a material library:
///
/// - `Kd`, `Ks` and `Ns` are the diffuse albedo, the specular albedo and the exponent. `Ke`, the
///   radiance that a surface emits, is the emission. Colours are taken as linear.
/// - `map_Kd`, `map_Ks` and `map_Ke` are the textures that multiply these colours, by paths relative
///   to the library; `map_d` is that of the opacity: the alpha of its image, or, where that has none, its
///   brightness as it is stored; `norm` and `map_Kn` are normal maps. A colour that has a texture but no statement is white. Of their options `-s`
///   and `-o` scale and shift the texture coordinates (`uv s + o`, the same for all textures of a
///   material: those of the first of `map_Kd`, `map_Ke`, `map_Ks`, `map_d`, `norm`), and `-clamp on` is taken.
/// - `illum 0` and `illum 1` have no highlight; `illum 3`, `5` and `8` make `Ks` the mirror
///   reflectance, too.
/// - `Ka` and `map_Ka` are left out with a warning: they scale an ambient light, which files do not
///   describe, and exporters write 1 for `Ka` whatever the scene; read as radiance it would make
///   every surface glow white. `emission` and `emission_texture` of a scene file say what is meant.
/// - A texture whose file is missing is warned of, and counts as white.
/// - `d` is the opacity, or, where there is none, 1 - `Tr`; a mirror stays opaque, with a warning.
/// - `Pr` and `Pm` (roughness and metallic part) with `Ni`, and the glass of `illum 4`, `6`, `7` and `9` with
///   `Ni` and `Tf`, say what the material is where light takes all paths ([`ModelMaterial::full`]).
/// - Every other statement is left out, with a warning if it would change the image: opacity that
///   has a colour (`Tf`), refraction (`Ni`) elsewhere, bumps (`map_Bump`, whose heights are no normals), `refl` and what is not known at all.
///
/// # Errors
///
/// If a file cannot be read, a line is broken, a number is not finite, an index is out of range, or
/// there is no triangle. The message names file and line.
///
/// A library that is missing is no error, nor is a material that none defines: files often come
/// without their library, and their shapes are worth seeing. Such a material is left to a scene file,
/// with a warning where that does not define it either ([`ModelMaterial::material`]).
pub fn load_obj(path: &Path) -> Result<Model, Error> {
    read_obj(path, FileNormals::Ignore, FileObjects::Apart)
}

/// [`load_obj`], with the normals of corners (`vn`) if they are wanted, and with the objects as meshes or as one.
pub(crate) fn read_obj(
    path: &Path,
    normals: FileNormals,
    objects: FileObjects,
) -> Result<Model, Error> {
    let text = read_text(path)?;
    let file = path.display().to_string();
    let mut warnings = Warnings::default();
    let prepared = prepare(&text, &file, &file_stem(path), (normals, objects), &mut warnings)?;
    // tobj is about to need as much memory again.
    drop(text);

    let mut warnings = warnings.finish();
    // Colours matter only where a face has them.
    let mut library = Library::default();
    if prepared.materials.iter().any(|(name, _)| name != DEFAULT_MATERIAL) {
        let folder = path.parent().unwrap_or(Path::new(""));
        for (names, line) in &prepared.libraries {
            library.add(names, folder, &format!("{file}:{line}"))?;
        }
    }
    warnings.append(&mut library.warnings);
    let material = |(name, line): &(String, usize)| {
        // As in a library, the last definition of a name holds.
        let defined = library.materials.iter().rev().find(|defined| defined.name == *name);
        let undefined = || match &library.missing {
            _ if name == DEFAULT_MATERIAL => Ok(Material::default().into()),
            Some(missing) => Err(missing.clone()),
            None => {
                let problem = format!("no library defines the material `{name}`; it is shown grey");
                Err(Warning::new(format_args!("{file}:{line}"), problem))
            }
        };
        ModelMaterial {
            name: name.clone(),
            material: defined.map_or_else(undefined, |defined| Ok(defined.material.clone())),
            full: defined.and_then(|defined| defined.full.clone()),
            maps: defined.map_or_else(ModelMaps::default, |defined| defined.maps.clone()),
        }
    };
    let materials = prepared.materials.iter().map(material).collect();
    let meshes = meshes(prepared, &file)?;
    if meshes.is_empty() {
        return Err(Error::new(file, "holds no triangles; a mesh needs faces (`f`)"));
    }
    Ok(Model { meshes, materials, warnings })
}
