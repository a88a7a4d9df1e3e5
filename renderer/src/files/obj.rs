//! Meshes: Wavefront OBJ and its material libraries (MTL).
//!
//! tobj reads the numbers, triangulates and gives each object its own vertices. What it would read
//! wrongly or in silence never reaches it: `prepare` checks a file line by line first and hands
//! over only plain vertices, faces and object names.

mod mtl;
mod prepare;
mod write;

#[cfg(test)]
mod tests;

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use glam::DVec3;

use super::io::read_text;
use crate::Error;
use crate::kernels::material::Material;
use crate::scene::Wrap;
use prepare::{Prepared, prepare};

pub use write::save_obj;

/// The name of the material of faces that no `usemtl` gives another one.
pub const DEFAULT_MATERIAL: &str = "default";

/// A grey, matt material: ambient 0, diffuse 0.7, specular 0, exponent 1, no mirror. Also what a material
/// library leaves open.
pub fn default_material() -> Material<f64> {
    Material {
        ambient: DVec3::ZERO,
        diffuse: DVec3::splat(0.7),
        specular: DVec3::ZERO,
        exponent: 1.0,
        reflection: DVec3::ZERO,
    }
}

/// What an OBJ file holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    /// Its objects, one mesh each; at least one.
    pub meshes: Vec<Mesh>,
    /// Its materials in the order of their first use.
    pub materials: Vec<ModelMaterial>,
}

/// A triangle mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    /// Its name, unique within its model.
    pub name: String,
    /// Its vertices, in the order in which its triangles first use them.
    pub vertices: Vec<[f64; 3]>,
    /// Three indices into `vertices` for each triangle.
    pub triangles: Vec<[u32; 3]>,
    /// For each triangle an index into the model's materials.
    pub materials: Vec<u32>,
    /// Its texture coordinates, in the order in which its triangles first use them.
    pub texture_coordinates: Vec<[f64; 2]>,
    /// For each triangle three indices into `texture_coordinates`, if it has any; empty if no
    /// triangle has.
    pub texture_triangles: Vec<Option<[u32; 3]>>,
}

/// A material of a model.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelMaterial {
    /// Its name, unique within its model.
    pub name: String,
    /// What the material libraries say of it; nothing if they do not define it.
    pub material: Option<Material<f64>>,
    /// The textures of its colours.
    pub maps: ModelMaps,
    /// The file and line of its first use.
    pub place: String,
}

/// The textures of a material's colours.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ModelMaps {
    /// That of `diffuse`.
    pub diffuse: Option<TextureSource>,
    /// That of `specular`.
    pub specular: Option<TextureSource>,
}

/// Where a texture is read from.
#[derive(Clone, Debug, PartialEq)]
pub struct TextureSource {
    /// The image file.
    pub path: PathBuf,
    /// How the texture goes on beyond its edges.
    pub wrap: Wrap,
    /// The file and line that name it.
    pub place: String,
}

/// Reads an OBJ file and the material libraries that it names, by paths relative to itself.
///
/// - Every object (`o`) is a mesh; in a file without objects every group (`g`) is. Unnamed ones take
///   the file's name; of equal names the second gets the suffix `_2`, the third `_3`.
/// - Meshes share no vertices; a vertex that no face uses is left out. Several materials within an
///   object leave it one mesh.
/// - Polygons become fans of triangles, as is right for convex ones. Normals, points and lines are
///   checked or skipped; the renderer has no use for them.
/// - `Kd`, `Ks` and `Ns` are the diffuse colour, the specular colour and the exponent; colours are
///   taken as linear. `Ka` is not read: it scales an ambient light, which files do not describe, and
///   exporters write 1 for it; read as radiance it would make every surface glow.
/// - `map_Kd` and `map_Ks` are the textures that multiply the diffuse and the specular colour, by
///   paths relative to the library; of their options `-clamp on` is taken. `illum 3` and `illum 5`
///   make `Ks` the reflection of a mirror, too.
/// - Faces before any `usemtl` wear [`DEFAULT_MATERIAL`].
///
/// # Errors
///
/// If a file cannot be read, a line is broken, a number is not finite, an index is out of range, or
/// there is no triangle. The message names file and line.
pub fn load_obj(path: &Path) -> Result<Model, Error> {
    let text = read_text(path)?;
    let stem = path.file_stem().map_or("mesh".into(), |stem| stem.to_string_lossy());
    let stem = stem.replace(char::is_control, "_");
    let prepared = prepare(&text, &path.display().to_string(), &stem)?;
    // tobj is about to need as much memory again.
    drop(text);

    // Colours matter only where a face wears them.
    let mut library = Vec::new();
    if prepared.materials.iter().any(|(name, _)| name != DEFAULT_MATERIAL) {
        let folder = path.parent().unwrap_or(Path::new(""));
        for (names, line) in &prepared.libraries {
            let place = format!("{}:{line}", path.display());
            library.extend(mtl::load_libraries(names, folder, &place)?);
        }
    }
    let materials = prepared.materials.iter().map(|(name, line)| {
        // As in a library, the last definition of a name holds.
        let defined = library.iter().rev().find(|defined| defined.name == *name);
        let fallback = (name == DEFAULT_MATERIAL).then(default_material);
        ModelMaterial {
            name: name.clone(),
            material: defined.map(|defined| defined.material).or(fallback),
            maps: defined.map(|defined| defined.maps.clone()).unwrap_or_default(),
            place: format!("{}:{line}", path.display()),
        }
    });
    let materials = materials.collect();
    Ok(Model { meshes: meshes(&prepared, path)?, materials })
}

/// Lets tobj read what [`prepare`] has made of a file.
fn meshes(prepared: &Prepared, path: &Path) -> Result<Vec<Mesh>, Error> {
    let options = tobj::LoadOptions { triangulate: true, ..Default::default() };
    let no_library = |_: &Path| Err(tobj::LoadError::OpenFileFailed);
    let (models, _) = tobj::load_obj_buf(&mut prepared.text.as_bytes(), &options, no_library)
        .map_err(|error| Error::new(path.display(), error))?;

    let mut meshes: Vec<Mesh> = Vec::new();
    let mut materials = prepared.triangle_materials.iter().copied();
    let mut textures = prepared.texture_triangles.iter().copied();
    for tobj::Model { mesh, name } in models {
        let triangles = mesh.indices.as_chunks().0.to_vec();
        if triangles.is_empty() {
            continue;
        }
        let (texture_coordinates, texture_triangles) = textures_of_mesh(
            textures.by_ref().take(triangles.len()),
            &prepared.texture_coordinates,
        );
        meshes.push(Mesh {
            texture_coordinates,
            texture_triangles,
            name: unique(name, |name| meshes.iter().any(|mesh| mesh.name == name)),
            vertices: mesh.positions.as_chunks().0.to_vec(),
            // tobj keeps the order of the faces, so each mesh takes the next ones.
            materials: materials.by_ref().take(triangles.len()).collect(),
            triangles,
        });
    }
    if meshes.is_empty() {
        return Err(Error::new(path.display(), "holds no triangles; a mesh needs faces (`f`)"));
    }
    Ok(meshes)
}

/// The texture coordinates that the triangles of a mesh use, and the triangles by index into them.
fn textures_of_mesh(
    triangles: impl Iterator<Item = Option<[u32; 3]>>,
    all: &[[f64; 2]],
) -> (Vec<[f64; 2]>, Vec<Option<[u32; 3]>>) {
    let (mut coordinates, mut places) = (Vec::new(), HashMap::new());
    let mut place = |corner: u32| {
        *places.entry(corner).or_insert_with(|| {
            coordinates.push(all[corner as usize]);
            (coordinates.len() - 1) as u32
        })
    };
    let placed: Vec<_> = triangles.map(|corners| corners.map(|c| c.map(&mut place))).collect();
    let placed = if coordinates.is_empty() { Vec::new() } else { placed };
    (coordinates, placed)
}

/// `name`, or the first of `name_2`, `name_3`, ... that is not taken.
pub(super) fn unique(name: String, taken: impl Fn(&str) -> bool) -> String {
    if !taken(&name) {
        return name;
    }
    let mut number = 2;
    loop {
        let numbered = format!("{name}_{number}");
        if !taken(&numbered) {
            return numbered;
        }
        number += 1;
    }
}
