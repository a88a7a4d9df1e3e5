//! Meshes and scenes: glTF 2.0, `.gltf` (JSON) and `.glb` (binary).
//!
//! serde_json reads the document; what is a few structs and slices of bytes beyond that is our own.
//! The crate `gltf` (1.4.1, of 2024) was turned down: its validation tells lists of internal paths
//! where a line for people is needed, and it does not check that accessors stay within their
//! buffers.

mod accessor;
mod buffers;
mod document;
mod lights;
mod materials;
mod nodes;
mod primitive;
mod write;

#[cfg(test)]
mod tests;
#[cfg(test)]
mod texture_tests;

use std::path::Path;

use renderer_core::Error;
use renderer_core::scene::{Camera, Light, Mesh};

use super::meshes::FileNormals;
use super::meshes::Model;
use super::names::Names;
use super::names::{clean_name, file_stem};
use crate::disk::read;
use crate::warning::Warnings;
use buffers::Buffers;
use document::Document;
use materials::Materials;
use nodes::PlacedNode;
pub(crate) use write::save_glb;

/// What a glTF file holds.
#[derive(Clone, Debug, PartialEq)]
pub struct GltfFile {
    /// The meshes of the file, one for each node that shows one, placed in the world.
    pub model: Model,
    /// The first camera of the scene, and the width of its image over the height, if it says.
    pub camera: Option<(Camera<f64>, Option<f64>)>,
    /// The names and values of its lights.
    pub lights: Vec<(String, Light<f64>)>,
}

/// Reads a glTF 2.0 file, with its buffers: embedded, or in files relative to it. Of several scenes
/// it is the default one, or the first.
///
/// - Every node with a mesh is a mesh, named after the node (or the mesh), placed by the node and those
///   above it.
/// - Normals are read by [`load_mesh_with`](super::load_mesh_with) alone.
/// - The base colour of a material is the diffuse albedo, and what it emits, times
///   `KHR_materials_emissive_strength`, the emission, each with its texture: PNG or JPEG, embedded or in files; any set of texture coordinates, moved by
///   `KHR_texture_transform`; wrapped as the sampler says, along v as along u. An image whose file is
///   missing is warned of, and counts as white. Primitives without a material have
///   [`DEFAULT_MATERIAL`](super::DEFAULT_MATERIAL).
/// - The alpha of a base colour, with that of its texture, is the opacity where the alpha mode is `BLEND`;
///   where that is `MASK`, it is 1 from the cutoff on and 0 below, by texel. Where it is `OPAQUE`, alpha is
///   left out, that of a texture with a warning.
/// - What a material is with its facets is [`ModelMaterial::full`](super::ModelMaterial::full): metallic part
///   and roughness with their texture, the index of `KHR_materials_ior`; it is glass where
///   `KHR_materials_transmission` lets more than half through and it is smooth.
/// - Other textures, colours of vertices, points and lines, skins, morph
///   targets, animations and extensions that are not required are left out with a warning.
/// - The first camera counts; it has to be a perspective one.
/// - A material of `KHR_materials_unlit` emits its base colour and reflects nothing.
/// - Lights are those of `KHR_lights_punctual`, without a range. Candela and lux are taken as watts per
///   steradian and per square metre.
///
/// # Errors
///
/// If a file cannot be read, is cut short, an index or an offset is out of range, a number is not
/// finite, an extension is required that is not read here, or there is no triangle. The message
/// names the file and the part of the document.
pub fn load_gltf(path: &Path) -> Result<GltfFile, Error> {
    read_gltf(path, FileNormals::Ignore)
}

/// [`load_gltf`], with the normals of vertices if they are wanted.
pub(crate) fn read_gltf(path: &Path, normals: FileNormals) -> Result<GltfFile, Error> {
    let place = path.display().to_string();
    let refuse = |problem: String| Error::new(&place, problem);
    let bytes = read(path)?;
    let (json, binary) = buffers::split(&bytes).map_err(refuse)?;
    let document = Document::parse(json).map_err(refuse)?;
    let folder = path.parent().unwrap_or(Path::new(""));
    let buffers = Buffers::load(&document, binary, folder, &place)?;
    let nodes = nodes::placed(&document).map_err(refuse)?;
    let mut warnings = Warnings::default();
    for extension in document.unread_extensions() {
        let problem = format!("the extension {extension} is left out");
        warnings.add(&problem, &place, &problem);
    }
    if !document.animations.is_empty() {
        warnings.add("animations", &place, "animations are left out");
    }
    let mut materials = Materials::load(&document, &buffers, folder, &place, &mut warnings)?;
    let meshes = meshes(&document, &buffers, &mut materials, &nodes, path, normals, &mut warnings)?;
    if meshes.is_empty() {
        return Err(Error::new(place, "holds no triangles"));
    }
    Ok(GltfFile {
        model: Model { meshes, materials: materials.used, warnings: warnings.finish() },
        camera: lights::camera(&document, &nodes).map_err(refuse)?,
        lights: lights::lights(&document, &nodes).map_err(refuse)?,
    })
}

/// The meshes of all nodes.
fn meshes(
    document: &Document,
    buffers: &Buffers,
    materials: &mut Materials,
    nodes: &[PlacedNode<'_>],
    path: &Path,
    normals: FileNormals,
    warnings: &mut Warnings,
) -> Result<Vec<Mesh>, Error> {
    let file = path.display().to_string();
    let (mut meshes, mut names) = (Vec::new(), Names::default());
    for PlacedNode { node, to_world, .. } in nodes {
        let Some(index) = node.mesh else { continue };
        let mesh = document::get(&document.meshes, index, "meshes")
            .map_err(|problem| Error::new(&file, problem))?;
        if node.skin.is_some() {
            warnings.add("skins", &file, "skins are left out");
        }
        let mut parts = Vec::new();
        for (i, primitive) in mesh.primitives.iter().enumerate() {
            let place = format!("{file}: meshes[{index}].primitives[{i}]");
            warn_of_left_out(primitive, &place, warnings);
            let part = primitive::load(document, buffers, materials, primitive, normals)
                .map_err(|problem| Error::new(&place, problem))?;
            parts.push(part);
        }
        let given = [node.name.as_deref(), mesh.name.as_deref()];
        let name = given.into_iter().flatten().map(clean_name).find(|name| !name.is_empty());
        let name = name.unwrap_or_else(|| file_stem(path));
        let mesh = primitive::join(parts, name, *to_world, materials);
        meshes.extend(mesh.map(|mesh| Mesh { name: names.take(mesh.name), ..mesh }));
    }
    Ok(meshes)
}

fn warn_of_left_out(primitive: &document::Primitive, place: &str, warnings: &mut Warnings) {
    let left_out = [
        (primitive.mode < 4, "points and lines are left out"),
        (primitive.targets.is_some(), "morph targets are left out"),
        (primitive.attributes.contains_key("COLOR_0"), "the colours of vertices are left out"),
    ];
    for (_, problem) in left_out.into_iter().filter(|(is_given, _)| *is_given) {
        warnings.add(problem, place, problem);
    }
}
